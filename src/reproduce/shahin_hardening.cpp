// Shahin's thesis, chapter 3: spheres that harden as sigma = kappa epsilon^(1/m); and what follows from its
// formulas alone.

#include "reproduce/metals.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::reproduce {
namespace {

using law::LoadingCase, law::ShahinVariant;
constexpr LoadingCase loadings[] = {LoadingCase::simple, LoadingCase::die, LoadingCase::hydrostatic};

double printed(const Data& data, const std::string& key) { return data.printed("shahin", key); }

// --- formulas ---

/// D_i at a lambda: (2.14) with Table 2.2 and b^(i/2).
double radius_coefficient(const Data& data, int i, LoadingCase loading, double lambda) {
  const auto number = [&](const std::string& name) { return printed(data, fmt::format("T2_2.{}", name)); };
  const double b = loading == LoadingCase::simple ? 1 : number(fmt::format("b_{}_{}", i, name_of(loading)));
  return std::pow(b, i / 2.0) * number(fmt::format("alpha_{}", i)) *
         std::tanh(number(fmt::format("beta_{}", i)) * std::pow(lambda, number(fmt::format("delta_{}", i))));
}

constexpr double rigid_plastic = 1e30; ///< lambda

Row limit_table(const Data& data) {
  Row row{"sh-table-3-1",
          "Table 3.1",
          "D₁, D₃, D₅ of the rigid-plastic limit",
          "Nine values.",
          "(2.14) for λ → ∞ with the numbers of Table 2.2 and b^{i/2}.",
          "D₅ of hydrostatic loading is printed 39.8654 and must be 49.87: Table C.1 follows only from that. "
          "With the printed exponent, b^{1/2}, D₃ and D₅ of both confined loadings would be "
          "far off."};
  for (const LoadingCase loading : loadings)
    for (const int i : {1, 3, 5})
      row.comparisons.push_back({fmt::format("D{}, {}", i, name_of(loading)),
                                 printed(data, fmt::format("T3_1.D{}_{}", i, name_of(loading))),
                                 radius_coefficient(data, i, loading, rigid_plastic), 2e-4, Measure::relative,
                                 formula_error});
  return row;
}

/// Discriminants (C.9), (C.10) over 4 R^2.
double discriminant(const Data& data, int which, LoadingCase loading, double lambda) {
  const auto D = [&](int i) { return radius_coefficient(data, i, loading, lambda); };
  return which == 1 ? D(3) * D(3) - 4 * D(1) * D(5) : 9 * D(3) * D(3) - 20 * D(1) * D(5);
}

void add_limits(const Data& data, Row& row) {
  for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic})
    for (const int which : {1, 2})
      row.comparisons.push_back({fmt::format("F{}, {}", which, name_of(loading)),
                                 printed(data, fmt::format("TC_1.F{}_{}", which, name_of(loading))),
                                 discriminant(data, which, loading, rigid_plastic), 2e-3, Measure::relative,
                                 formula_error});
}

Row discriminants(const Data& data) {
  Row row{"sh-fig-c", "App. C", "figures: discriminants over λ",
          "Negative for every λ; the figures have no number.",
          "The same discriminants; their ends against Table C.1."};
  for (const LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic}) {
    Chart chart{name_of(loading), "λ = E/((1 − ν²)σ_y)", "discriminant/4R²", {}};
    chart.log_x = true;
    const auto lambda = even_in_logarithm(1, 1e4, 80);
    double top = -HUGE_VAL;
    for (const int which : {1, 2}) {
      chart.series.push_back({fmt::format("F{}", which), Mark::line, lambda, values(lambda, [&](double at) {
                                return discriminant(data, which, loading, at);
                              })});
      top = std::max(top, largest(chart.series.back().y));
    }
    row.because += fmt::format("{}: largest of both for λ from 1 to 10,000 {:.3g}. ", name_of(loading), top);
    row.charts.push_back(std::move(chart));
  }
  add_limits(data, row);
  return row;
}

Row discriminant_table(const Data& data) {
  Row row{"sh-table-c-1",
          "Table C.1",
          "limits of the discriminants",
          "−31.76, −121.70, −300.49, −1191.71.",
          "(C.9), (C.10) with the D of Table 2.2.",
          "They follow from D₅ = 49.87 in hydrostatic loading, not from the 39.8654 of Table 3.1."};
  add_limits(data, row);
  return row;
}

// --- chapter 3 ---

Row design(const Data& data) {
  Row row{"sh-fig-3-1",
          "Fig. 3.1",
          "the 60 hardening materials",
          "1/m from 0 to 1, κ from 50 to 200 MPa.",
          "The rows of Table E.1.",
          "it shows the input, Table E.1; there is nothing of ours to set against it."};
  const core::Csv table = data.table("shahin-table-e1.csv");
  Chart chart{"Table E.1", "hardening exponent 1/m", "κ (MPa)", {}};
  for (const char* loading : {"simple", "die", "hydro"}) {
    Series series{loading, Mark::points, {}, {}};
    for (const auto& line : table.rows)
      if (line.cells[table.column("loading")] == loading) {
        series.x.push_back(table.number(line, table.column("inverse_m")));
        series.y.push_back(table.number(line, table.column("kappa_MPa")));
      }
    chart.series.push_back(std::move(series));
  }
  row.charts.push_back(std::move(chart));
  return row;
}

/// Points of the law at these overlaps, beside those of a press.
Compared compared_with(const std::string& name, const BranchCurve& press, const law::ShahinCurve<double>& law,
                       const std::vector<double>& x) {
  Compared c{name, &press, x};
  for (const double at : x) {
    const auto point = law.at(at);
    c.F.push_back(point.F);
    c.a.push_back(point.a);
    c.H.push_back(point.H);
  }
  return c;
}

std::vector<double> forces(const BranchCurve& press, const std::vector<double>& x) {
  return values(x, [&](double at) { return press.F_at(at); });
}

void bound_confined(std::vector<Chart>& charts, LoadingCase loading) {
  if (loading == LoadingCase::simple) return;
  charts[0].y_range = {0, 5};
  charts[2].y_range = {0, 5};
}

Row rigid_limit(const Data& data) {
  Row row{"sh-fig-3-2",
          "Fig. 3.2",
          "the rigid-plastic limit over finite elements, 1/m near 0",
          "κ = 20 and 200 MPa; elastic regimes are small.",
          "The limit of the law (1/m = 0) against our stiffest perfectly plastic row of each loading, "
          "pressure from 0.06 to 0.9 of the limit.",
          "E, ν and the yield stress of the thesis's runs are not given; ours have λ of 4,954 to 5,933."};
  for (const LoadingCase loading : loadings) {
    const auto list = rows_of_table_a1(data, loading);
    const Metal& stiffest = list.back();
    const auto x = compared_overlaps(loading, stiffest.curve);
    const Compared c = compared_with(fmt::format("λ = {:.0f}", stiffest.lambda), stiffest.curve,
                                     law::ShahinCurve<double>::make(loading, 0.0), x);
    row.comparisons.push_back(overlay(fmt::format("pressure, {}", name_of(loading)), "γ/2R", x, c.H,
                                      values(x, [&](double at) { return stiffest.curve.H_at(at); }), 0.15,
                                      pressure_error));
    auto charts = three_charts({c}, fmt::format("{}, 1/m = 0", name_of(loading)), "κ");
    bound_confined(charts, loading);
    row.charts.push_back(std::move(charts[0]));
  }
  return row;
}

std::vector<Compared> presses(const std::vector<HardeningMetal>& list) {
  std::vector<Compared> result;
  for (const HardeningMetal& m : list) result.push_back({fmt::format("1/m = {:.3g}", m.inverse_m), &m.curve});
  return result;
}

Row raw_simple(const Data& data) {
  Row row{"sh-fig-3-3", "Fig. 3.3", "simple loading with hardening: radius, pressure, force",
          "20 materials. At 1/m of about 0.5 the pressure stays near 1; beyond it only rises.",
          "Pressure at γ/2R = 0.25 between our two rows around 1/m = 0.5, even in its logarithm."};
  const auto list = hardening_metals(data, LoadingCase::simple);
  const auto above = std::ranges::find_if(list, [](const HardeningMetal& m) { return m.inverse_m > 0.5; });
  row.charts = three_charts(presses(list), "simple", "κ");
  if (above == list.begin() || above == list.end()) {
    row.because = "none of our rows has 1/m beyond 0.5 (below it).";
    return row;
  }
  const auto below = above - 1;
  const double part = (0.5 - below->inverse_m) / (above->inverse_m - below->inverse_m);
  const double H =
      std::exp((1 - part) * std::log(below->curve.H_at(0.25)) + part * std::log(above->curve.H_at(0.25)));
  row.comparisons.push_back({"pressure F/(πa²κ) at 1/m = 0.5", printed(data, "level_at_half"), H, 0.1,
                             Measure::relative, pressure_error});
  return row;
}

/// The largest fall of the pressure, relative, over the compared overlaps.
double softening(const HardeningMetal& m) {
  double top = 0, fall = 0;
  for (const double x : compared_overlaps(m.loading, m.curve)) {
    const double H = m.curve.H_at(x);
    top = std::max(top, H);
    fall = std::max(fall, 1 - H / top);
  }
  return fall;
}

Row raw_confined(const Data& data, LoadingCase loading, const char* id, const char* figure) {
  Row row{id,
          figure,
          fmt::format("{} loading with hardening: radius, pressure, force", name_of(loading)),
          "20 materials. Beyond 1/m = 0.5 the pressure no longer falls anywhere.",
          "Our rows of the same loading.",
          "the curves are in the picture alone. Largest fall of our pressures from 0.06 on:"};
  const auto list = hardening_metals(data, loading);
  for (const HardeningMetal& m : list)
    row.because += fmt::format(" 1/m = {:.2g}: {:.1f} %;", m.inverse_m, 100 * softening(m));
  row.because.back() = '.';
  row.charts = three_charts(presses(list), name_of(loading), "κ");
  bound_confined(row.charts, loading);
  return row;
}

Row law_over_presses(const Data& data, LoadingCase loading, const char* id, const char* figure) {
  Row row{id, figure, fmt::format("the hardening law over finite elements, {}", name_of(loading)),
          "Four exponents; good prediction over the whole range.",
          "The published law against our presses of rows that the figure shows (E = 2,000 κ, beyond 1/m = "
          "0.9 100 κ), γ/2R from 0.06 "
          "to 0.9 of the limit."};
  const auto list = hardening_metals(data, loading);
  std::vector<Compared> compared;
  std::vector<double> published, other;
  for (const HardeningMetal& m : list) {
    const auto x = compared_overlaps(loading, m.curve);
    const auto F = forces(m.curve, x);
    Compared c = compared_with(fmt::format("1/m = {:.3g}", m.inverse_m), m.curve,
                               law::ShahinCurve<double>::make(loading, m.inverse_m), x);
    row.comparisons.push_back(overlay(fmt::format("F̄ at {}", c.name), "γ/2R", x, c.F, F, 0.1, force_error));
    const Compared variant = compared_with(
        c.name, m.curve,
        law::ShahinCurve<double>::make(loading, m.inverse_m, ShahinVariant::hardening_minimum), x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      published.push_back(std::abs(c.F[i] / F[i] - 1));
      other.push_back(std::abs(variant.F[i] / F[i] - 1));
    }
    compared.push_back(std::move(c));
  }
  if (loading != LoadingCase::simple)
    row.because = fmt::format(
        "Captions of Figs 3.7 and 3.8 say \"simple\". The thesis leaves open of which radius γ_min is: with "
        "that of 1/m = 0 (published) the force is {:.1f} % (median) and "
        "{:.0f} % (worst) off, with that of each 1/m (hardening-minimum) {:.1f} and {:.0f} %.",
        100 * median(published), 100 * largest(published), 100 * median(other), 100 * largest(other));
  row.charts = three_charts(compared, name_of(loading), "κ");
  bound_confined(row.charts, loading);
  return row;
}

Row cellulose(const Data&) {
  return {"sh-fig-3-9",
          "Fig. 3.9",
          "the law through measured particles of cellulose",
          "1/m = 0.6585, κ = 6.0272 MPa fitted to measured points.",
          "–",
          "the measured points are in the picture, and in another paper, alone."};
}

Row cellulose_radius(const Data& data) {
  Row row{"sh-fig-3-10", "Fig. 3.10", "contact radius that the law gives cellulose",
          "Three loadings, 1/m = 0.6585; curves of the formula (3.47).",
          "The formula against our presses of the nearest rows (1/m = 0.66 to 0.69), γ/2R from 0.06 to 0.9 "
          "of the limit."};
  const double inverse_m = printed(data, "mcc.inverse_m");
  Chart chart{"1/m = 0.6585", "overlap  γ/2R = δ/R", "contact radius  a/R", {}};
  constexpr const char* shades[] = {"#0072b2", "#d55e00", "#009e73"};
  std::size_t place = 0;
  for (const LoadingCase loading : loadings) {
    const auto list = hardening_metals(data, loading);
    const auto& nearest = *std::ranges::min_element(
        list, {}, [&](const HardeningMetal& m) { return std::abs(m.inverse_m - inverse_m); });
    const auto x = compared_overlaps(loading, nearest.curve);
    const Compared c =
        compared_with("", nearest.curve, law::ShahinCurve<double>::make(loading, inverse_m), x);
    row.comparisons.push_back(
        overlay(fmt::format("a/R, {} (ours 1/m = {:.3g})", name_of(loading), nearest.inverse_m), "γ/2R", x,
                c.a, values(x, [&](double at) { return nearest.curve.a_at(at); }), 0.1, radius_error));
    chart.series.push_back({fmt::format("{}, press", name_of(loading)), Mark::line, nearest.curve.x,
                            nearest.curve.a, shades[place]});
    chart.series.push_back({"law", Mark::dashed, x, c.a, shades[place++]});
  }
  row.charts.push_back(std::move(chart));
  return row;
}

} // namespace

std::vector<Row> shahin_hardening_rows(const Data& data) {
  return {limit_table(data),
          design(data),
          rigid_limit(data),
          raw_simple(data),
          raw_confined(data, LoadingCase::die, "sh-fig-3-4", "Fig. 3.4"),
          raw_confined(data, LoadingCase::hydrostatic, "sh-fig-3-5", "Fig. 3.5"),
          law_over_presses(data, LoadingCase::simple, "sh-fig-3-6", "Fig. 3.6"),
          law_over_presses(data, LoadingCase::die, "sh-fig-3-7", "Fig. 3.7"),
          law_over_presses(data, LoadingCase::hydrostatic, "sh-fig-3-8", "Fig. 3.8"),
          cellulose(data),
          cellulose_radius(data),
          discriminants(data),
          discriminant_table(data)};
}

} // namespace platen::reproduce
