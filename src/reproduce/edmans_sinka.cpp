// Edmans & Sinka: granules of von Mises Double Cap material between planes, and what happens inside.

#include "core/number.hpp"
#include "material/card.hpp"
#include "material/yield_curve.hpp"
#include "reproduce/granules.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::reproduce {
namespace {

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

} // namespace

std::vector<Row> edmans_sinka_model_rows(const Data& data) {
  return {yield_surfaces(data),   parameter_space(data),     models_compared(data),
          discrepancy_maps(data), zones_of_models(data),     zone_maps_of_models(data),
          zones_of_corners(data), zone_maps_of_corners(data)};
}

} // namespace platen::reproduce
