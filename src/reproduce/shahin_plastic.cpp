// Shahin's thesis, chapter 2: elastic, perfectly plastic spheres in three loadings, and the law over them.

#include "reproduce/shahin.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::reproduce {
namespace {

using law::LoadingCase;

// --- raw curves ---

std::vector<Compared> presses(const std::vector<Metal>& list) {
  std::vector<Compared> result;
  for (const Metal& m : list) result.push_back({fmt::format("λ = {:.0f}", m.lambda), &m.curve});
  return result;
}

Row raw_simple(const Data& data) {
  Row row{"sh-fig-2-9", "Fig. 2.9", "simple loading: pressure, radius, force",
          "Five materials. From about 20 % on the curves run together.",
          "Overlap from which on the forces of our softest and stiffest row differ by less than 5 %."};
  const auto list = rows_of_table_a1(data, LoadingCase::simple);
  const BranchCurve &soft = list.front().curve, &stiff = list.back().curve;
  double from = 0.5;
  for (double x = 0.5; x > 0.02 && std::abs(soft.F_at(x) / stiff.F_at(x) - 1) < 0.05; x -= 0.0025) from = x;
  row.comparisons.push_back(
      {"γ/2R from which on they run together", 0.2, from, 0.1, Measure::absolute, 0.05});
  row.charts = three_charts(presses(list), "simple", "σ_y");
  return row;
}

Row raw_confined(const Data& data, LoadingCase loading, const char* id, const char* figure, const char* key) {
  const double until = printed(data, key);
  Row row{id, figure, fmt::format("{} loading: pressure, radius, force", name_of(loading)),
          fmt::format("Five materials. The pressure follows that of simple loading to about {:.0f} %.",
                      100 * until),
          "Overlap at which the force of the stiffest row leaves that of simple loading by more than 10 %."};
  const auto list = rows_of_table_a1(data, loading), simple = rows_of_table_a1(data, LoadingCase::simple);
  const BranchCurve &confined = list.back().curve, &alone = simple.back().curve;
  row.comparisons.push_back(
      {"γ/2R up to which the two are alike", until,
       parts_at([&](double x) { return alone.F_at(x); }, [&](double x) { return confined.F_at(x); }, 0.06,
                law::x_of_filled_cell(loading), alike),
       0.05, Measure::absolute, 0.05});
  row.charts = three_charts(presses(list), name_of(loading), "σ_y");
  row.charts[0].y_range = {0, 5};
  row.charts[2].y_range = {0, 5};
  return row;
}

Row raw_sides(const Data& data) {
  Row row{"sh-fig-2-12",
          "Fig. 2.12",
          "side contacts of the die",
          "Pressure, radius and force over the overlap of the primary contacts.",
          "Our die presses.",
          "the curves are in the picture alone; the laws for them are compared under Figs 2.28 to 2.30."};
  const auto list = rows_of_table_a1(data, LoadingCase::die);
  std::vector<BranchCurve> sides;
  for (const Metal& m : list) sides.push_back({m.curve.x, m.curve.F_side, m.curve.a_side, {}, {}});
  std::vector<Compared> compared;
  for (std::size_t i = 0; i < list.size(); ++i)
    compared.push_back({fmt::format("λ = {:.0f}", list[i].lambda), &sides[i]});
  row.charts = three_charts(compared, "die, walls", "σ_y");
  row.charts[0].y_range = {0, 5};
  row.charts[2].y_range = {0, 5};
  return row;
}

Row low_compressibility(const Data& data) {
  Row row{"sh-fig-2-13",
          "Fig. 2.13",
          "low compressibility",
          "Pressure close to the filled cell, steeper the larger ζ = B/σ_y.",
          "Our presses beyond 0.8 of the filled cell.",
          "the curves are in the picture alone; how they rise is compared under Fig. 2.20."};
  for (const LoadingCase loading : {LoadingCase::hydrostatic, LoadingCase::die}) {
    Chart chart{name_of(loading), overlap_label, "pressure  F/(πa²σ_y)", {}};
    for (const Metal& m : rows_of_table_a1(data, loading)) {
      Series series{fmt::format("ζ = {:.0f}", m.zeta), Mark::line, {}, {}};
      for (std::size_t i = 0; i < m.curve.x.size(); ++i)
        if (m.curve.x[i] > 0.8 * law::x_of_filled_cell(loading)) {
          series.x.push_back(m.curve.x[i]);
          series.y.push_back(m.curve.F[i] / (m.curve.a[i] * m.curve.a[i]));
        }
      chart.series.push_back(std::move(series));
    }
    row.charts.push_back(std::move(chart));
  }
  return row;
}

// --- the law over the presses ---

Row law_over_presses(const Data& data, LoadingCase loading, const char* id, const char* figure) {
  Row row{id, figure, fmt::format("the law over finite elements, {}", name_of(loading)),
          "Softest and stiffest material; excellent agreement.",
          "The published law against our presses of the same rows, γ/2R from 0.06 to 0.9 of the limit."};
  const auto list = rows_of_table_a1(data, loading);
  std::vector<Compared> compared;
  for (const Metal* m : {&list.front(), &list.back()}) {
    const auto law = m->published();
    const auto x = compared_overlaps(loading, m->curve);
    Compared c{fmt::format("λ = {:.0f}", m->lambda), &m->curve, x};
    std::vector<double> F, a;
    for (const double at : x) {
      const auto point = law.at(at);
      c.F.push_back(point.F);
      c.a.push_back(point.a);
      c.H.push_back(point.H);
      F.push_back(m->curve.F_at(at));
      a.push_back(m->curve.a_at(at));
    }
    row.comparisons.push_back(overlay(fmt::format("F̄ at {}", c.name), "γ/2R", x, c.F, F, 0.1, force_error));
    row.comparisons.push_back(
        overlay(fmt::format("a/R at {}", c.name), "γ/2R", x, c.a, a, 0.05, radius_error));
    compared.push_back(std::move(c));
  }
  std::vector<double> before, after;
  for (const Metal& m : list)
    if (const auto published = m["published_force_largest"], fitted = m["force_largest"];
        published && fitted) {
      before.push_back(*published);
      after.push_back(*fitted);
    }
  if (!before.empty())
    row.because = fmt::format("Largest error of the force, over our {} rows of this loading: closed forms "
                              "{:.1f} % median, {:.1f} % worst; with coefficients of each curve {:.1f} % and "
                              "{:.1f} %.",
                              before.size(), 100 * median(before), 100 * largest(before), 100 * median(after),
                              100 * largest(after));
  row.charts = three_charts(compared, name_of(loading), "σ_y");
  if (loading != LoadingCase::simple) {
    row.charts[0].y_range = {0, 5};
    row.charts[2].y_range = {0, 5};
  }
  return row;
}

} // namespace

std::vector<Row> raw_rows(const Data& data) {
  return {raw_simple(data),
          raw_confined(data, LoadingCase::die, "sh-fig-2-10", "Fig. 2.10", "die_follows_simple_until"),
          raw_confined(data, LoadingCase::hydrostatic, "sh-fig-2-11", "Fig. 2.11",
                       "hydrostatic_follows_simple_until"),
          raw_sides(data), low_compressibility(data)};
}

std::vector<Row> plastic_law_rows(const Data& data) {
  return {law_over_presses(data, LoadingCase::simple, "sh-fig-2-21", "Fig. 2.21"),
          law_over_presses(data, LoadingCase::die, "sh-fig-2-22", "Fig. 2.22"),
          law_over_presses(data, LoadingCase::hydrostatic, "sh-fig-2-23", "Fig. 2.23")};
}

} // namespace platen::reproduce
