// Edmans & Sinka: the law, its errors, its parameters, unloading, and the regressions of Appendix A.

#include "core/number.hpp"
#include "fit/golden.hpp"
#include "fit/least_squares.hpp"
#include "material/card.hpp"
#include "material/yield_curve.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "reproduce/granules.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace platen::reproduce {
namespace {

const std::vector<double> unloaded_from = {0.1, 0.2, 0.3, 0.4, 0.5};

// --- the law and its errors ---

/// Cumulative distribution: share of the runs below a value.
Series distribution(const std::string& name, std::vector<double> v) {
  std::ranges::sort(v);
  Series series{name, Mark::line, v, {}};
  for (std::size_t i = 0; i < v.size(); ++i)
    series.y.push_back(static_cast<double>(i + 1) / static_cast<double>(v.size()));
  return series;
}

/// Least peak error (8) that any law of form (6) has on a curve: k, delta_t and a searched for it alone.
double least_peak_error(const BranchCurve& curve) {
  const double F_end = curve.F.back();
  const auto peak = [&](double k, double delta_t, double a) {
    double worst_of_all = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double x = curve.x[i], law = k * (x <= delta_t ? x : delta_t * std::exp(a * (x - delta_t)));
      worst_of_all = std::max(worst_of_all, std::abs(law - curve.F[i]));
    }
    return worst_of_all / F_end;
  };
  const auto best_k = [&](double delta_t, double a) { // convex in k
    const double shape = delta_t * std::exp(a * (0.5 - delta_t));
    return fit::golden_section([&](double k) { return peak(k, delta_t, a); }, 0.5 * F_end / shape,
                               1.5 * F_end / shape, 18)
        .value;
  };
  const auto best_a = [&](double delta_t) {
    return fit::scanned_minimum([&](double a) { return best_k(delta_t, a); }, even(0, 12, 13), 14).value;
  };
  return fit::scanned_minimum(best_a, even(0.02, 0.48, 24), 8).value;
}

Row error_distributions(const Data& data) {
  const auto printed = [&](const char* key) { return data.printed("edmans-sinka", key); };
  Row row{"es-fig-11", "Fig. 11", "errors of the fitted law over the 160",
          "Median peak error (8) 1.955 %; median area error (7) 0.388 % in 6.1 and 1.03·10⁻⁴ in 6.2; largest "
          "area error 3.96 %.",
          "Form (6) fitted to our 160 curves by least relative L2 error."};
  const Pool& pool = data.pool("edmans-sinka");
  std::vector<double> e_p, e_a, root, square, least_e_p;
  for (const Granule& g : granules(pool)) {
    e_p.push_back(g.e_p);
    e_a.push_back(g.e_a);
    const BranchCurve& curve = pool.loading.at(g.run);
    double squares = 0, area = 0, x_before = 0, d_before = 0, F_before = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double d = std::pow(g.law(curve.x[i]) - curve.F[i], 2), h = curve.x[i] - x_before;
      squares += h * (d + d_before) / 2;
      area += h * (curve.F[i] + F_before) / 2;
      x_before = curve.x[i];
      d_before = d;
      F_before = curve.F[i];
    }
    root.push_back(std::sqrt(squares));
    square.push_back(squares / area);
    least_e_p.push_back(least_peak_error(curve));
  }
  row.comparisons = {
      {"median e_p", printed("fit.e_p_median"), median(e_p), 0.1, Measure::relative, fit_error},
      {"least median e_p that form (6) can have", printed("fit.e_p_median"), median(least_e_p), 0.1,
       Measure::relative, fit_error},
      {"median e_a (6.1)", printed("fit.e_a_median_6_1"), median(e_a), 0.1, Measure::relative, fit_error},
      {"median e_a (6.2)", printed("fit.e_a_median_6_2"), median(e_a), 0.1, Measure::relative, fit_error},
      {"largest e_a", printed("fit.e_a_largest"), largest(e_a), 0.1, Measure::relative, fit_error}};
  row.because =
      fmt::format("No law of form (6) comes nearer to our curves than a median peak error of {:.2f} % (worst "
                  "{:.1f} %). The two area errors contradict each "
                  "other and (7), by which e_a is of the size of e_p; they may be other measures: (∫ΔF̄² "
                  "dδ̄)^½ has the median {:.2g} %, "
                  "∫ΔF̄² dδ̄/∫F̄ dδ̄ {:.3g}. (8) is read with an absolute value.",
                  100 * median(least_e_p), 100 * largest(least_e_p), 100 * median(root), median(square));
  Chart chart{"errors of form (6), 160 granules", "error", "share of the runs below", {}};
  chart.log_x = true;
  chart.y_range = {0, 1};
  chart.series = {
      distribution("e_p (8)", e_p),
      distribution("e_a (7)", e_a),
      distribution("least e_p", least_e_p),
      {"printed median e_p", Mark::dashed, {printed("fit.e_p_median"), printed("fit.e_p_median")}, {0, 1}}};
  row.charts.push_back(std::move(chart));
  return row;
}

Row example_fits(const Data& data) {
  Row row{"es-fig-12", "Fig. 12", "four granules with their fits",
          "Granules at the 100th, 90th, 75th and 50th percentile of the peak error. Two captions print Γ̄₀ "
          "twice: the second is read as Λ̄₀.",
          "Place of the same granules among our 160, by peak error."};
  const Pool& pool = data.pool("edmans-sinka");
  const auto list = granules(pool);
  struct Example {
    const char* key;
    double E, G, L;
  };
  for (const Example& e :
       {Example{"a", 3, 1, 0.01}, {"b", 50, 1, 0.1}, {"c", 4.5, 1, 1}, {"d", 3, 0.25, 0.1}}) {
    const Granule g = granule(pool, e.E, e.G, e.L);
    const auto below = std::ranges::count_if(list, [&](const Granule& other) { return other.e_p <= g.e_p; });
    row.comparisons.push_back({fmt::format("percentile of {}", name_of(e.E, e.G, e.L)),
                               data.printed("edmans-sinka", fmt::format("fig_12{}.percentile", e.key)),
                               static_cast<double>(below) / static_cast<double>(list.size()), 0.1,
                               Measure::absolute, 0.05});
    const BranchCurve& curve = pool.loading.at(g.run);
    Chart chart{fmt::format("{}: e_p = {:.1f} %", name_of(e.E, e.G, e.L), 100 * g.e_p),
                overlap_label,
                force_label,
                {}};
    chart.series = {force("press", curve),
                    {"form (6)", Mark::dashed, curve.x, values(curve.x, [&](double x) { return g.law(x); })}};
    row.charts.push_back(std::move(chart));
  }
  row.because = "Where two fits are nearly as good, the order of the 160 is not a robust number.";
  return row;
}

// --- parameters of the law ---

struct Parameter {
  const char* name;
  double Granule::*of;
  double law::AppendixA::*regression;
  double tolerance;
};
constexpr Parameter parameters[] = {{"k", &Granule::k, &law::AppendixA::k, 0.15},
                                    {"delta_t", &Granule::delta_t, &law::AppendixA::delta_t, 0.25},
                                    {"a", &Granule::a, &law::AppendixA::a, 0.25}};

Row law_parameters(const Data& data) {
  Row row{"es-fig-13", "Fig. 13", "k, δ̄_t and a over the stiffness",
          "Points of the 160, grouped by Γ̄₀; readable through the regressions of Appendix A (the two "
          "misprints corrected).",
          "Ours, mean over the four Λ̄₀, against the regression at Ē₀ = 100 for each Γ̄₀."};
  const auto list = granules(data.pool("edmans-sinka"));
  for (const Parameter& p : parameters) {
    std::vector<double> strengths = {0.25, 0.5, 0.75, 1}, theirs, ours;
    Chart chart{fmt::format("{} of form (6)", p.name), "Ē₀ = E₀/σ_y", fmt::format("{}  [–]", p.name), {}};
    chart.log_x = true;
    std::size_t colour = 0;
    constexpr const char* shades[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7"};
    for (const double G : strengths) {
      Series points{fmt::format("Γ̄₀ = {}", G), Mark::points, {}, {}, shades[colour]};
      std::vector<double> at_hundred;
      for (const Granule& g : list)
        if (g.Gamma_bar == G) {
          points.x.push_back(g.E_bar);
          points.y.push_back(g.*p.of);
          if (g.E_bar == 100) at_hundred.push_back(g.*p.of);
        }
      const auto regression = [&](double E) {
        return law::edmans_sinka_appendix(G, E, law::Coefficients::corrected).*p.regression;
      };
      theirs.push_back(regression(100));
      ours.push_back(mean(at_hundred));
      const auto x = even_in_logarithm(4.5, 500, 60);
      chart.series.push_back(std::move(points));
      chart.series.push_back(
          {fmt::format("A, {}", G), Mark::dashed, x, values(x, regression), shades[colour++]});
    }
    row.comparisons.push_back(overlay(fmt::format("{} at Ē₀ = 100", p.name), "Γ̄₀", strengths, theirs, ours,
                                      p.tolerance, fit_error));
    row.charts.push_back(std::move(chart));
  }
  row.because = "Section 8 of the paper swaps Figs 13b and 13c. δ̄_t and a make up for each other: a fit of "
                "form (6) knows their pair better than either.";
  return row;
}

/// Terms of a regression over Gamma_bar and E_bar.
using Terms = std::vector<std::function<double(const Granule&)>>;
const Terms bilinear = {[](const Granule& g) { return g.Gamma_bar * std::log(g.E_bar); },
                        [](const Granule& g) { return g.Gamma_bar; },
                        [](const Granule& g) { return std::log(g.E_bar); },
                        [](const Granule&) { return 1.0; }};
const Terms biquadratic = {[](const Granule& g) { return g.Gamma_bar * g.Gamma_bar; },
                           [](const Granule& g) { return g.Gamma_bar / g.E_bar; },
                           [](const Granule& g) { return 1 / (g.E_bar * g.E_bar); },
                           [](const Granule& g) { return g.Gamma_bar; },
                           [](const Granule& g) { return 1 / g.E_bar; },
                           [](const Granule&) { return 1.0; }};

struct Regression {
  const char *id, *name, *subject;
  const char* key; ///< of the printed numbers
  double Granule::*of;
  const Terms& terms;
  double E_bar_from; ///< softer ones are left out
  int suspect;       ///< coefficient that is thought to be misprinted, from 1; 0: none
  double corrected;  ///< its likely value
};

Row appendix(const Data& data, const Regression& r) {
  Row row{r.id, r.name, r.subject, "", "The same form through the fits of our 160, by linear least squares."};
  std::vector<Granule> list;
  for (const Granule& g : granules(data.pool("edmans-sinka")))
    if (g.E_bar >= r.E_bar_from) list.push_back(g);
  std::vector<double> y, printed, corrected;
  for (const Granule& g : list) y.push_back(g.*r.of);
  std::vector<std::vector<double>> columns;
  for (const auto& term : r.terms) {
    columns.emplace_back();
    for (const Granule& g : list) columns.back().push_back(term(g));
    printed.push_back(data.printed("edmans-sinka", fmt::format("{}.a{}", r.key, columns.size())));
  }
  corrected = printed;
  if (r.suspect) corrected[static_cast<std::size_t>(r.suspect - 1)] = r.corrected;
  const auto refitted = fit::least_squares(columns, y);
  const auto law = [&](const std::vector<double>& c) {
    std::vector<double> result(y.size(), 0);
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t i = 0; i < y.size(); ++i) result[i] += c[k] * columns[k][i];
    return result;
  };
  const double R2 = data.printed("edmans-sinka", fmt::format("{}.R2", r.key));
  row.theirs = fmt::format("Coefficients, R² = {}.", R2);
  const auto compare = [&](const std::string& what, const std::vector<double>& c) {
    row.comparisons.push_back({what, R2, r_squared(y, law(c)), 0.1, Measure::absolute, 0.01});
  };
  compare(fmt::format("R² on our {} with the coefficients as printed", y.size()), printed);
  if (r.suspect) {
    compare(fmt::format("R² with a{} = {}", r.suspect, core::number_text(r.corrected)), corrected);
    row.comparisons.push_back(
        {fmt::format("a{}, fitted anew", r.suspect), printed[static_cast<std::size_t>(r.suspect - 1)],
         refitted[static_cast<std::size_t>(r.suspect - 1)], 0.25, Measure::relative, fit_error});
  }
  compare("R² of the form fitted anew", refitted);
  row.because = r.suspect ? fmt::format("a{0} is misprinted by one or more decimal exponents: as printed the "
                                        "regression explains nothing (R² {1:.2g}), with {2} R² is "
                                        "{3:.3f}, and no coefficients do better than {4:.3f}. ",
                                        r.suspect, r_squared(y, law(printed)), core::number_text(r.corrected),
                                        r_squared(y, law(corrected)), r_squared(y, law(refitted)))
                          : "The coefficients are right as printed. ";
  row.because += "Fitted anew:";
  for (std::size_t k = 0; k < refitted.size(); ++k)
    row.because += fmt::format(" a{} = {:.4g} (printed {:.4g})", k + 1, refitted[k], printed[k]);
  row.because += ".";
  Chart chart{
      fmt::format("{}: regression over fit", r.name), "of our fit  [–]", "of the regression  [–]", {}};
  chart.series = {{"fitted anew", Mark::points, y, law(refitted)},
                  {"printed, corrected where suspect", Mark::points, y, law(corrected)},
                  {"equal", Mark::dashed, {least(y), largest(y)}, {least(y), largest(y)}, "#444444"}};
  row.charts.push_back(std::move(chart));
  return row;
}

// --- unloading ---

Row unloading_forms(const Data&) {
  Row row{"es-fig-14",
          "Fig. 14",
          "sample unloading curves (9)",
          "Curves of the formula for several α and one β below 1, which are not printed.",
          "The formula (13) for α = 1, 1.5, 2.",
          "it draws a formula, for values of α and β that are not printed."};
  Chart chart{"(13) from δ̄ = 0.5, δ̄₀ = 0.3", overlap_label, "F̄/F̄_max", {}};
  for (const double alpha : {1.0, 1.5, 2.0}) {
    const auto x = even(0.3, 0.5, 41);
    chart.series.push_back({fmt::format("α = {}", alpha), Mark::line, x,
                            values(x, [&](double at) { return std::pow((at - 0.3) / 0.2, alpha); })});
  }
  row.charts.push_back(std::move(chart));
  return row;
}

Series over_unloading(const Pool& pool, int run, const std::string& name, const std::string& quantity,
                      Mark mark) {
  Series series{name, mark, {}, {}};
  for (const double from : unloaded_from)
    if (const auto v = pool.value(run, quantity + "_" + core::number_text(from))) {
      series.x.push_back(from);
      series.y.push_back(*v);
    }
  return series;
}

Row unloading_parameters(const Data& data) {
  const auto printed = [&](const char* key) { return data.printed("edmans-sinka", key); };
  Row row{"es-fig-15", "Fig. 15", "α and β of unloading over the overlap",
          "Points of the eight corners, of von Mises and of an elastic sphere. α = 1.5 in Hertz's limit; R² "
          "of the fits at least 0.998825, median 0.999948.",
          "α of our elastic sphere (ν = 0.3) from δ̄ = 0.1; R² of all our branches, five a granule where the "
          "paper has one."};
  const Pool &pool = data.pool("edmans-sinka"), &springs = data.pool("elastic"),
             &metals = data.pool("von-mises");
  std::vector<double> R2;
  for (const Granule& g : granules(pool))
    for (const double from : unloaded_from)
      if (const auto v = pool.value(g.run, "R2_" + core::number_text(from))) R2.push_back(*v);
  const int elastic = springs.find({{"material.nu", 0.3}});
  row.comparisons = {
      {"α of the elastic sphere from δ̄ = 0.1", printed("unloading.alpha_hertz"),
       springs.number(elastic, "alpha_0.1"), 0.1, Measure::relative, fit_error},
      {"least R²", printed("unloading.R2_least"), least(R2), 0.002, Measure::absolute, 1e-4},
      {"median R²", printed("unloading.R2_median"), median(R2), 1e-4, Measure::absolute, 1e-5}};
  row.because = fmt::format(
      "{} branches. The elastic sphere is already finite at δ̄ = 0.1: its α lies above Hertz's.", R2.size());
  for (const char* quantity : {"alpha", "beta"}) {
    Chart chart{std::string(quantity) == "alpha" ? "exponent α" : "secant stiffness over Hertz's, β",
                "overlap from which it is unloaded  δ̄",
                std::string(quantity) == "alpha" ? "α  [–]" : "β  [–]",
                {}};
    for (const Corner& c : corners())
      chart.series.push_back(over_unloading(pool, granule(pool, c.E_bar, c.Gamma_bar, c.Lambda_bar).run,
                                            fmt::format("{}, {}, {}", c.E_bar, c.Gamma_bar, c.Lambda_bar),
                                            quantity, Mark::line));
    chart.series.push_back(over_unloading(springs, elastic, "elastic", quantity, Mark::dashed));
    chart.series.push_back(over_unloading(metals, metals.find({{"material.E_bar", 100}}), "von Mises, 100",
                                          quantity, Mark::dashed));
    row.charts.push_back(std::move(chart));
  }
  return row;
}

Row stiffness_over_area(const Data& data) {
  Row row{"es-fig-16", "Fig. 16", "β over the contact radius",
          "Points of the eight corners. The text: at one δ̄ the contact radius hardly depends on Ē₀.",
          "β over ā of our corners."};
  const Pool& pool = data.pool("edmans-sinka");
  Chart chart{"β over contact radius", "contact radius  ā = a/R₀", "β  [–]", {}};
  double spread = 0;
  for (const Corner& c : corners()) {
    const int run = granule(pool, c.E_bar, c.Gamma_bar, c.Lambda_bar).run;
    Series series = over_unloading(pool, run, fmt::format("{}, {}, {}", c.E_bar, c.Gamma_bar, c.Lambda_bar),
                                   "beta", Mark::line);
    for (double& x : series.x) x = pool.loading.at(run).a_at(x);
    chart.series.push_back(std::move(series));
    if (c.E_bar != 3) continue;
    const int stiff = granule(pool, 500, c.Gamma_bar, c.Lambda_bar).run;
    for (const double x : unloaded_from)
      spread = std::max(spread, std::abs(pool.loading.at(stiff).a_at(x) / pool.loading.at(run).a_at(x) - 1));
  }
  row.because = fmt::format("the points are in the picture alone. Of our corners ā differs by up to {:.0f} % "
                            "between Ē₀ = 3 and 500 at one overlap from 0.1 on.",
                            100 * spread);
  row.charts.push_back(std::move(chart));
  return row;
}

Row generalised_parameters(const Data& data) {
  const double Gamma = data.printed("edmans-sinka", "base.Gamma_bar"),
               epsilon = data.printed("edmans-sinka", "base.epsilon");
  Row row{"es-table-3",
          "Table 3",
          "parameters of the yield surfaces",
          "For VMDC ε = π₂/(π₄ − π₃): the base case then has a cap centred at a tensile stress.",
          "Where the compaction cap of the base case begins on the surface that the press uses.",
          "The fraction is upside down for VMDC, right for DPC: ε = (π₄ − π₃)/π₂. At full density ε·Γ can "
          "reach σ_y; from there π₃ = 0."};
  const auto model = material::read_card("base-case").material.model;
  const double sigma = material::reference_stress(model);
  double begins = 0; // the largest pressure at which q is still Gamma
  for (const auto& curve : material::yield_curves(model, 0, -1.2 * sigma, 0.3 * sigma))
    for (const auto& [p, q] : curve.p_q)
      if (q / sigma > Gamma * (1 - 1e-9)) begins = std::max(begins, -p / sigma);
  row.comparisons.push_back(
      {"π₃/σ_y of the base case", 1 - Gamma / epsilon, begins, 0.01, Measure::relative, formula_error});
  return row;
}

} // namespace

std::vector<Row> edmans_sinka_law_rows(const Data& data) {
  return {
      error_distributions(data),
      example_fits(data),
      law_parameters(data),
      unloading_forms(data),
      unloading_parameters(data),
      stiffness_over_area(data),
      generalised_parameters(data),
      appendix(data,
               {"es-a-1", "(A.1)", "k from the material", "A1", &Granule::k, bilinear, 0, 1, 7.4613e-1}),
      appendix(data, {"es-a-2", "(A.2)", "δ̄_t from the material", "A2", &Granule::delta_t, biquadratic, 4.5,
                      6, 4.3846e-2}),
      appendix(data, {"es-a-3", "(A.3)", "a from the material", "A3", &Granule::a, biquadratic, 4.5, 0, 0})};
}

} // namespace platen::reproduce
