// Shahin's thesis, chapter 2 and appendix C: elastic, perfectly plastic spheres alone, in a die, pressed from
// all sides.

#include "fit/golden.hpp"
#include "material/card.hpp"
#include "material/models.hpp"
#include "platen/law/agarwal_secondary.hpp"
#include "reproduce/metals.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::reproduce {
namespace {

using law::LoadingCase;
constexpr LoadingCase loadings[] = {LoadingCase::simple, LoadingCase::die, LoadingCase::hydrostatic};
constexpr const char* overlap_label = "overlap  γ/2R = δ/R";
constexpr double alike = 0.1; ///< of the force: what "similar" is taken to mean
constexpr const char* lambda_label = "λ = E/((1 − ν²)σ_y)";

double printed(const Data& data, const std::string& key) { return data.printed("shahin", key); }

// --- introduction: lead ---

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

/// The first grid overlap from `from` on where two curves differ by more than a share of the first; nothing
/// where none does.
template <class One, class Other>
double parts_at(const One& one, const Other& other, double from, double to, double share) {
  for (double x = from; x <= to; x += 0.0025)
    if (std::abs(other(x) / one(x) - 1) > share) return x;
  return to;
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
  for (std::size_t i = 0; i < list.size(); ++i) {
    chart.series.push_back({fmt::format("λ = {:.0f}", list[i].lambda), Mark::line, gamma,
                            values(x, [&](double at) { return list[i].at(at); }), shades[i % 4]});
    chart.series.push_back({"(2.49)", Mark::dashed, gamma,
                            values(x, [&](double at) { return published_side(list[i].lambda, at); }),
                            shades[i % 4]});
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
  for (const Metal& m : rows_of_table_a1(data, LoadingCase::die)) {
    const auto law = m.published();
    const auto side = law::secondary_contact(law, 0.1);
    const BranchCurve walls{m.curve.x, m.curve.F_side, m.curve.a_side, {}, {}};
    row.comparisons.push_back({fmt::format("side F̄ at γ/2R = 0.1, λ = {:.0f}", m.lambda), *side.F_bar,
                               walls.F_at(0.1), 0.5, Measure::relative, 0.1});
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
  for (const Metal& m : rows_of_table_a1(data, LoadingCase::die)) {
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
    const auto all = even(0.05, 0.47, 85);
    chart.series.push_back({fmt::format("press, λ = {:.0f}", m.lambda), Mark::line, all,
                            values(all, [&](double at) { return walls.H_at(at); })});
    chart.series.push_back({"law", Mark::dashed, x, theirs});
  }
  row.charts.push_back(std::move(chart));
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

std::vector<Row> shahin_plastic_rows(const Data& data) {
  return {lead_in_three_loadings(data),
          energies(data),
          strain_maps(data),
          design(data),
          raw_simple(data),
          raw_confined(data, LoadingCase::die, "sh-fig-2-10", "Fig. 2.10", "die_follows_simple_until"),
          raw_confined(data, LoadingCase::hydrostatic, "sh-fig-2-11", "Fig. 2.11",
                       "hydrostatic_follows_simple_until"),
          raw_sides(data),
          low_compressibility(data),
          radius_coefficients(data),
          greatest_pressure(data),
          influence_of_parameters(data),
          density_product(data),
          least_pressure(data),
          softening(data),
          compressibility_coefficient(data),
          law_over_presses(data, LoadingCase::simple, "sh-fig-2-21", "Fig. 2.21"),
          law_over_presses(data, LoadingCase::die, "sh-fig-2-22", "Fig. 2.22"),
          law_over_presses(data, LoadingCase::hydrostatic, "sh-fig-2-23", "Fig. 2.23"),
          side_motion(data),
          side_coefficients(data),
          side_law(data),
          side_density_product(data),
          side_force(data),
          side_pressure(data),
          radius_table(data),
          onset_table(data)};
}

} // namespace platen::reproduce
