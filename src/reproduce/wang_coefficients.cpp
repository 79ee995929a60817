// Wang et al., section 4: the four coefficients of the law, by natural neighbours and by regression.

#include "core/error.hpp"
#include "fit/least_squares.hpp"
#include "fit/wang.hpp"
#include "reproduce/papers.hpp"
#include "reproduce/statistics.hpp"
#include "reproduce/wang.hpp"
#include "surrogate/rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::reproduce {
namespace {

constexpr double MPa = 1e6, GPa = 1e9;
constexpr const char* names[] = {"a", "b", "m", "n"};

/// The four coefficients in the paper's convention: delta whole, delta_y of one sphere. Elastic: 2^(-3/2) and
/// 3/2.
using Coefficients = std::array<double, 4>;
Coefficients in_their_convention(double a, double b, double m, double n) {
  return {a / std::exp2(b), b, m / std::exp2(n), n};
}

struct Grain {
  double E_GPa, nu, phi_deg, sigma_c_MPa;
  Coefficients of; ///< what finite elements give
};

/// The 162; those that do not yield at 100 N are elastic.
std::vector<Grain> grains(const Pool& pool) {
  std::vector<Grain> list;
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run) {
    if (!pool.done(run)) continue;
    Grain g{pool.number(run, "material.E_Pa") / GPa, pool.number(run, "material.nu"),
            pool.number(run, "material.phi_deg"), pool.number(run, "material.sigma_c_Pa") / MPa,
            in_their_convention(1, 1.5, 1, 1.5)};
    if (const auto a = pool.value(run, "wang.a"))
      g.of = in_their_convention(*a, pool.number(run, "wang.b"), pool.number(run, "wang.m"),
                                 pool.number(run, "wang.n"));
    list.push_back(g);
  }
  return list;
}

/// Terms of (19).
std::array<double, 7> terms(const Grain& g) {
  return {1, g.E_GPa, g.nu, g.phi_deg * g.phi_deg, g.phi_deg, g.sigma_c_MPa * g.sigma_c_MPa, g.sigma_c_MPa};
}

double regression(const std::vector<double>& C, const Grain& g) {
  const auto t = terms(g);
  double sum = 0;
  for (std::size_t k = 0; k < t.size(); ++k) sum += C[k] * t[k];
  return sum;
}

std::vector<double> printed_regression(const Data& data, const char* coefficient) {
  std::vector<double> C;
  for (int k = 0; k < 7; ++k) C.push_back(data.printed("wang", fmt::format("{}.C{}", coefficient, k)));
  return C;
}

std::vector<double> refitted_regression(const std::vector<Grain>& list, std::size_t coefficient) {
  std::vector<std::vector<double>> columns(7);
  std::vector<double> y;
  for (const Grain& g : list) {
    const auto t = terms(g);
    for (std::size_t k = 0; k < 7; ++k) columns[k].push_back(t[k]);
    y.push_back(g.of[coefficient]);
  }
  return fit::least_squares(columns, y);
}

/// Table 3.
struct Type {
  const char* press;
  Grain grain;
  double F_y_N, delta_y_mm; ///< printed
};

Type type(const Data& data, int number) {
  const core::Csv table = data.table("wang-table-3.csv");
  const auto& line = table.rows[static_cast<std::size_t>(number - 1)];
  const auto at = [&](const char* column) { return table.number(line, table.column(column)); };
  return {number == 1 ? "wang-type-1" : "wang-type-2",
          {at("E_GPa"), at("nu"), at("phi_deg"), at("sigma_c_MPa"), {}},
          at("F_y_N"),
          at("delta_y_mm")};
}

/// What our press of a type gives. Type 2 does hardly yield at 100 N.
Coefficients pressed(const Data& data, const Type& t) {
  const auto fit = fit::fit_wang(data.press(t.press));
  return in_their_convention(fit.a, fit.b, fit.m, fit.n);
}

/// By natural neighbours, in the paper's convention.
Coefficients interpolated(const surrogate::Rock& rock, const Grain& at,
                          surrogate::RockInterpolation::CoordinatesOf coordinates) {
  const auto c = surrogate::RockInterpolation(rock, coordinates)
                     .at({0, at.E_GPa * GPa, at.nu, at.phi_deg, at.sigma_c_MPa * MPa, {}});
  if (!c) throw core::InvalidInput("Table 3 lies outside of the grains of pool wang");
  return in_their_convention((*c)[0], (*c)[1], (*c)[2], (*c)[3]);
}

/// The value that the paper's finite elements gave: Table 4 says how far (19) is from it, without a sign.
struct Recovered {
  double low, high;
  double nearest(double ours) const { return std::abs(low - ours) < std::abs(high - ours) ? low : high; }
};

Recovered recovered(const Data& data, const Type& t, int number, std::size_t coefficient) {
  const double by_regression = regression(printed_regression(data, names[coefficient]), t.grain);
  const double error = data.printed("wang", fmt::format("type_{}.regression.{}", number, names[coefficient]));
  return {by_regression / (1 + error), by_regression / (1 - error)};
}
Row coefficient_map(const Data& data, const char* id, const char* figure, std::size_t k) {
  Row row{id, figure, fmt::format("coefficient {} for E = 10 GPa, interpolated to type 1", names[k]), "", ""};
  const auto list = grains(data.pool("wang"));
  const Type one = type(data, 1);
  const double ours = pressed(data, one)[k];
  const Recovered fe = recovered(data, one, 1, k);
  row.theirs = fmt::format("A map and the value at type 1. Their finite elements gave {:.4g} or {:.4g}: "
                           "Table 4 says how far (19) is from them, not to which side.",
                           fe.low, fe.high);
  row.ours = "Our press of type 1; our 162 presses of Table 1, in the paper's convention (δ of both, δ_y of "
             "one sphere).";
  row.comparisons.push_back({fmt::format("{} of type 1, the nearer of the two", names[k]), fe.nearest(ours),
                             ours, k == 2 ? 0.1 : 0.03, Measure::relative, fit_error});
  std::vector<double> here;
  for (const Grain& g : list)
    if (g.E_GPa == 10) here.push_back(g.of[k]);
  if (k % 2 == 0)
    row.comparisons.push_back(
        {fmt::format("spread of {} for E = 10 GPa, largest over least less one", names[k]),
         data.printed("wang", fmt::format("spread.{}", names[k])), largest(here) / least(here) - 1, 0.15,
         Measure::relative, fit_error});
  else
    row.comparisons.push_back({fmt::format("largest {} of the 54, which stay below", names[k]),
                               data.printed("wang", "exponent_limit"), largest(here), 0.01, Measure::relative,
                               0.01});
  Chart chart{fmt::format("{} for E = 10 GPa, ν = 0.1 (full) and 0.3 (dashed)", names[k]),
              "strength σ_c (MPa)",
              fmt::format("{}  [–]", names[k]),
              {}};
  constexpr const char* shades[] = {"#0072b2", "#d55e00", "#009e73"};
  for (const double nu : {0.1, 0.3})
    for (int i = 0; i < 3; ++i) {
      Series series{fmt::format("φ = {}°, ν = {}", 20 + 10 * i, nu),
                    nu == 0.1 ? Mark::line : Mark::dashed,
                    {},
                    {},
                    shades[i]};
      for (const Grain& g : list)
        if (g.E_GPa == 10 && g.nu == nu && g.phi_deg == 20 + 10 * i) {
          series.x.push_back(g.sigma_c_MPa);
          series.y.push_back(g.of[k]);
        }
      chart.series.push_back(std::move(series));
    }
  chart.series.push_back({"type 1, pressed", Mark::points, {15}, {ours}, "#000000"});
  row.charts.push_back(std::move(chart));
  row.because = "Section 4.3 swaps Figs 7 and 9.";
  return row;
}

/// Force over the approach of one sphere, Hertz-consistent.
Row force_curves(const Data& data, const char* id, const char* figure, int number) {
  Row row{id, figure, fmt::format("force over displacement, type {}", number), "", ""};
  const Type t = type(data, number);
  const press::Curve curve = fit::hertz_consistent(data.press(t.press));
  const auto yield = fit::first_yield(curve.E_Pa, curve.nu, curve.phi_deg, curve.sigma_c_Pa, curve.radius_m);
  const auto hertz = [&](double delta) { return yield.F_N * std::pow(delta / yield.delta_m, 1.5); };
  const double a = regression(printed_regression(data, "a"), t.grain),
               b = regression(printed_regression(data, "b"), t.grain);
  const auto by_regression = [&](double delta) {
    return yield.F_N * a * std::pow(2 * delta / yield.delta_m, b);
  };
  Chart chart{fmt::format("type {}, two spheres of R = 0.1 m", number),
              "displacement of one sphere δ (µm)",
              "force F (N)",
              {}};
  Series load{"press, loading", Mark::line, {}, {}}, unload{"press, unloading", Mark::line, {}, {}};
  std::vector<double> x, press;
  for (const auto& point : curve.points) {
    Series& series = point.branch == press::Branch::loading ? load : unload;
    series.x.push_back(1e6 * point.delta_m);
    series.y.push_back(point.force_N);
    if (point.branch == press::Branch::loading && point.delta_m >= yield.delta_m * (number == 1 ? 1 : 0.2)) {
      x.push_back(point.delta_m);
      press.push_back(point.force_N);
    }
  }
  const auto grid = even(0, x.back(), 60);
  std::vector<double> in_um;
  for (const double delta : grid) in_um.push_back(1e6 * delta);
  chart.series = {load,
                  unload,
                  {"Hertz", Mark::dashed, in_um, values(grid, hertz)},
                  {"(16) with (19) as printed", Mark::dashed, in_um, values(grid, by_regression)}};
  row.charts.push_back(std::move(chart));
  if (number == 1) {
    row.theirs =
        "Finite elements, interpolation and regression (19); the regression is a coarse approximation.";
    row.ours = "(16) with the printed (19) against our press of type 1, from first yield on.";
    row.comparisons.push_back(
        overlay("F of type 1", "δ of one sphere (m)", x, values(x, by_regression), press, 0.1, force_error));
  } else {
    row.theirs = "Finite elements, Hertz and interpolation lie on each other, elastic; the regression is a "
                 "little off.";
    row.ours = "Hertz against our press of type 2, from a fifth of the overlap of first yield on.";
    row.comparisons.push_back(overlay("F of type 2 against Hertz", "δ of one sphere (m)", x, values(x, hertz),
                                      press, 0.03, force_error));
  }
  row.because = "Section 4.4 cites Figs 10 and 11 where 11 and 12 are meant.";
  return row;
}

Row regression_table(const Data& data) {
  Row row{"wg-table-2", "Table 2", "regression (19) of a, b, m, n",
          "28 coefficients, R² = 0.7068, 0.7665, 0.5166, 0.7517.",
          "The same terms through our 162 presses by linear least squares, and the values of both at the "
          "middle of the table (E = 20 GPa, ν = 0.2, φ = 30°, σ_c = 20 MPa)."};
  const auto list = grains(data.pool("wang"));
  if (list.size() < 162) {
    row.because = fmt::format("{} of the 162 grains are pressed.", list.size());
    return row;
  }
  const Grain middle{20, 0.2, 30, 20, {}};
  std::size_t elastic = 0;
  for (const Grain& g : list) elastic += g.of[1] == 1.5;
  row.because = fmt::format("{} of our {} grains do not yield, or hardly, on the axis at 100 N and count as "
                            "elastic. Fitted anew, C₀ to C₆:",
                            elastic, list.size());
  for (std::size_t k = 0; k < 4; ++k) {
    const auto C = refitted_regression(list, k), printed = printed_regression(data, names[k]);
    std::vector<double> y, anew, old;
    for (const Grain& g : list) {
      y.push_back(g.of[k]);
      anew.push_back(regression(C, g));
      old.push_back(regression(printed, g));
    }
    row.comparisons.push_back({fmt::format("R² of {}, fitted anew", names[k]),
                               data.printed("wang", fmt::format("R2.{}", names[k])), r_squared(y, anew), 0.1,
                               Measure::absolute, 0.03});
    row.comparisons.push_back({fmt::format("{} at the middle", names[k]), regression(printed, middle),
                               regression(C, middle), 0.1, Measure::relative, fit_error});
    row.because += fmt::format(" {}: {:.4g}, {:.3g}, {:.3g}, {:.3g}, {:.3g}, {:.3g}, {:.3g} (printed "
                               "coefficients on our values: R² {:.2f}).",
                               names[k], C[0], C[1], C[2], C[3], C[4], C[5], C[6], r_squared(y, old));
    Chart chart{fmt::format("{} of the 162 grains", names[k]),
                fmt::format("{} of our press  [–]", names[k]),
                fmt::format("{} of the regression  [–]", names[k]),
                {}};
    chart.series = {{"fitted anew", Mark::points, y, anew},
                    {"as printed", Mark::points, y, old},
                    {"equal", Mark::dashed, {least(y), largest(y)}, {least(y), largest(y)}, "#444444"}};
    row.charts.push_back(std::move(chart));
  }
  return row;
}

Row yield_table(const Data& data) {
  Row row{"wg-table-3",
          "Table 3",
          "first yield of two materials",
          "F_y = 9.06 and 84.45 N, δ_y = 0.00164 and 0.00706 mm.",
          "(8) to (13), with the factor 1 + ν that (10) lost.",
          "The table lists the approach of one sphere; (13) gives that of both centres, twice as much."};
  for (const int number : {1, 2}) {
    const Type t = type(data, number);
    const auto yield =
        fit::first_yield(t.grain.E_GPa * GPa, t.grain.nu, t.grain.phi_deg, t.grain.sigma_c_MPa * MPa, 0.1);
    row.comparisons.push_back({fmt::format("F_y (N) of type {}", number), t.F_y_N, yield.F_N, 1e-3,
                               Measure::relative, formula_error});
    row.comparisons.push_back({fmt::format("δ_y (mm) of type {}, one sphere", number), t.delta_y_mm,
                               1e3 * yield.delta_m, 2e-3, Measure::relative, formula_error});
  }
  return row;
}

Row error_table(const Data& data) {
  Row row{
      "wg-table-4", "Table 4", "errors of interpolation and regression",
      "Per cent of each coefficient, by interpolation and by (19), for types 1 and 2.",
      "The printed (19), and natural neighbours between our 162 in ν, φ and ln F_y (a small contact does not "
      "tell E and σ_c apart), against our presses of the two types; type 2 against the elastic limit."};
  data.pool("wang"); // for the sources
  const auto rock = surrogate::read_rock(data.file("pools/wang/grains.csv"));
  row.because = "Natural neighbours in E, ν, φ and σ_c, as in the paper, are off by";
  for (const int number : {1, 2}) {
    const Type t = type(data, number);
    const Coefficients fe = number == 1 ? pressed(data, t) : in_their_convention(1, 1.5, 1, 1.5);
    const auto three = interpolated(rock, t.grain, surrogate::coordinates_of),
               four = interpolated(rock, t.grain, surrogate::four_coordinates_of);
    for (std::size_t k = 0; k < 4; ++k) {
      const double off = std::abs(regression(printed_regression(data, names[k]), t.grain) / fe[k] - 1);
      const double between = std::abs(three[k] / fe[k] - 1);
      row.because += fmt::format("{} {:.2f} %", k == 0 ? "" : ",", 100 * std::abs(four[k] / fe[k] - 1));
      row.comparisons.push_back({fmt::format("error of (19) in {}, type {}", names[k], number),
                                 data.printed("wang", fmt::format("type_{}.regression.{}", number, names[k])),
                                 off, 0.05, Measure::absolute, fit_error});
      row.comparisons.push_back(
          {fmt::format("error of interpolation in {}, type {}", names[k], number),
           data.printed("wang", fmt::format("type_{}.interpolated.{}", number, names[k])), between, 0.05,
           Measure::absolute, fit_error});
    }
    row.because += number == 1 ? " (a, b, m, n of type 1);" : " (type 2).";
  }
  return row;
}

} // namespace

std::vector<Row> wang_coefficient_rows(const Data& data) {
  return {coefficient_map(data, "wg-fig-7", "Fig. 7", 0),
          coefficient_map(data, "wg-fig-8", "Fig. 8", 1),
          coefficient_map(data, "wg-fig-9", "Fig. 9", 2),
          coefficient_map(data, "wg-fig-10", "Fig. 10", 3),
          force_curves(data, "wg-fig-11", "Fig. 11", 1),
          force_curves(data, "wg-fig-12", "Fig. 12", 2),
          regression_table(data),
          yield_table(data),
          error_table(data)};
}

} // namespace platen::reproduce
