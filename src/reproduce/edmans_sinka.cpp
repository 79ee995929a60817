// Edmans & Sinka: granules of von Mises Double Cap material between planes.

#include "core/number.hpp"
#include "fit/golden.hpp"
#include "fit/least_squares.hpp"
#include "material/card.hpp"
#include "material/yield_curve.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "reproduce/papers.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

namespace platen::reproduce {
namespace {

constexpr const char* overlap_label = "overlap  δ̄ = δ/R₀";
constexpr const char* force_label = "force  F̄ = F/(πR₀²σ_y)";
const std::vector<double> unloaded_from = {0.1, 0.2, 0.3, 0.4, 0.5};

/// One of the 160.
struct Granule {
  int run;
  double E_bar, Gamma_bar, Lambda_bar;
  double k, delta_t, a, e_p, e_a;

  double law(double x) const { return x <= delta_t ? k * x : k * delta_t * std::exp(a * (x - delta_t)); }
};

std::vector<Granule> granules(const Pool& pool) {
  std::vector<Granule> list;
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run)
    if (pool.done(run))
      list.push_back({run, pool.number(run, "material.E_bar"), pool.number(run, "material.Gamma_bar"),
                      pool.number(run, "material.Lambda_bar"), pool.number(run, "k"),
                      pool.number(run, "delta_t"), pool.number(run, "a"), pool.number(run, "e_p"),
                      pool.number(run, "e_a")});
  return list;
}

Granule granule(const Pool& pool, double E_bar, double Gamma_bar, double Lambda_bar) {
  const int run = pool.find(
      {{"material.E_bar", E_bar}, {"material.Gamma_bar", Gamma_bar}, {"material.Lambda_bar", Lambda_bar}});
  const auto list = granules(pool);
  return *std::ranges::find(list, run, &Granule::run);
}

std::string name_of(double E_bar, double Gamma_bar, double Lambda_bar) {
  return fmt::format("Ē₀ = {}, Γ̄₀ = {}, Λ̄₀ = {}", E_bar, Gamma_bar, Lambda_bar);
}

std::string plain(double x) { // 0.25 -> "025", as in the names of the presses
  std::string text = core::number_text(x);
  std::erase(text, '.');
  return text;
}

struct Corner {
  double E_bar, Gamma_bar, Lambda_bar;
  std::string press() const {
    return fmt::format("corner-E{}-G{}-L{}", core::number_text(E_bar), plain(Gamma_bar), plain(Lambda_bar));
  }
  std::string words() const { return name_of(E_bar, Gamma_bar, Lambda_bar); }
};

std::vector<Corner> corners() {
  std::vector<Corner> list;
  for (const double E : {3.0, 500.0})
    for (const double G : {0.25, 1.0})
      for (const double L : {0.01, 1.0}) list.push_back({E, G, L});
  return list;
}

// --- figures of the models ---

Row yield_surfaces(const Data&) {
  Row row{"es-fig-1", "Fig. 1", "yield surfaces of von Mises, DPC and VMDC",
          "Table 2 prints the formulas of the surfaces.",
          "The surfaces as the press uses them, base case at its first density; VMDC against the formula, "
          "with Γ = σ_y and π₃ from Table 3 "
          "as corrected there."};
  const auto model = material::read_card("base-case").material.model;
  const double sigma = material::reference_stress(model);
  Chart chart{"yield surfaces, base case", "pressure  −p/σ_y", "equivalent stress  q/σ_y", {}};
  for (const char* name : {"vmdc", "dpc", "von-mises"}) {
    Series series{name, Mark::line, {}, {}};
    for (const auto& curve :
         material::yield_curves(material::run_as(model, name), 0, -1.2 * sigma, 0.3 * sigma))
      for (const auto& [p, q] : curve.p_q) {
        series.x.push_back(-p / sigma);
        series.y.push_back(q / sigma);
      }
    chart.series.push_back(std::move(series));
  }
  const double Gamma = 1, Lambda = 0.01, pi_3 = 1 - 0.7 * Gamma;
  std::vector<double> x, theirs, ours;
  const Series& vmdc = chart.series.front();
  for (std::size_t i = 0; i < vmdc.x.size(); ++i) {
    const double p = -vmdc.x[i];
    const double along = p > 0 ? p / Lambda : p < -pi_3 ? (p + pi_3) / (1 - pi_3) : 0;
    if (std::abs(along) > 0.99) continue; // q falls to zero there
    x.push_back(vmdc.x[i]);
    theirs.push_back(Gamma * std::sqrt(1 - along * along));
    ours.push_back(vmdc.y[i]);
  }
  row.comparisons.push_back(overlay("q/σ_y of VMDC", "−p/σ_y", x, theirs, ours, 1e-6, formula_error));
  row.charts.push_back(std::move(chart));
  return row;
}

Row parameter_space(const Data& data) {
  Row row{"es-fig-2",
          "Fig. 2",
          "the space of parameters, with measured powders",
          "The stiffness ratio goes from 3 to 500, said to be the envelope of the measured powders, metallic "
          "ones left out.",
          "Least and largest Ē₀ of Tables 4 and 5, alumina left out (1,358 and 1,575).",
          "No powder of the two tables lies below 4.5; the 3 of the space is below its envelope."};
  std::vector<double> measured;
  Chart chart{"stiffness ratios", "Ē₀ = E₀/σ_y", "1: the 160, 2: Table 4, 3: Table 5", {}};
  chart.log_x = true;
  chart.y_range = {0, 4};
  Series design{"pressed", Mark::points, {}, {}};
  for (const Granule& g : granules(data.pool("edmans-sinka"))) {
    design.x.push_back(g.E_bar);
    design.y.push_back(1);
  }
  chart.series.push_back(std::move(design));
  double level = 2;
  for (const char* name : {"edmans-sinka-table-4.csv", "edmans-sinka-table-5.csv"}) {
    const core::Csv table = data.table(name);
    Series series{level < 3 ? "Cunningham et al." : "Bika et al.", Mark::points, {}, {}};
    for (const auto& line : table.rows) {
      series.x.push_back(table.number(line, table.column("E_bar")));
      series.y.push_back(level);
      if (line.cells[0].find("Alumina") == std::string::npos) measured.push_back(series.x.back());
    }
    chart.series.push_back(std::move(series));
    ++level;
  }
  row.comparisons = {
      {"least Ē₀", data.printed("edmans-sinka", "parameter_space.E_bar_min"), least(measured), 0.1},
      {"largest Ē₀", data.printed("edmans-sinka", "parameter_space.E_bar_max"), largest(measured), 0.1}};
  row.charts.push_back(std::move(chart));
  return row;
}

Series force(const std::string& name, const BranchCurve& curve, double factor = 1, Mark mark = Mark::line) {
  Series series{name, mark, curve.x, curve.F};
  for (double& F : series.y) F *= factor;
  return series;
}

BranchCurve up_to(const BranchCurve& curve, double end) {
  BranchCurve part;
  for (std::size_t i = 0; i < curve.x.size() && curve.x[i] <= end; ++i) {
    part.x.push_back(curve.x[i]);
    part.F.push_back(curve.F[i]);
  }
  return part;
}

Row models_compared(const Data& data) {
  Row row{"es-fig-4", "Fig. 4", "the base case with other models",
          "Force over overlap of VMDC, DPC, von Mises, elastic and Hertz (10). The text gives no number of "
          "it; Hertz's curve is a formula.",
          "Our presses of the same; Hertz's formula against the elastic sphere up to δ̄ = 0.005. A finite "
          "sphere is stiffer than Hertz's by "
          "about 0.55 √δ̄, beyond that it is physics."};
  const Pool& metals = data.pool("von-mises");
  const Pool& springs = data.pool("elastic");
  const auto& elastic = springs.loading.at(springs.find({{"material.nu", 0.3}}));
  const double k_H = 4 / (3 * std::numbers::pi) * 100 / (1 - 0.09);
  const auto hertz = [&](double x) { return k_H * std::pow(x, 1.5); };
  const std::vector<double> small = {0.00125, 0.0025, 0.005};
  row.comparisons.push_back(overlay("F̄ of the elastic sphere against (10)", "δ̄", small, values(small, hertz),
                                    values(small, [&](double x) { return 100 * elastic.F_at(x); }), 0.05,
                                    force_error));
  Chart chart{"base case, Ē₀ = 100", overlap_label, force_label, {}};
  chart.y_range = {0, 4};
  chart.series.push_back(force("VMDC", loading_of(data.press("base-vmdc"))));
  chart.series.push_back(force("DPC", loading_of(data.press("base-dpc"))));
  chart.series.push_back(
      force("von Mises, perfectly plastic", metals.loading.at(metals.find({{"material.E_bar", 100}}))));
  chart.series.push_back(force("elastic", elastic, 100));
  const auto x = even(0, 0.2, 60);
  chart.series.push_back({"Hertz (10)", Mark::dashed, x, values(x, hertz)});
  row.charts.push_back(std::move(chart));
  return row;
}

/// Load over that of the metal of the granule's shear strength, less one.
double excess_over_metal(const Data& data, const Granule& g, double x) {
  const Pool& metals = data.pool("von-mises");
  const auto& metal = metals.loading.at(metals.find({{"material.E_bar", g.E_bar / g.Gamma_bar}}));
  return data.pool("edmans-sinka").loading.at(g.run).F_at(x) / (g.Gamma_bar * metal.F_at(x)) - 1;
}

Row discrepancy_maps(const Data& data) {
  Row row{"es-fig-6", "Fig. 6", "VMDC over perfectly plastic von Mises at δ̄ = 0.5",
          "Contour maps. The text: von Mises falls far short where stiffness and shear strength are large; "
          "where Γ̄₀ is low the two are near.",
          "The same ratio of our 160 granules and 28 metals, as lines instead of contours."};
  double most = -1, low = 0;
  const Granule* where = nullptr;
  const auto list = granules(data.pool("edmans-sinka"));
  for (const Granule& g : list) {
    const double e = excess_over_metal(data, g, 0.5);
    if (e > most) {
      most = e;
      where = &g;
    }
    if (g.Gamma_bar == 0.25) low = std::max(low, std::abs(e));
  }
  row.because =
      fmt::format("the numbers are in contour lines that are not in the text. What the text says of them "
                  "holds: largest excess {:+.0f} % at "
                  "{}; at Γ̄₀ = 0.25 no more than {:.0f} % either way.",
                  100 * most, name_of(where->E_bar, where->Gamma_bar, where->Lambda_bar), 100 * low);
  for (const double L : {0.01, 0.1, 0.5, 1.0}) {
    Chart chart{fmt::format("Λ̄₀ = {}, δ̄ = 0.5", L), "Ē₀ = E₀/σ_y", "F(VMDC)/F(von Mises) − 1  (%)", {}};
    chart.log_x = true;
    chart.y_range = {-40, 160};
    for (const double G : {0.25, 0.5, 0.75, 1.0}) {
      Series series{fmt::format("Γ̄₀ = {}", G), Mark::line, {}, {}};
      for (const Granule& g : list)
        if (g.Gamma_bar == G && g.Lambda_bar == L) {
          series.x.push_back(g.E_bar);
          series.y.push_back(100 * excess_over_metal(data, g, 0.5));
        }
      chart.series.push_back(std::move(series));
    }
    row.charts.push_back(std::move(chart));
  }
  return row;
}

// --- zones ---

Chart zones(const press::Curve& curve, const std::string& title) {
  Chart chart{title, overlap_label, "fraction of the volume that flows so", {}};
  chart.y_range = {0, 1};
  const auto add = [&](const char* name, const char* colour, double press::CurvePoint::*member) {
    Series series{name, Mark::line, {}, {}, colour};
    for (const auto& point : curve.points)
      if (point.branch == press::Branch::loading) {
        series.x.push_back(point.delta_bar);
        series.y.push_back(point.*member);
      }
    chart.series.push_back(std::move(series));
  };
  add("elastic", "#0072b2", &press::CurvePoint::zone_elastic);
  add("shear", "#c9a800", &press::CurvePoint::zone_shear);
  add("compaction", "#c62828", &press::CurvePoint::zone_compaction);
  add("tension", "#2e7d32", &press::CurvePoint::zone_tension);
  return chart;
}

Row zones_of_models(const Data& data) {
  Row row{"es-fig-7",
          "Fig. 7",
          "flow in the base case, VMDC and DPC",
          "Fractions of the volume that compact, shear and dilate, with the force. With DPC the stiffness is "
          "65 % of the first, linear one with VMDC.",
          "Largest F̄/δ̄ of our DPC press over the k that fits our VMDC press.",
          "DPC flows by the paper's own potential here (published_flow, 600 elements). The paper does not "
          "give its rounding π₈; ours is small."};
  const press::Curve &vmdc = data.press("base-vmdc"), &dpc = data.press("base-dpc");
  const BranchCurve branch = loading_of(dpc);
  double stiffest = 0;
  for (std::size_t i = 0; i < branch.x.size(); ++i) stiffest = std::max(stiffest, branch.F[i] / branch.x[i]);
  row.comparisons.push_back({"stiffness with DPC over VMDC", data.printed("edmans-sinka", "dpc.stiffness"),
                             stiffest / granule(data.pool("edmans-sinka"), 100, 1, 0.01).k, 0.1,
                             Measure::relative, fit_error});
  Chart forces{"force, base case, as far as DPC goes", overlap_label, force_label, {}};
  forces.series = {force("VMDC", up_to(loading_of(vmdc), branch.x.back())), force("DPC", branch)};
  row.charts = {zones(vmdc, "VMDC: how the volume flows"), zones(dpc, "DPC: how the volume flows"),
                std::move(forces)};
  return row;
}

Row zone_maps_of_models(const Data& data) {
  Row row{
      "es-fig-8", "Fig. 8", "where the base case flows, VMDC and DPC",
      "Maps at five overlaps. With DPC about 85 % of the particle shears when the simulation ends, early.",
      "Share of the volume that shears on DPC's failure line, largest of the loading."};
  const press::Curve& dpc = data.press("base-dpc");
  double share = 0;
  for (const auto& point : dpc.points) share = std::max(share, point.zone_shear + point.zone_tension);
  row.comparisons.push_back({"share of the volume on the failure line, DPC",
                             data.printed("edmans-sinka", "dpc.shear_fraction"), share, 0.1,
                             Measure::relative, 0.05});
  row.because =
      fmt::format("Both come to their limit load early, ours at δ̄ = {:.2g}, when nearly all of it shears.",
                  press::loading_end(dpc)->delta_bar);
  row.pictures = {{"papers/presses/base-vmdc/zones.svg", "VMDC, δ̄ = 0.1 to 0.5"},
                  {"papers/presses/base-dpc/zones.svg", "DPC, δ̄ = 0.0025 to 0.0125"}};
  return row;
}

Row zones_of_corners(const Data& data) {
  Row row{"es-fig-9",
          "Fig. 9",
          "flow at the eight corners of the space",
          "Fractions of the volume over δ̄, as curves; waves in two of them.",
          "The same eight granules; the two with Ē₀ = 500 and Γ̄₀ = 0.25 on 600 elements.",
          "the fractions are in the picture alone; ours stand below."};
  for (const Corner& c : corners()) row.charts.push_back(zones(data.press(c.press()), c.words()));
  return row;
}

Row zone_maps_of_corners(const Data& data) {
  Row row{"es-fig-10",
          "Fig. 10",
          "where the eight corners flow",
          "Maps at five overlaps.",
          "The same eight granules at δ̄ = 0.1 to 0.5.",
          "maps are in the picture alone; ours stand below, their fractions as numbers under Fig. 9."};
  for (const Corner& c : corners()) {
    row.pictures.push_back({fmt::format("papers/presses/{}/zones.svg", c.press()), c.words()});
    data.press(c.press());
  }
  return row;
}

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

std::vector<Row> edmans_sinka_rows(const Data& data) {
  return {
      yield_surfaces(data),
      parameter_space(data),
      models_compared(data),
      discrepancy_maps(data),
      zones_of_models(data),
      zone_maps_of_models(data),
      zones_of_corners(data),
      zone_maps_of_corners(data),
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
