// Shahin's thesis, sections 2.1 to 2.3: lead alone, in a die, pressed from all sides; the design of the
// presses.

#include "fit/golden.hpp"
#include "reproduce/shahin.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::reproduce {
namespace {

using law::LoadingCase;

/// sigma(epsilon) of sigma = sigma_y + K epsilon_plastic^(1/n), epsilon = epsilon_plastic + sigma/E, by
/// bisection.
double ludwik(double epsilon, double E, double sigma_y, double K, double n) {
  double low = 0, high = sigma_y + K * std::pow(epsilon, 1 / n);
  for (int i = 0; i < 60; ++i) {
    const double sigma = (low + high) / 2, plastic = sigma > sigma_y ? std::pow((sigma - sigma_y) / K, n) : 0;
    (plastic + sigma / E < epsilon ? low : high) = sigma;
  }
  return (low + high) / 2;
}

/// Pressure over kappa of the similarity solution (2.4), (2.5) for two equal spheres.
double similarity_pressure(double x, double inverse_m) {
  return 3 * std::pow(6, -inverse_m) *
         std::pow(std::sqrt(2 * 1.43 * std::exp(-0.97 * inverse_m) * x), inverse_m);
}
double similarity_radius(double x, double inverse_m) {
  return std::sqrt(2 * 1.43 * std::exp(-0.97 * inverse_m) * x);
}

/// A press of lead with its pressure over kappa instead of the yield stress.
BranchCurve lead(const Data& data, LoadingCase loading) {
  const press::Curve& curve = data.press("lead-" + name_of(loading));
  BranchCurve branch = loading_of(curve);
  for (double& F : branch.F) F *= curve.sigma_ref_Pa / (1e6 * printed(data, "lead.kappa_MPa"));
  return branch;
}

Row lead_in_three_loadings(const Data& data) {
  Row row{"sh-fig-2-1",
          "Fig. 2.1",
          "lead alone, in a die and pressed from all sides, with the similarity solution",
          "Ludwik's lead (K = 15.5 MPa, n = 2.857) is also κ = 20.5 MPa, m = 4.167. The similarity solution "
          "leaves the curves at about 3 %; the three "
          "loadings are alike below 10 %.",
          "κ and m by least squares over strains from 0 to 1.5; overlap at which the force of the "
          "similarity solution, and of the other loadings, is 10 % off that of simple loading.",
          "The yield stress, 5 MPa, is not printed: it was chosen so that κ and m come out."};
  const double K = 1e6 * printed(data, "lead.K_MPa"), n = printed(data, "lead.n");
  const auto strains = even(0.005, 1.5, 300);
  const auto stress = values(strains, [&](double e) { return ludwik(e, 10e9, 5e6, K, n); });
  const auto kappa_of = [&](double inverse_m) {
    double fy = 0, ff = 0;
    for (std::size_t i = 0; i < strains.size(); ++i) {
      const double f = std::pow(strains[i], inverse_m);
      fy += f * stress[i];
      ff += f * f;
    }
    return fy / ff;
  };
  const auto off = [&](double inverse_m) {
    double sum = 0;
    for (std::size_t i = 0; i < strains.size(); ++i)
      sum += std::pow(kappa_of(inverse_m) * std::pow(strains[i], inverse_m) - stress[i], 2);
    return sum;
  };
  const double inverse_m = fit::golden_section(off, 0.05, 0.6, 60).at;
  const BranchCurve simple = lead(data, LoadingCase::simple), die = lead(data, LoadingCase::die),
                    hydro = lead(data, LoadingCase::hydrostatic);
  const double m = 1 / printed(data, "lead.m");
  const auto F = [](const BranchCurve& c) { return [&c](double x) { return c.F_at(x); }; };
  const auto F_similar = [&](double x) {
    return similarity_pressure(x, m) * std::pow(similarity_radius(x, m), 2);
  };
  row.comparisons = {{"κ (MPa)", printed(data, "lead.kappa_MPa"), kappa_of(inverse_m) / 1e6, 0.01,
                      Measure::relative, formula_error},
                     {"m", printed(data, "lead.m"), 1 / inverse_m, 0.01, Measure::relative, formula_error},
                     {"γ/2R up to which the similarity solution holds", printed(data, "similarity_until"),
                      parts_at(F(simple), F_similar, 0.02, 0.5, alike), 0.02, Measure::absolute, 0.05},
                     {"γ/2R up to which die and simple are alike", printed(data, "alike_until"),
                      parts_at(F(simple), F(die), 0.03, 0.47, alike), 0.05, Measure::absolute, 0.05},
                     {"γ/2R up to which hydrostatic and simple are alike", printed(data, "alike_until"),
                      parts_at(F(simple), F(hydro), 0.03, 0.19, alike), 0.05, Measure::absolute, 0.05}};
  std::vector<Compared> list = {{"simple", &simple}, {"die", &die}, {"hydrostatic", &hydro}};
  row.charts = three_charts(list, "lead, κ = 20.5 MPa", "κ");
  const auto x = even(0.005, 0.3, 60);
  row.charts[0].series.push_back({"similarity", Mark::dashed, x,
                                  values(x, [&](double at) { return similarity_pressure(at, m); }),
                                  "#444444"});
  row.charts[1].series.push_back({"similarity", Mark::dashed, x,
                                  values(x, [&](double at) { return similarity_radius(at, m); }), "#444444"});
  row.charts[2].series.push_back({"similarity", Mark::dashed, x, values(x, F_similar), "#444444"});
  row.charts[0].y_range = {0, 8};
  row.charts[2].y_range = {0, 8};
  return row;
}

Row energies(const Data& data) {
  Row row{"sh-fig-2-3",
          "Fig. 2.3",
          "pressure and energy of lead, pressed from all sides",
          "Work and stored energy over the overlap, with five regimes marked.",
          "Our press of the same lead.",
          "the regimes are marked in the picture alone."};
  const press::Curve& curve = data.press("lead-hydrostatic");
  Chart chart{"lead, hydrostatic: energies of one side", overlap_label, "energy/(κR³)", {}};
  chart.log_y = true;
  const double unit = 1e6 * printed(data, "lead.kappa_MPa") * std::pow(curve.radius_m, 3);
  const auto add = [&](const char* name, double press::CurvePoint::*member) {
    Series series{name, Mark::line, {}, {}};
    for (const auto& point : curve.points)
      if (point.branch == press::Branch::loading) {
        series.x.push_back(point.delta_bar);
        series.y.push_back(point.*member / unit);
      }
    chart.series.push_back(std::move(series));
  };
  add("work", &press::CurvePoint::work_J);
  add("stored", &press::CurvePoint::stored_J);
  add("dissipated", &press::CurvePoint::dissipated_J);
  row.charts.push_back(std::move(chart));
  return row;
}

Row strain_maps(const Data&) {
  return {"sh-fig-2-4",
          "Fig. 2.4",
          "plastic strain in lead, pressed from all sides",
          "Maps at several overlaps.",
          "–",
          "maps are in the picture alone, without numbers; `platen press` draws ours (`fields_at`)."};
}

Row design(const Data& data) {
  Row row{"sh-fig-2-6", "Fig. 2.6", "the 51 materials", "E, ν, σ_y of Table A.1, with λ printed beside.",
          "λ computed again from the printed E, ν, σ_y."};
  const core::Csv table = data.table("shahin-table-a1.csv");
  std::vector<double> number, theirs, ours;
  Chart chart{"Table A.1", "E (MPa)", lambda_label, {}};
  chart.log_x = chart.log_y = true;
  for (const char* loading : {"simple", "die", "hydro"}) {
    Series series{loading, Mark::points, {}, {}};
    for (const auto& line : table.rows) {
      if (line.cells[table.column("loading")] != loading) continue;
      const double E = table.number(line, table.column("E_MPa")), nu = table.number(line, table.column("nu"));
      number.push_back(static_cast<double>(number.size() + 1));
      theirs.push_back(table.number(line, table.column("lambda_printed")));
      ours.push_back(E / ((1 - nu * nu) * table.number(line, table.column("sigma_y_MPa"))));
      series.x.push_back(E);
      series.y.push_back(ours.back());
    }
    chart.series.push_back(std::move(series));
  }
  row.comparisons.push_back(overlay("λ", "row", number, theirs, ours, 5e-3, formula_error));
  row.charts.push_back(std::move(chart));
  return row;
}

} // namespace

std::vector<Row> lead_rows(const Data& data) {
  return {lead_in_three_loadings(data), energies(data), strain_maps(data), design(data)};
}

} // namespace platen::reproduce
