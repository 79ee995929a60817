// Shahin's thesis, section 2.6: contacts with the walls of a die.

#include "platen/law/agarwal_secondary.hpp"
#include "reproduce/shahin.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::reproduce {
namespace {

using law::LoadingCase;

// --- side contacts ---

struct Sides {
  double lambda, tau, omega; ///< of our press, gamma_s/R = tau (gamma/R)^omega
  double at(double x) const { return tau * std::pow(2 * x, omega); }
};

std::vector<Sides> sides(const Data& data) {
  std::vector<Sides> list;
  for (const Metal& m : rows_of_table_a1(data, LoadingCase::simple))
    if (m["tau"]) list.push_back({m.lambda, *m["tau"], *m["omega"]});
  return list;
}

double published_side(double lambda, double x) { return 2 * law::secondary_overlap(lambda, x); }

Chart side_chart(const std::vector<Sides>& list) {
  Chart chart{"sides in simple loading", "γ/R", "γ_s/R", {}};
  constexpr const char* shades[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7"};
  const auto x = even(0.005, 0.1, 40);
  std::vector<double> gamma;
  for (const double at : x) gamma.push_back(2 * at);
  std::size_t place = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_drawn(i, list.size())) continue;
    const char* const shade = shades[place++];
    chart.series.push_back({fmt::format("λ = {:.0f}", list[i].lambda), Mark::line, gamma,
                            values(x, [&](double at) { return list[i].at(at); }), shade});
    chart.series.push_back({"(2.49)", Mark::dashed, gamma,
                            values(x, [&](double at) { return published_side(list[i].lambda, at); }), shade});
  }
  return chart;
}

Row side_motion(const Data& data) {
  Row row{"sh-fig-2-25",
          "Fig. 2.25",
          "how far the sides move in simple loading",
          "γ_s over γ of five materials; the power law (2.49) with (2.50), (2.51) holds for them.",
          "γ_s/R of our presses at γ/2R = 0.1, in the form (2.49), against the printed law in units of R = "
          "10 mm.",
          "(2.49) has no units: its lengths are mm for R = 10 mm."};
  for (const Sides& s : sides(data))
    row.comparisons.push_back({fmt::format("γ_s/R at γ/2R = 0.1, λ = {:.0f}", s.lambda),
                               published_side(s.lambda, 0.1), s.at(0.1), 0.2, Measure::relative, 0.05});
  row.charts.push_back(side_chart(sides(data)));
  return row;
}

Row side_coefficients(const Data& data) {
  Row row{"sh-fig-2-26",
          "Fig. 2.26",
          "τ and ω of the sides",
          "Closed forms (2.50), (2.51) over λ.",
          "Fits of (2.49) to our presses, in units of R.",
          "τ and ω make up for each other."};
  std::vector<double> lambda, tau, omega, tau_printed, omega_printed;
  for (const Sides& s : sides(data)) {
    lambda.push_back(s.lambda);
    tau.push_back(s.tau);
    omega.push_back(s.omega);
    tau_printed.push_back(law::side_motion(s.lambda).tau);
    omega_printed.push_back(law::side_motion(s.lambda).omega);
  }
  row.comparisons = {overlay("τ in units of R", "λ", lambda, tau_printed, tau, 0.25, fit_error),
                     overlay("ω", "λ", lambda, omega_printed, omega, 0.1, fit_error)};
  for (const auto& [name, ours, theirs] :
       {std::tuple{"ω", &omega, &omega_printed}, {"τ", &tau, &tau_printed}}) {
    Chart chart{
        fmt::format("{} of (2.49)", name), lambda_label, fmt::format("{}  [–], lengths in R", name), {}};
    chart.log_x = true;
    chart.series = {{"press", Mark::points, lambda, *ours}, {"closed form", Mark::dashed, lambda, *theirs}};
    row.charts.push_back(std::move(chart));
  }
  return row;
}

Row side_law(const Data& data) {
  Row row{"sh-fig-2-27", "Fig. 2.27", "the power law of the sides over finite elements",
          "Softest and stiffest material; excellent agreement.",
          "The printed law against our presses at γ/2R = 0.05 and 0.1."};
  const auto list = sides(data);
  for (const Sides* s : {&list.front(), &list.back()})
    for (const double x : {0.05, 0.1})
      row.comparisons.push_back({fmt::format("γ_s/R at γ/2R = {}, λ = {:.0f}", x, s->lambda),
                                 published_side(s->lambda, x), s->at(x), 0.2, Measure::relative, 0.05});
  row.charts.push_back(side_chart({list.front(), list.back()}));
  return row;
}

Row side_density_product(const Data& data) {
  Row row{"sh-fig-2-28", "Fig. 2.28", "density product of the side contacts",
          "Where it passes Γ = 0.0593 the sides enter low compressibility; read through Table 2.4.",
          "The same product of our die presses."};
  Chart chart{"(2.52), walls of the die", overlap_label, "ρ_V ρ_S  [–]", {}};
  for (const Metal& m : rows_of_table_a1(data, LoadingCase::die)) {
    Series series{fmt::format("λ = {:.0f}", m.lambda), Mark::line, {}, {}};
    for (std::size_t i = 0; i < m.curve.x.size(); ++i) {
      series.x.push_back(m.curve.x[i]);
      series.y.push_back(std::pow(std::numbers::pi * m.curve.a_side[i] / (12 * (1 - m.curve.x[i])), 2));
    }
    if (const auto onset = m["side_onset"])
      row.comparisons.push_back(
          {fmt::format("product at the printed onset, λ = {:.0f}", m.lambda), printed(data, "Gamma"),
           std::pow(
               std::numbers::pi *
                   BranchCurve{m.curve.x, {}, m.curve.a_side, {}, {}}.a_at(law::secondary_onset(m.lambda)) /
                   (12 * (1 - law::secondary_onset(m.lambda))),
               2),
           0.05, Measure::relative, 2 * radius_error});
    chart.series.push_back(std::move(series));
  }
  chart.series.push_back({"0.0593", Mark::dashed, {0, 0.47}, {0.0593, 0.0593}});
  row.charts.push_back(std::move(chart));
  return row;
}

Row side_force(const Data& data) {
  Row row{"sh-fig-2-29",
          "Fig. 2.29",
          "radius and force of the side contacts, small overlap",
          "The law for γ/2R up to 0.1: comparable and of the same order, not excellent.",
          "The law against our die presses at γ/2R = 0.1.",
          "The thesis says itself that its mesh is too coarse for these small contacts; ours is as well for "
          "λ in the thousands."};
  Chart chart{"side force, γ/2R ≤ 0.1", overlap_label, "F̄ = F/(πR²σ_y)", {}};
  const auto metals = rows_of_table_a1(data, LoadingCase::die);
  for (const Metal& m : metals) {
    const auto law = m.published();
    const auto side = law::secondary_contact(law, 0.1);
    const BranchCurve walls{m.curve.x, m.curve.F_side, m.curve.a_side, {}, {}};
    row.comparisons.push_back({fmt::format("side F̄ at γ/2R = 0.1, λ = {:.0f}", m.lambda), *side.F_bar,
                               walls.F_at(0.1), 0.5, Measure::relative, 0.1});
    if (!is_drawn(static_cast<std::size_t>(&m - metals.data()), metals.size())) continue;
    const auto x = even(0.01, 0.1, 19);
    chart.series.push_back({fmt::format("press, λ = {:.0f}", m.lambda), Mark::line, x,
                            values(x, [&](double at) { return walls.F_at(at); })});
    chart.series.push_back({fmt::format("law, λ = {:.0f}", m.lambda), Mark::dashed, x,
                            values(x, [&](double at) { return *law::secondary_contact(law, at).F_bar; })});
  }
  row.charts.push_back(std::move(chart));
  return row;
}

Row side_pressure(const Data& data) {
  Row row{"sh-fig-2-30", "Fig. 2.30", "pressure of the side contacts, small and large overlap",
          "Beyond the onset of Table 2.4 the sides carry the pressure of the primary contacts; good "
          "agreement there.",
          "That pressure of the law against our walls, from the onset to 0.98 of the filled cell."};
  Chart chart{"side pressure", overlap_label, "pressure  F/(πa²σ_y)", {}};
  chart.y_range = {0, 5};
  const auto metals = rows_of_table_a1(data, LoadingCase::die);
  for (const Metal& m : metals) {
    const auto law = m.published();
    const BranchCurve walls{m.curve.x, m.curve.F_side, m.curve.a_side, {}, {}};
    std::vector<double> x, theirs, ours;
    for (const double at : m.curve.x)
      if (at > law::secondary_onset(m.lambda) && at < 0.98 * law::x_of_filled_cell(LoadingCase::die)) {
        x.push_back(at);
        theirs.push_back(*law::secondary_contact(law, at).H_bar);
        ours.push_back(walls.H_at(at));
      }
    row.comparisons.push_back(overlay(fmt::format("side pressure, λ = {:.0f}", m.lambda), "γ/2R", x, theirs,
                                      ours, 0.15, pressure_error));
    if (!is_drawn(static_cast<std::size_t>(&m - metals.data()), metals.size())) continue;
    const auto all = even(0.05, 0.47, 85);
    chart.series.push_back({fmt::format("press, λ = {:.0f}", m.lambda), Mark::line, all,
                            values(all, [&](double at) { return walls.H_at(at); })});
    chart.series.push_back({"law", Mark::dashed, x, theirs});
  }
  row.charts.push_back(std::move(chart));
  return row;
}

} // namespace

std::vector<Row> side_rows(const Data& data) {
  return {side_motion(data),          side_coefficients(data), side_law(data),
          side_density_product(data), side_force(data),        side_pressure(data)};
}

} // namespace platen::reproduce
