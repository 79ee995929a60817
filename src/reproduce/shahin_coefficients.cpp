// Shahin's thesis, chapter 2: coefficients of the law over lambda, and their tables.

#include "fit/golden.hpp"
#include "platen/law/agarwal_secondary.hpp"
#include "reproduce/shahin.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::reproduce {
namespace {

using law::LoadingCase;

// --- coefficients over lambda ---

using OfLaw = std::function<double(const law::AgarwalCoefficients<double>&)>;

/// A coefficient of the law: its closed form against what the presses have.
struct CoefficientOf {
  const char *key, *label;
  OfLaw of;
  double tolerance;
};

/// Adds a comparison and a chart of one coefficient over lambda (or zeta); nothing where no press determines
/// it.
void add_coefficient(Row& row, const std::vector<Metal>& list, const CoefficientOf& c,
                     const std::string& title, bool over_zeta = false) {
  std::vector<double> x, theirs, ours;
  for (const Metal& m : list)
    if (const auto value = m[c.key]) {
      x.push_back(over_zeta ? m.zeta : m.lambda);
      theirs.push_back(c.of(law::AgarwalCoefficients<double>::published(m.loading, m.lambda, m.zeta)));
      ours.push_back(std::string(c.key) == "l" ? std::log(1 - *value) : *value);
    }
  if (x.empty()) return;
  row.comparisons.push_back(overlay(fmt::format("{} {}", title, c.label), over_zeta ? "ζ" : "λ", x, theirs,
                                    ours, c.tolerance, fit_error));
  Chart chart{fmt::format("{} of {} loading", c.label, title),
              over_zeta ? "ζ = B/σ_y" : lambda_label,
              fmt::format("{}  [–]", c.label),
              {}};
  chart.log_x = true;
  const auto grid = over_zeta ? x : even_in_logarithm(least(x) / 1.2, 1.2 * largest(x), 60);
  chart.series = {{"press", Mark::points, x, ours},
                  {"closed form", Mark::dashed, grid, over_zeta ? theirs : values(grid, [&](double lambda) {
                     return c.of(law::AgarwalCoefficients<double>::published(
                         list.front().loading, lambda, lambda)); // of l alone zeta matters
                   })}};
  row.charts.push_back(std::move(chart));
}

Row radius_coefficients(const Data& data) {
  Row row{"sh-fig-2-14",
          "Fig. 2.14",
          "D₁, D₃, D₅ of the contact radius, simple loading",
          "Closed forms (2.14) over λ.",
          "Linear least squares of (2.13) on our radii, 12 metals of ν = 0.3 and rows of Table A.1.",
          "D₃ and D₅ make up for each other."};
  const auto list = metals(data, LoadingCase::simple);
  add_coefficient(row, list, {"D_1", "D₁", [](const auto& c) { return c.D1; }, 0.05}, "simple");
  add_coefficient(row, list, {"D_3", "D₃", [](const auto& c) { return c.D3; }, 0.2}, "simple");
  add_coefficient(row, list, {"D_5", "D₅", [](const auto& c) { return c.D5; }, 0.2}, "simple");
  return row;
}

Row greatest_pressure(const Data& data) {
  Row row{"sh-fig-2-15",
          "Fig. 2.15",
          "greatest pressure and its overlap",
          "Closed forms (2.19), (2.20) over λ, all loadings.",
          "Fits of (2.48) to our presses.",
          "The overlap of the greatest pressure lies before our first fitted row for λ above 250, and is not "
          "found there."};
  for (const LoadingCase loading : loadings) {
    const auto list = metals(data, loading);
    add_coefficient(row, list, {"H_max", "H̄_max", [](const auto& c) { return c.H_max; }, 0.1},
                    name_of(loading));
    add_coefficient(row, list, {"x_h", "γ(H̄_max)/2R", [](const auto& c) { return c.x_h; }, 0.25},
                    name_of(loading));
  }
  return row;
}

Row influence_of_parameters(const Data& data) {
  Row row{"sh-fig-2-16", "Fig. 2.16", "what q, r, p and γ(H̄_min) do to (2.25)",
          "Curves of the formula for one material: E/σ_y = 1500.97, λ = 1721.55.",
          "The same numbers of that row of Table A.1, and the formula."};
  const core::Csv table = data.table("shahin-table-a1.csv");
  for (const auto& line : table.rows) {
    if (std::abs(table.number(line, table.column("lambda_printed")) - printed(data, "fig_2_16.lambda")) >
        0.01)
      continue;
    const double E = table.number(line, table.column("E_MPa")), nu = table.number(line, table.column("nu")),
                 sigma_y = table.number(line, table.column("sigma_y_MPa"));
    row.comparisons = {{"E/σ_y", printed(data, "fig_2_16.E_over_sigma_y"), E / sigma_y, 5e-4,
                        Measure::relative, formula_error},
                       {"λ", printed(data, "fig_2_16.lambda"), E / sigma_y / (1 - nu * nu), 5e-4,
                        Measure::relative, formula_error}};
  }
  Chart chart{"(2.25): p = 1.5, r = 2, γ(H̄_min)/2R = 0.8", overlap_label, "H̄", {}};
  const auto c =
      law::AgarwalCoefficients<double>::published(LoadingCase::simple, printed(data, "fig_2_16.lambda"), 1e4);
  const auto x = even(c.x_h, 0.8, 80);
  for (const double q : {6.0, 8.0, 10.0}) {
    const auto softening = law::Softening<double>::flat_at(0.8 - c.x_h, q, 2.0);
    chart.series.push_back(
        {fmt::format("q = {}", q), q == 8 ? Mark::line : Mark::dashed, x,
         values(x, [&](double at) { return c.H_max - 1.5 * softening.value(at - c.x_h); })});
  }
  row.charts.push_back(std::move(chart));
  return row;
}

Row density_product(const Data& data) {
  Row row{"sh-fig-2-17",
          "Fig. 2.17",
          "Γ, the product of densities at the least pressure",
          "One value for both confined loadings: Γ = 0.0593.",
          "ρ_V ρ_S at the least pressure of the fits to our presses.",
          "Pressure is so flat there that a Γ a fifth larger moves its place by about a tenth, and is of "
          "little weight for the force."};
  Chart chart{"Γ (2.28)", lambda_label, "Γ  [–]", {}};
  chart.log_x = true;
  std::vector<double> all;
  for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic}) {
    Series series{name_of(loading), Mark::points, {}, {}};
    for (const Metal& m : metals(data, loading))
      if (const auto value = m["Gamma"]) {
        series.x.push_back(m.lambda);
        series.y.push_back(*value);
        all.push_back(*value);
      }
    chart.series.push_back(std::move(series));
  }
  row.comparisons.push_back({"Γ, median", printed(data, "Gamma"), median(all), 0.1, Measure::relative, 0.1});
  chart.series.push_back({"0.0593", Mark::dashed, {100, 6000}, {0.0593, 0.0593}});
  row.charts.push_back(std::move(chart));
  return row;
}

Row least_pressure(const Data& data) {
  Row row{"sh-fig-2-18", "Fig. 2.18", "least pressure of the confined loadings", "Closed form (2.37) over λ.",
          "Fits to our presses."};
  for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic})
    add_coefficient(row, metals(data, loading),
                    {"H_min", "H̄_min", [](const auto& c) { return c.H_min; }, 0.1}, name_of(loading));
  return row;
}

Row softening(const Data& data) {
  Row row{"sh-fig-2-19",
          "Fig. 2.19",
          "q and r of the softening",
          "Closed forms (2.39), (2.40) over λ.",
          "Fits to our presses in simple loading.",
          "q, r and H̄_max make up for each other."};
  const auto list = metals(data, LoadingCase::simple);
  add_coefficient(row, list, {"q", "q", [](const auto& c) { return c.q; }, 0.2}, "simple");
  add_coefficient(row, list, {"r", "r", [](const auto& c) { return c.r; }, 0.2}, "simple");
  return row;
}

Row compressibility_coefficient(const Data& data) {
  Row row{"sh-fig-2-20", "Fig. 2.20", "l of low compressibility",
          "Closed form (2.47) of ln(1 − l) over ζ, both loadings alike.", "Fits to our presses."};
  for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic})
    add_coefficient(row, metals(data, loading),
                    {"l", "ln(1 − l)", [](const auto& c) { return std::log(1 - c.l); }, 0.1},
                    name_of(loading), true);
  return row;
}

// --- tables ---

/// alpha tanh(beta lambda^delta) by least squares.
struct Saturating {
  double alpha, beta, delta;
  double operator()(double lambda) const { return alpha * std::tanh(beta * std::pow(lambda, delta)); }
};

Saturating fitted_saturation(const std::vector<double>& lambda, const std::vector<double>& y) {
  const auto scaled = [&](double log_beta, double delta) {
    Saturating s{1, std::exp(log_beta), delta};
    double fy = 0, ff = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      fy += s(lambda[i]) * y[i];
      ff += s(lambda[i]) * s(lambda[i]);
    }
    s.alpha = fy / ff;
    return s;
  };
  const auto off = [&](double log_beta, double delta) {
    const Saturating s = scaled(log_beta, delta);
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) sum += std::pow(s(lambda[i]) - y[i], 2);
    return sum;
  };
  const auto best_beta = [&](double delta) {
    return fit::scanned_minimum([&](double log_beta) { return off(log_beta, delta); },
                                even(std::log(1e-3), std::log(2.0), 30), 40);
  };
  const double delta =
      fit::scanned_minimum([&](double d) { return best_beta(d).value; }, even(0.1, 1.2, 23), 30).at;
  return scaled(best_beta(delta).at, delta);
}

Row radius_table(const Data& data) {
  Row row{"sh-table-2-2", "Table 2.2", "coefficients of the contact radius",
          "α, β, δ of D₁, D₃, D₅ for simple loading, and b of the other loadings.",
          "(2.14), with b^{i/2}, refitted to our presses; compared as D_i at λ = 1,000 and as b_i."};
  const auto simple = metals(data, LoadingCase::simple);
  for (const int i : {1, 3, 5}) {
    const std::string key = fmt::format("D_{}", i);
    std::vector<double> lambda, y;
    for (const Metal& m : simple)
      if (m[key]) {
        lambda.push_back(m.lambda);
        y.push_back(*m[key]);
      }
    const Saturating anew = fitted_saturation(lambda, y);
    const auto number = [&](const char* name) { return printed(data, fmt::format("T2_2.{}_{}", name, i)); };
    const Saturating theirs{number("alpha"), number("beta"), number("delta")};
    row.comparisons.push_back({fmt::format("D{} of simple loading at λ = 1,000", i), theirs(1000), anew(1000),
                               i == 1 ? 0.05 : 0.15, Measure::relative, fit_error});
    row.because +=
        fmt::format("D{}: α = {:.4g}, β = {:.3g}, δ = {:.3g}. ", i, anew.alpha, anew.beta, anew.delta);
    for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic}) {
      std::vector<double> b;
      for (const Metal& m : metals(data, loading))
        if (m[key] && *m[key] > 0) b.push_back(std::pow(*m[key] / anew(m.lambda), 2.0 / i));
      row.comparisons.push_back({fmt::format("b{} of {} loading, median", i, name_of(loading)),
                                 printed(data, fmt::format("T2_2.b_{}_{}", i, name_of(loading))), median(b),
                                 i == 1 ? 0.05 : 0.15, Measure::relative, fit_error});
    }
  }
  row.because += "(2.14) prints b^{1/2} where b^{i/2} is meant: Table 3.1 follows only so.";
  return row;
}

Row onset_table(const Data& data) {
  Row row{"sh-table-2-4", "Table 2.4", "onset of low compressibility of the sides",
          "γ/2R of five materials, 0.4159 to 0.4098.",
          "Where the product (2.52) of our die presses passes 0.0593, rows of the same λ."};
  for (const Metal& m : rows_of_table_a1(data, LoadingCase::die))
    if (const auto onset = m["side_onset"])
      row.comparisons.push_back({fmt::format("γ/2R at λ = {:.0f}", m.lambda), law::secondary_onset(m.lambda),
                                 *onset, 0.005, Measure::relative, 0.005});
  return row;
}

} // namespace

std::vector<Row> coefficient_rows(const Data& data) {
  return {radius_coefficients(data),
          greatest_pressure(data),
          influence_of_parameters(data),
          density_product(data),
          least_pressure(data),
          softening(data),
          compressibility_coefficient(data)};
}

std::vector<Row> coefficient_tables(const Data& data) { return {radius_table(data), onset_table(data)}; }

} // namespace platen::reproduce
