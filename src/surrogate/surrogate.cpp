#include "surrogate/surrogate.hpp"

#include "core/error.hpp"
#include "fit/samples.hpp"
#include "press/press.hpp"
#include "study/grid.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double negligible = 5e-4; ///< of a logarithm: what the components may leave out, root mean square
constexpr std::size_t most_components = 10;

/// How far metals of the same E/((1 - nu^2) sigma_y) differ in force by their Poisson's ratios, one standard
/// deviation: 0.6 % for 0.2, 2.1 % for 0, where 0.3 is predicted (catalogue/pools/von-mises-nu).
constexpr double per_nu = 0.07;

/// Rows: runs.
using Table = std::vector<std::vector<double>>;

/// Scores of each run (components x runs).
struct Reduced {
  Components components;
  Table scores;
};

Reduced reduce(const Table& table) {
  if (table[0].empty()) return {};
  const auto n = static_cast<Eigen::Index>(table.size()), m = static_cast<Eigen::Index>(table[0].size());
  MatrixXd Y(n, m);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      Y(i, j) = table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const VectorXd mean = Y.colwise().mean();
  Y.rowwise() -= mean.transpose();
  const Eigen::BDCSVD<MatrixXd> svd(Y, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Reduced reduced;
  reduced.components.mean.assign(mean.data(), mean.data() + m);
  MatrixXd rest = Y;
  const auto rms = [&] { return std::sqrt(rest.squaredNorm() / static_cast<double>(n * m)); };
  for (Eigen::Index c = 0;
       c < std::min(n, m) && reduced.scores.size() < most_components && rms() > negligible; ++c) {
    VectorXd direction = svd.matrixV().col(c);
    if (direction.sum() < 0) direction = -direction; // signs are the decomposition's whim
    const VectorXd score = Y * direction;
    rest -= score * direction.transpose();
    reduced.components.basis.emplace_back(direction.data(), direction.data() + m);
    reduced.scores.emplace_back(score.data(), score.data() + n);
  }
  for (Eigen::Index j = 0; j < m; ++j)
    reduced.components.rest.push_back(std::sqrt(rest.col(j).squaredNorm() / static_cast<double>(n)));
  return reduced;
}

/// What the components say of each run when it is left out (runs x values), and the variance of that.
struct Crossed {
  Table mean, variance;
};

Crossed cross(const Components& components, const Table& table, const Inputs& inputs) {
  const std::size_t n = inputs.size(), m = components.mean.size();
  Crossed crossed{Table(n, components.mean), Table(n, std::vector<double>(m))};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) crossed.variance[i][j] = components.rest[j] * components.rest[j];
  for (std::size_t c = 0; c < components.basis.size(); ++c) {
    const auto& basis = components.basis[c];
    std::vector<double> scores(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) scores[i] += basis[j] * (table[i][j] - components.mean[j]);
    const auto out = left_out(components.processes[c], inputs, scores);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        crossed.mean[i][j] += basis[j] * out.mean[i];
        crossed.variance[i][j] += basis[j] * basis[j] * out.variance[i];
      }
  }
  return crossed;
}

/// Of each run, one list after the other.
Table logarithms(const PoolData& data, std::initializer_list<std::vector<double> Pressed::*> lists) {
  Table table;
  for (const auto& run : data.runs) {
    table.emplace_back();
    for (const auto list : lists)
      for (const double value : run.*list) table.back().push_back(std::log(value));
  }
  return table;
}
struct Tables {
  Table force, radius, unloading;
};
Tables tables_of(const PoolData& data) {
  return {logarithms(data, {&Pressed::F_bar}), logarithms(data, {&Pressed::a_bar}),
          logarithms(data, {&Pressed::alpha, &Pressed::beta})};
}

/// A fine run and the coarse one of the same material.
struct Both {
  std::size_t fine, coarse;
};

std::vector<Both> in_both(const PoolData& fine, const PoolData& coarse) {
  if (fine.engine != coarse.engine || fine.knots != coarse.knots ||
      (!coarse.unload_delta_bar.empty() && fine.unload_delta_bar != coarse.unload_delta_bar) ||
      fine.runs.front().description.model != coarse.runs.front().description.model)
    throw core::InvalidInput(
        fmt::format("pools {} and {} differ in model, engine, or the overlaps at which their curves "
                    "are given: one cannot be the coarse presses of the other",
                    fine.name, coarse.name));
  const auto same = [](const Pressed& one, const Pressed& other) {
    for (std::size_t k = 0; k < one.description.numbers.size(); ++k)
      if (one.description.numbers[k].value != other.description.numbers[k].value) return false;
    return true;
  };
  std::vector<Both> both;
  for (std::size_t i = 0; i < fine.runs.size(); ++i)
    for (std::size_t j = 0; j < coarse.runs.size(); ++j)
      if (same(fine.runs[i], coarse.runs[j])) both.push_back({i, j});
  constexpr std::size_t fewest = 5;
  if (both.size() < fewest)
    throw core::InvalidInput(
        fmt::format("{} materials were pressed in both pools, {} and {}; {} are wanted at least", both.size(),
                    fine.name, coarse.name, fewest));
  return both;
}

/// What the logarithms change from coarse to fine.
Tables change(const Tables& fine, const Tables& coarse, const std::vector<Both>& both) {
  Tables changes;
  for (const auto table : {&Tables::force, &Tables::radius, &Tables::unloading})
    for (const auto [i, j] : both) {
      auto& row = (changes.*table).emplace_back((fine.*table)[i]);
      row.resize((coarse.*table)[j].size()); // a guide has no unloadings
      for (std::size_t k = 0; k < row.size(); ++k) row[k] -= (coarse.*table)[j][k];
    }
  return changes;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}
Quantiles quantiles(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1)};
}

std::vector<double> exponentials(const std::vector<double>& values, std::size_t from, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = from; i < from + count; ++i) result.push_back(std::exp(values[i]));
  return result;
}

double relative_l2(const std::vector<double>& x, const std::vector<double>& truth,
                   const std::vector<double>& said) {
  return fit::errors({x, truth, fit::trapezoid_weights(x, 0)}, said).relative_l2;
}

/// Relative L2, up to each overlap, of a curve whose logarithm has these variances.
std::vector<double> expected_errors(const std::vector<double>& x, const std::vector<double>& F,
                                    const std::vector<double>& variance) {
  std::vector<double> errors;
  double squares = 0, all = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto add = [&](std::size_t i, double weight) {
      squares += weight * F[i] * F[i] * variance[i];
      all += weight * F[i] * F[i];
    };
    const double step = x[j] - (j > 0 ? x[j - 1] : 0);
    add(j, step / 2);
    if (j > 0) add(j - 1, step / 2);
    errors.push_back(std::sqrt(squares / all));
  }
  return errors;
}

double hertz_overlap(double F_bar, const Description& d) {
  const double E_flat = d.model == "elastic"     ? 1 / (1 - std::pow(d.numbers[0].value, 2))
                        : d.model == "von-mises" ? std::exp(d.coordinates[0])
                                                 : d.numbers[1].value / (1 - std::pow(d.numbers[2].value, 2));
  return std::pow(0.75 * std::numbers::pi * F_bar / E_flat, 2.0 / 3); // ES (12)
}

/// Of the unloading (9)-(14) of Edmans & Sinka, one side: overlap given back, and work over pi R0^3
/// sigma_ref.
struct Unloading {
  double returned, work;
};
Unloading unloading(double F_bar, double alpha, double beta, double delta_bar, const Description& d) {
  const double returned = std::min(hertz_overlap(F_bar, d) / beta, delta_bar);
  return {returned, F_bar * returned / (alpha + 1)};
}

double work_of(const PressedBranch& branch) {
  double work = 0;
  for (std::size_t i = 1; i < branch.delta_bar.size(); ++i)
    work += (branch.delta_bar[i] - branch.delta_bar[i - 1]) * (branch.F_bar[i] + branch.F_bar[i - 1]) / 2;
  return work;
}

/// Logarithms, as the components hold them.
struct Said {
  std::vector<double> F, F_variance, a, unloading;
};

void add(std::vector<double>& sum, const std::vector<double>& more) {
  if (sum.empty()) sum.resize(more.size());
  for (std::size_t j = 0; j < more.size(); ++j) sum[j] += more[j];
}

std::vector<double> values_at(const Components& components, const Inputs& inputs,
                              std::span<const double> at) {
  auto values = components.mean;
  for (std::size_t c = 0; c < components.basis.size(); ++c) {
    const double score = components.processes[c].mean(inputs, at);
    for (std::size_t j = 0; j < values.size(); ++j) values[j] += score * components.basis[c][j];
  }
  return values;
}

/// With the nugget: of a press, not of the mean of many.
std::vector<double> variances_at(const Components& components, const Inputs& inputs,
                                 std::span<const double> at) {
  std::vector<double> variance;
  for (const double rest : components.rest) variance.push_back(rest * rest);
  for (std::size_t c = 0; c < components.basis.size(); ++c) {
    const Process& process = components.processes[c];
    const double of_score = variance_at(process, inputs, at) + process.nugget * process.variance;
    for (std::size_t j = 0; j < variance.size(); ++j)
      variance[j] += of_score * components.basis[c][j] * components.basis[c][j];
  }
  return variance;
}

void add_loading(Said& said, const Layer& layer, const std::vector<double>& at) {
  add(said.F, values_at(layer.force, layer.inputs, at));
  add(said.F_variance, variances_at(layer.force, layer.inputs, at));
  add(said.a, values_at(layer.radius, layer.inputs, at));
}

std::vector<double> logarithms(std::vector<double> values) {
  for (double& value : values) value = std::log(value);
  return values;
}

Said said_of(const Surrogate& s, const Description& d, const Loading* guide) {
  const auto at = input_of(s, d.coordinates);
  Said said;
  if (guide) {
    said.F = logarithms(guide->F_bar);
    said.a = logarithms(guide->a_bar);
    add_loading(said, s.guide->change, at);
  }
  for (std::size_t l = guide ? 1 : 0; l < s.layers.size(); ++l) add_loading(said, s.layers[l], at);
  for (const auto& layer : s.layers) add(said.unloading, values_at(layer.unloading, layer.inputs, at));
  if (s.model == "von-mises") {
    const double off = per_nu * (d.numbers[1].value - s.ranges[1].low);
    for (double& variance : said.F_variance) variance += off * off;
  }
  return said;
}

Errors errors_of(const PoolData& data, const Pressed& run, const Said& said) {
  Errors e;
  const auto F_bar = exponentials(said.F, 0, said.F.size());
  e.force = relative_l2(data.knots, run.F_bar, F_bar);
  e.radius = relative_l2(data.knots, run.a_bar, exponentials(said.a, 0, said.a.size()));
  e.expected = expected_errors(data.knots, F_bar, said.F_variance).back();
  for (std::size_t j = 0; j < F_bar.size(); ++j)
    e.standardised.push_back(std::abs(said.F[j] - std::log(run.F_bar[j])) / std::sqrt(said.F_variance[j]));
  e.locks = grows(locked_growth, data.knots, F_bar);
  const std::size_t branches = data.unload_delta_bar.size();
  for (std::size_t b = 0; b < branches; ++b) {
    const double at = data.unload_delta_bar[b];
    const auto knot = std::lower_bound(data.knots.begin(), data.knots.end(), at - 1e-9) - data.knots.begin();
    const auto back = unloading(F_bar[static_cast<std::size_t>(knot)], std::exp(said.unloading[b]),
                                std::exp(said.unloading[branches + b]), at, run.description);
    e.work.push_back(std::abs(back.work / work_of(run.branches[b]) - 1));
    e.residual.push_back(std::abs(at - back.returned - run.residual[b]) / at);
  }
  return e;
}

void add_ranges(Surrogate& s, const PoolData& data) {
  const auto& first = data.runs.front().description;
  for (std::size_t k = 0; k < first.numbers.size(); ++k) {
    Range range{first.numbers[k].key, INFINITY, -INFINITY};
    for (const auto& run : data.runs) {
      range.low = std::min(range.low, run.description.numbers[k].value);
      range.high = std::max(range.high, run.description.numbers[k].value);
    }
    s.ranges.push_back(range);
  }
  for (std::size_t k = 0; k < first.coordinates.size(); ++k) {
    double low = INFINITY, high = -INFINITY;
    for (const auto& run : data.runs) {
      low = std::min(low, run.description.coordinates[k]);
      high = std::max(high, run.description.coordinates[k]);
    }
    s.low.push_back(low);
    s.high.push_back(high);
  }
}

} // namespace

std::vector<double> input_of(const Surrogate& s, const std::vector<double>& coordinates) {
  std::vector<double> input;
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    if (s.high[k] - s.low[k] > 1e-9) input.push_back((coordinates[k] - s.low[k]) / (s.high[k] - s.low[k]));
  return input;
}

namespace {

Layer fit_layer(const Surrogate& s, const Tables& tables, const std::vector<const Pressed*>& runs) {
  Layer layer;
  for (const auto* run : runs) {
    const auto input = input_of(s, run->description.coordinates);
    layer.inputs.dimensions = input.size();
    layer.inputs.values.insert(layer.inputs.values.end(), input.begin(), input.end());
  }
  for (const auto& [table, components] : {std::pair{&tables.force, &layer.force},
                                          {&tables.radius, &layer.radius},
                                          {&tables.unloading, &layer.unloading}}) {
    Reduced reduced = reduce(*table);
    *components = std::move(reduced.components);
    for (const auto& scores : reduced.scores)
      components->processes.push_back(fit_process(layer.inputs, scores));
  }
  return layer;
}

std::vector<const Pressed*> all(const PoolData& data) {
  std::vector<const Pressed*> runs;
  for (const auto& run : data.runs) runs.push_back(&run);
  return runs;
}

/// A layer with the numbers that it was made of, and where each of the materials asked for stands in them.
struct Term {
  const Layer& layer;
  Tables tables;
  std::vector<std::size_t> rows;
};

/// Adds what the terms say of each material when it is left out of them; of unloadings, or of the loading.
void add_left_out(std::vector<Said>& said, const std::vector<Term>& terms, bool unloadings) {
  for (const auto& [layer, tables, rows] : terms) {
    if (unloadings) {
      const Crossed u = cross(layer.unloading, tables.unloading, layer.inputs);
      for (std::size_t i = 0; i < said.size(); ++i) add(said[i].unloading, u.mean[rows[i]]);
      continue;
    }
    const Crossed F = cross(layer.force, tables.force, layer.inputs),
                  a = cross(layer.radius, tables.radius, layer.inputs);
    for (std::size_t i = 0; i < said.size(); ++i) {
      add(said[i].F, F.mean[rows[i]]);
      add(said[i].F_variance, F.variance[rows[i]]);
      add(said[i].a, a.mean[rows[i]]);
    }
  }
}

/// The share of the standardised errors that lies within is 0.9.
double band_of(const std::vector<Errors>& errors) {
  std::vector<double> standardised;
  for (const auto& one : errors)
    if (!one.locks) standardised.insert(standardised.end(), one.standardised.begin(), one.standardised.end());
  return quantile(standardised, 0.9);
}

std::vector<std::size_t> numbered(std::size_t count) {
  std::vector<std::size_t> rows(count);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

Layer fit_change(const Surrogate& s, const PoolData& fine, const PoolData& coarse) {
  const auto both = in_both(fine, coarse);
  std::vector<const Pressed*> runs;
  for (const auto& one : both) runs.push_back(&fine.runs[one.fine]);
  return fit_layer(s, change(tables_of(fine), tables_of(coarse), both), runs);
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
  return {
      {s.layers[0], tables_of(*pools.coarse), coarse},
      {s.layers[1], change(tables_of(pools.fine), tables_of(*pools.coarse), both), numbered(both.size())}};
}

std::vector<Errors> errors_of(const Pools& pools, const std::vector<std::size_t>& fine,
                              const std::vector<Said>& said) {
  std::vector<Errors> errors;
  for (std::size_t i = 0; i < fine.size(); ++i)
    errors.push_back(errors_of(pools.fine, pools.fine.runs[fine[i]], said[i]));
  return errors;
}

} // namespace

Surrogate fit_surrogate(const Pools& pools) {
  const auto& [fine, coarse, guide] = pools;
  Surrogate s;
  const PoolData& first = coarse ? *coarse : fine;
  s.pool = fine.name;
  s.model = fine.runs.front().description.model;
  s.engine = fine.engine;
  s.asked = static_cast<int>(fine.asked);
  s.knots = fine.knots;
  s.unload_delta_bar = fine.unload_delta_bar;
  add_ranges(s, first);
  for (const auto& run : first.runs) {
    s.runs.push_back(fine.name + "-" + std::to_string(run.run));
    s.numbers.emplace_back();
    for (const auto& number : run.description.numbers) s.numbers.back().push_back(number.value);
  }
  s.layers.push_back(fit_layer(s, tables_of(first), all(first)));
  if (coarse) s.layers.push_back(fit_change(s, fine, *coarse));
  const auto errors = leave_out(s, pools);
  s.fine = static_cast<int>(errors.size());
  s.band = band_of(errors);
  s.left_out = summary_of(errors, s.band);
  if (!guide) return s;
  if (!coarse)
    throw core::InvalidInput(fmt::format("the guide {} wants coarse presses as well", guide->name));
  s.guide = Guide{guide->elements, guide->step_max, fit_change(s, *coarse, *guide), 0, {}};
  const auto guided = leave_out_guided(s, pools);
  s.guide->band = band_of(guided);
  s.guide->left_out = summary_of(guided, s.guide->band);
  return s;
}

std::vector<Errors> leave_out(const Surrogate& s, const Pools& pools) {
  std::vector<std::size_t> fine;
  const auto terms = terms_of(s, pools, fine);
  std::vector<Said> said(fine.size());
  add_left_out(said, terms, false);
  add_left_out(said, terms, true);
  return errors_of(pools, fine, said);
}

std::vector<Errors> leave_out_guided(const Surrogate& s, const Pools& pools) {
  std::vector<std::size_t> fine;
  auto terms = terms_of(s, pools, fine);
  const auto both = in_both(*pools.coarse, *pools.guide);
  Term changes{s.guide->change, change(tables_of(*pools.coarse), tables_of(*pools.guide), both), {}};
  std::vector<Term> unguided = terms;
  std::vector<std::size_t> kept_fine;
  std::vector<std::vector<std::size_t>> kept(2);
  std::vector<Said> said;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto found =
        std::find_if(both.begin(), both.end(), [&](const Both& b) { return b.fine == terms[0].rows[i]; });
    if (found == both.end()) continue;
    changes.rows.push_back(static_cast<std::size_t>(found - both.begin()));
    kept_fine.push_back(fine[i]);
    for (std::size_t l = 0; l < 2; ++l) kept[l].push_back(terms[l].rows[i]);
    const Pressed& guide = pools.guide->runs[found->coarse];
    said.push_back({logarithms(guide.F_bar), {}, logarithms(guide.a_bar), {}});
  }
  for (std::size_t l = 0; l < 2; ++l) unguided[l].rows = kept[l];
  add_left_out(said, unguided, true);
  add_left_out(said, {changes, unguided[1]}, false);
  return errors_of(pools, kept_fine, said);
}

std::vector<Errors> errors_beside(const Surrogate& s, const PoolData& data, bool guided) {
  std::vector<Errors> errors;
  for (const auto& run : data.runs) {
    std::optional<Loading> guide;
    if (guided) guide = press_guide(s, run.material);
    errors.push_back(errors_of(data, run, said_of(s, run.description, guide ? &*guide : nullptr)));
  }
  return errors;
}

Loading press_guide(const Surrogate& s, const material::Material& material) {
  press::Simple simple;
  simple.delta_bar_max = s.knots.back();
  simple.elements = s.guide->elements;
  simple.step_max = s.guide->step_max;
  const auto result = press::press({material, 1e-3, simple});
  Loading loading;
  for (const auto& point : study::on_grid(result.curve, 0.01)) { // as the pools have it
    if (loading.F_bar.size() == s.knots.size()) break;
    if (std::abs(point.delta_bar - s.knots[loading.F_bar.size()]) > 1e-9) continue;
    loading.F_bar.push_back(point.z.F_bar);
    loading.a_bar.push_back(point.z.a_bar);
  }
  if (loading.F_bar.size() < s.knots.size())
    throw core::ConvergenceError(
        fmt::format("{}: the press that guides the prediction did not get to delta/R0 = {:.4g}; "
                    "`platen derive` presses on more elements",
                    material.name, s.knots.back()),
        0, 0, 0);
  return loading;
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

Prediction predict(const Surrogate& s, const Description& d, const Loading* guide) {
  const Said said = said_of(s, d, guide);
  const double band = guide ? s.guide->band : s.band;
  const std::size_t branches = s.unload_delta_bar.size();
  Prediction p{exponentials(said.F, 0, said.F.size()),
               exponentials(said.a, 0, said.a.size()),
               exponentials(said.unloading, 0, branches),
               exponentials(said.unloading, branches, branches),
               {},
               {}};
  for (const double variance : said.F_variance) p.band.push_back(band * std::sqrt(variance));
  p.expected = expected_errors(s.knots, p.F_bar, said.F_variance);
  return p;
}

} // namespace platen::surrogate
