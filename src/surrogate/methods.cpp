#include "surrogate/methods.hpp"

#include "core/error.hpp"
#include "fit/edmans_sinka.hpp"
#include "fit/least_squares.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "surrogate/natural_neighbours.hpp"
#include "surrogate/regression.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

namespace platen::surrogate {
namespace {

constexpr double least_E_bar = 4.5; // (A.2) and (A.3) exclude less

/// k, delta_t, a of (6).
using Parameters = std::array<double, 3>;

/// The granules that are compared, and what regressions are made of.
struct Granules {
  const PoolData& data;
  std::vector<std::size_t> rows; ///< of data.runs
  Inputs inputs; ///< the numbers that vary, logarithms of those that vary by factors, in [0, 1]

  const Pressed& run(std::size_t i) const { return data.runs[rows[i]]; }
  double number(std::size_t i, std::string_view key) const {
    for (const auto& n : run(i).description.numbers)
      if (n.key == key) return n.value;
    throw core::InvalidInput(fmt::format("pool {}: its materials have no {}", data.name, key));
  }
  std::size_t size() const { return rows.size(); }
};

Granules granules_of(const Surrogate& s, const PoolData& data) {
  if (s.model != "vmdc" || data.runs.front().description.model != "vmdc")
    throw core::InvalidInput(
        fmt::format("pool {} has {} materials; these methods are those of granules (vmdc), "
                    "and of rock",
                    data.name, data.runs.front().description.model));
  Granules g{data, {}, {}};
  for (std::size_t i = 0; i < data.runs.size(); ++i) {
    g.rows.push_back(i);
    if (g.number(g.size() - 1, "E_bar") < least_E_bar) g.rows.pop_back();
  }
  std::vector<std::size_t> varying;
  for (std::size_t k = 0; k < s.ranges.size(); ++k)
    if (s.ranges[k].high > s.ranges[k].low) varying.push_back(k);
  if (varying.empty() || varying.size() > most_dimensions)
    throw core::InvalidInput(
        fmt::format("pool {}: {} numbers vary; natural neighbours and regressions are compared "
                    "where one to {} do",
                    data.name, varying.size(), most_dimensions));
  g.inputs.dimensions = varying.size();
  for (std::size_t i = 0; i < g.size(); ++i)
    for (const std::size_t k : varying) {
      const auto& n = g.run(i).description.numbers[k];
      const auto scale = [&](double x) { return n.log ? std::log(x) : x; };
      g.inputs.values.push_back((scale(n.value) - scale(s.ranges[k].low)) /
                                (scale(s.ranges[k].high) - scale(s.ranges[k].low)));
    }
  return g;
}

double work_of_form(double alpha, double beta) { return -std::log(beta * (1 + alpha)); }

/// Only what a method says; the rest is as it was pressed.
Said pressed_said(const PoolData& data, const Pressed& run) {
  const auto ln_F = logarithms(run.F_bar);
  return {ln_F, std::vector<double>(ln_F.size(), 1), logarithms(run.a_bar),
          over_force(run.returned, data.unload_delta_bar, data.knots, ln_F), logarithms(run.alpha)};
}

Method method(std::string name, const Granules& g,
              const std::function<std::optional<Said>(std::size_t)>& says) {
  Method m{std::move(name), 0, {}, {}, {}};
  std::vector<double> force, work, residual;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const auto said = says(i);
    if (!said) continue;
    ++m.materials;
    const Errors e = errors_of(g.data, g.run(i), *said);
    force.push_back(e.force);
    work.insert(work.end(), e.work.begin(), e.work.end());
    residual.insert(residual.end(), e.residual.begin(), e.residual.end());
  }
  m.force = quantiles(force);
  m.work = quantiles(work);
  m.residual = quantiles(residual);
  return m;
}

/// The force of (6) at the knots; it must not be negative.
Said with_form(const Granules& g, std::size_t i, const Parameters& p) {
  Said said = pressed_said(g.data, g.run(i));
  for (std::size_t j = 0; j < said.F.size(); ++j) {
    const double x = g.data.knots[j], delta_t = std::max(p[1], 1e-6);
    said.F[j] = std::log(std::max(p[0], 1e-6)) +
                (x <= delta_t ? std::log(x) : std::log(delta_t) + p[2] * (x - delta_t));
  }
  return said;
}

Parameters fitted_form(const Granules& g, std::size_t i) {
  press::Curve curve;
  curve.radius_m = curve.sigma_ref_Pa = 1;
  for (std::size_t j = 0; j < g.data.knots.size(); ++j) {
    press::CurvePoint point;
    point.delta_bar = point.delta_m = g.data.knots[j];
    point.F_bar = g.run(i).F_bar[j];
    curve.points.push_back(point);
  }
  const auto fit = fit::fit_edmans_sinka(curve);
  return {fit.k, fit.delta_t, fit.a};
}

using Columns = std::vector<std::vector<double>>;

Columns columns_of(std::size_t rows, const std::function<std::vector<double>(std::size_t)>& row_of) {
  Columns columns;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto row = row_of(i);
    columns.resize(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

Columns chosen_of(const Columns& columns, const std::vector<std::size_t>& chosen) {
  Columns some;
  for (const std::size_t k : chosen) some.push_back(columns[k]);
  return some;
}

void compare_loading(const Granules& g, const std::vector<Said>& by_surrogate, std::vector<Method>& methods) {
  const auto appendix = [&](law::Coefficients which) {
    return [&g, which](std::size_t i) -> std::optional<Said> {
      const auto p = law::edmans_sinka_appendix(g.number(i, "Gamma_bar"), g.number(i, "E_bar"), which);
      return with_form(g, i, {p.k, p.delta_t, p.a});
    };
  };
  methods.push_back(method("(A.1) to (A.3) as printed", g, appendix(law::Coefficients::printed)));
  methods.push_back(
      method("(A.1) to (A.3), two misprints mended", g, appendix(law::Coefficients::corrected)));
  std::vector<Parameters> fits;
  for (std::size_t i = 0; i < g.size(); ++i) fits.push_back(fitted_form(g, i));
  std::vector<std::size_t> groups(g.size());
  std::iota(groups.begin(), groups.end(), std::size_t{0});
  const auto regressed = [&](const std::array<Columns, 3>& columns) {
    std::vector<Parameters> said(g.size());
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<double> y;
      for (const auto& p : fits) y.push_back(p[k]);
      const auto out = regression_left_out(columns[k], y, groups);
      for (std::size_t i = 0; i < g.size(); ++i) said[i][k] = out[i];
    }
    return said;
  };
  const auto by = [&](const std::vector<Parameters>& said) {
    return [&g, &said](std::size_t i) -> std::optional<Said> { return with_form(g, i, said[i]); };
  };
  const auto numbers = [&](std::size_t i) {
    return std::pair{g.number(i, "Gamma_bar"), g.number(i, "E_bar")};
  };
  const Columns of_k = columns_of(g.size(), [&](std::size_t i) {
    const auto [G, E] = numbers(i);
    return std::vector{1.0, G * std::log(E), G, std::log(E)};
  });
  const Columns of_others = columns_of(g.size(), [&](std::size_t i) {
    const auto [G, E] = numbers(i);
    return std::vector{1.0, G * G, G / E, 1 / (E * E), G, 1 / E};
  });
  const auto refitted = regressed({of_k, of_others, of_others});
  methods.push_back(method("(A.1) to (A.3), refitted", g, by(refitted)));
  const Columns all = columns_of(g.size(), [&](std::size_t i) { return monomials(g.inputs.row(i), 4); });
  std::array<Columns, 3> chosen;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double> y;
    for (const auto& p : fits) y.push_back(p[k]);
    chosen[k] = chosen_of(all, stepwise(all, y));
  }
  const auto stepped = regressed(chosen);
  methods.push_back(method("k, delta_t, a by stepwise regression", g, by(stepped)));
  methods.push_back(method("the form (6), fitted to each curve", g, by(fits)));
  methods.push_back(method("surrogate", g, [&](std::size_t i) {
    Said said = pressed_said(g.data, g.run(i));
    said.F = by_surrogate[i].F;
    return std::optional(said);
  }));
}

/// Of each granule, without itself; none outside of the hull of the others.
std::vector<std::optional<Said>> by_natural_neighbours(const Granules& g) {
  std::vector<std::optional<Said>> said;
  for (std::size_t i = 0; i < g.size(); ++i) {
    Inputs others{g.inputs.dimensions, {}};
    std::vector<std::size_t> which;
    for (std::size_t j = 0; j < g.size(); ++j) {
      if (j == i) continue;
      which.push_back(j);
      const auto row = g.inputs.row(j);
      others.values.insert(others.values.end(), row.begin(), row.end());
    }
    const auto shares = NaturalNeighbours(others).shares(g.inputs.row(i));
    said.emplace_back();
    if (shares.empty()) continue;
    said.back() = pressed_said(g.data, g.run(i));
    for (const auto values : {&Said::F, &Said::work, &Said::exponent}) {
      auto& sum = (*said.back()).*values;
      std::fill(sum.begin(), sum.end(), 0);
    }
    for (const auto& [site, share] : shares) {
      const Said there = pressed_said(g.data, g.run(which[site]));
      for (const auto values : {&Said::F, &Said::work, &Said::exponent})
        for (std::size_t j = 0; j < (there.*values).size(); ++j)
          ((*said.back()).*values)[j] += share * (there.*values)[j];
    }
  }
  return said;
}

void compare_unloading(const Granules& g, const std::vector<Said>& by_surrogate, Methods& methods) {
  const auto& from = g.data.unload_delta_bar;
  const std::size_t branches = from.size();
  // A row a branch; those of a granule are left out together.
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < g.size(); ++i)
    for (std::size_t b = 0; b < branches; ++b) groups.push_back(i);
  constexpr int degree = 4;
  const Columns all = columns_of(groups.size(), [&](std::size_t row) {
    const std::size_t i = row / branches;
    const std::array x = {std::log(from[row % branches]),
                          std::log(g.number(i, "E_bar") / g.number(i, "Gamma_bar"))};
    return monomials(x, degree);
  });
  const auto names = monomial_names({"x", "y"}, degree);
  std::array<std::vector<double>, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<double> y;
    for (std::size_t row = 0; row < groups.size(); ++row) {
      const auto& run = g.run(row / branches);
      y.push_back(std::log((k == 0 ? run.alpha : run.beta)[row % branches]));
    }
    const auto chosen = stepwise(all, y);
    const Columns some = chosen_of(all, chosen);
    ClosedForm form{k == 0 ? "ln(alpha)" : "ln(beta)", {}, fit::least_squares(some, y)};
    for (const std::size_t column : chosen) form.terms.push_back(names[column]);
    methods.forms.push_back(std::move(form));
    out[k] = regression_left_out(some, y, groups);
  }
  methods.unloading.push_back(method("closed form over delta_bar, E_bar/Gamma_bar", g, [&](std::size_t i) {
    Said said = pressed_said(g.data, g.run(i));
    for (std::size_t b = 0; b < branches; ++b) {
      said.exponent[b] = out[0][branches * i + b];
      said.work[b] = work_of_form(std::exp(said.exponent[b]), std::exp(out[1][branches * i + b]));
    }
    return std::optional(said);
  }));
  methods.unloading.push_back(method("the form (13), fitted to each branch", g, [&](std::size_t i) {
    Said said = pressed_said(g.data, g.run(i));
    for (std::size_t b = 0; b < branches; ++b)
      said.work[b] = work_of_form(g.run(i).alpha[b], g.run(i).beta[b]);
    return std::optional(said);
  }));
  methods.unloading.push_back(method("surrogate", g, [&](std::size_t i) {
    Said said = pressed_said(g.data, g.run(i));
    said.work = by_surrogate[i].work, said.exponent = by_surrogate[i].exponent;
    return std::optional(said);
  }));
}

} // namespace

Methods methods_side_by_side(const Surrogate& s, const PoolData& data) {
  const Granules g = granules_of(s, data);
  const auto all_said = said_left_out(s, {data});
  std::vector<Said> by_surrogate;
  for (const std::size_t row : g.rows) by_surrogate.push_back(all_said[row]);
  Methods methods;
  compare_loading(g, by_surrogate, methods.loading);
  compare_unloading(g, by_surrogate, methods);
  const auto neighbours = by_natural_neighbours(g);
  const auto nn = [&](bool loading) {
    return [&g, &neighbours, loading](std::size_t i) -> std::optional<Said> {
      if (!neighbours[i]) return {};
      Said said = *neighbours[i];
      const Said truth = pressed_said(g.data, g.run(i));
      if (loading) said.work = truth.work, said.exponent = truth.exponent;
      else said.F = truth.F;
      return said;
    };
  };
  methods.loading.insert(methods.loading.end() - 1, method("natural neighbours of the curve", g, nn(true)));
  methods.unloading.insert(methods.unloading.end() - 1,
                           method("natural neighbours of work and alpha", g, nn(false)));
  return methods;
}

} // namespace platen::surrogate
