#include "surrogate/said.hpp"
#include "surrogate/tables.hpp"

#include <algorithm>
#include <numeric>

namespace platen::surrogate {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// A layer with the numbers that it was made of, and where each of the materials asked for stands in them.
struct Term {
  const Layer& layer;
  Tables tables;
  std::vector<std::size_t> rows;
  bool of_change = false; ///< from coarse to fine, which scatters more for some materials than for others
};

/// As cross(), but with components and processes made without a tenth of the rows at a time.
Crossed cross_anew(const Table& table, const Inputs& inputs) {
  constexpr std::size_t parts = 10;
  Crossed crossed{Table(table.size()), Table(table.size())};
  for (std::size_t part = 0; part < parts; ++part) {
    Table others;
    Inputs where{inputs.dimensions, {}};
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (i % parts == part) continue;
      others.push_back(table[i]);
      where.values.insert(where.values.end(), inputs.row(i).begin(), inputs.row(i).end());
    }
    auto [components, scores] = reduce(others);
    for (const auto& score : scores) components.processes.push_back(fit_process(where, score));
    const Columns columns = where;
    for (std::size_t i = part; i < table.size(); i += parts) {
      crossed.mean[i] = values_at(components, columns, inputs.row(i));
      crossed.variance[i] = variances_at(components, columns, inputs.row(i));
    }
  }
  return crossed;
}

/// Adds what the terms say of each material when it is left out of them. The last term is the finest layer.
void add_left_out(std::vector<Said>& said, const std::vector<Term>& terms, const std::vector<double>& knots,
                  Left left) {
  for (const auto& [layer, tables, rows, of_change] : terms) {
    const bool anew = left == Left::anew && &layer == &terms.back().layer;
    const Crossed F = anew ? cross_anew(tables.force, layer.inputs)
                           : cross(layer.force, tables.force, layer.inputs),
                  a = cross(layer.radius, tables.radius, layer.inputs),
                  work = cross(layer.work, tables.work, layer.inputs),
                  exponent = cross(layer.exponent, tables.exponent, layer.inputs);
    for (std::size_t i = 0; i < said.size(); ++i) {
      Said& one = said[i];
      if (of_change) one.scatter = scatter_of(knots, one.F);
      add(one.F, F.mean[rows[i]], one.scatter);
      add(one.F_variance, F.variance[rows[i]], one.scatter * one.scatter);
      add(one.a, a.mean[rows[i]]);
      add(one.work, work.mean[rows[i]], one.scatter);
      add(one.exponent, exponent.mean[rows[i]]);
    }
  }
}

std::vector<std::size_t> numbered(std::size_t count) {
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

/// The terms of a surrogate without a guide; `fine`: the materials, numbers in the fine pool.
std::vector<Term> terms_of(const Surrogate& s, const Pools& pools, std::vector<std::size_t>& fine) {
  if (!pools.coarse) {
    fine = numbered(pools.fine.runs.size());
    return {{s.layers[0], tables_of(pools.fine), fine}};
  }
  const auto both = in_both(pools.fine, *pools.coarse);
  std::vector<std::size_t> coarse;
  for (const auto& one : both) fine.push_back(one.fine), coarse.push_back(one.coarse);
  return {{s.layers[0], tables_of(*pools.coarse), coarse},
          {s.layers[1], change(tables_of(pools.fine), tables_of(*pools.coarse), both, s.knots),
           numbered(both.size()), true}};
}

std::vector<Errors> errors_of(const Pools& pools, const std::vector<std::size_t>& fine,
                              const std::vector<Said>& said) {
  std::vector<Errors> errors;
  for (std::size_t i = 0; i < fine.size(); ++i)
    errors.push_back(errors_of(pools.fine, pools.fine.runs[fine[i]], said[i]));
  return errors;
}

} // namespace

Quantiles quantiles(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1)};
}

std::vector<Said> said_left_out(const Surrogate& s, const Pools& pools, std::vector<std::size_t>* which,
                                Left left) {
  std::vector<std::size_t> fine;
  const auto terms = terms_of(s, pools, fine);
  std::vector<Said> said(fine.size());
  add_left_out(said, terms, s.knots, left);
  if (which) *which = std::move(fine);
  return said;
}

std::vector<Errors> leave_out(const Surrogate& s, const Pools& pools, Left left) {
  std::vector<std::size_t> fine;
  const auto said = said_left_out(s, pools, &fine, left);
  return errors_of(pools, fine, said);
}

std::vector<Errors> leave_out_guided(const Surrogate& s, const Pools& pools, Left left) {
  std::vector<std::size_t> fine;
  const auto terms = terms_of(s, pools, fine);
  const Tables& coarse = terms[0].tables;
  std::vector<Said> said;
  for (const auto i : terms[0].rows)
    said.push_back({coarse.force[i], {}, coarse.radius[i], coarse.work[i], coarse.exponent[i]});
  add_left_out(said, {terms[1]}, s.knots, left);
  return errors_of(pools, fine, said);
}

std::vector<Errors> errors_beside(const Surrogate& s, const PoolData& data, bool guided) {
  std::vector<Errors> errors;
  for (const auto& run : data.runs) {
    std::optional<CoarsePress> guide;
    if (guided) guide = press_guide(s, run.material);
    errors.push_back(errors_of(data, run, said_of(s, run.description, guide ? &*guide : nullptr)));
  }
  return errors;
}

double band_of(const std::vector<Errors>& errors) {
  std::vector<double> standardised;
  for (const auto& one : errors)
    if (!one.locks) standardised.insert(standardised.end(), one.standardised.begin(), one.standardised.end());
  return quantile(standardised, 0.9);
}

LeaveOneOut summary_of(const std::vector<Errors>& errors, double band) {
  std::vector<double> force, radius, work, residual;
  LeaveOneOut summary;
  double inside = 0, points = 0;
  for (const auto& one : errors) {
    ++summary.materials;
    summary.locked += one.locks;
    if (one.locks) continue;
    force.push_back(one.force);
    radius.push_back(one.radius);
    work.insert(work.end(), one.work.begin(), one.work.end());
    residual.insert(residual.end(), one.residual.begin(), one.residual.end());
    for (const double z : one.standardised) inside += z <= band, points += 1;
  }
  summary.force = quantiles(force);
  summary.radius = quantiles(radius);
  summary.work = quantiles(work);
  summary.residual = quantiles(residual);
  summary.coverage = points > 0 ? inside / points : 0;
  return summary;
}

} // namespace platen::surrogate
