// Wang et al., section 3: grains of rock, small contacts, linear Drucker-Prager.

#include "reproduce/wang.hpp"
#include "core/file.hpp"
#include "material/card.hpp"
#include "material/yield_curve.hpp"
#include "reproduce/papers.hpp"
#include "reproduce/statistics.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::reproduce {
namespace {

constexpr double MPa = 1e6;

/// Of the loading branch, over the force.
double at_force(const press::Curve& curve, double F_N, double press::CurvePoint::*member) {
  const press::CurvePoint* before = nullptr;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading) continue;
    if (point.force_N >= F_N && before) {
      const double part = (F_N - before->force_N) / (point.force_N - before->force_N);
      return before->*member + part * (point.*member - before->*member);
    }
    before = &point;
  }
  return std::nan("");
}

Series over_force(const press::Curve& curve, const std::string& name, double press::CurvePoint::*member,
                  Mark mark) {
  Series series{name, mark, {}, {}};
  for (const auto& point : curve.points)
    if (point.branch == press::Branch::loading && point.force_N <= 200) {
      series.x.push_back(point.force_N);
      series.y.push_back(point.*member / MPa);
    }
  return series;
}
Row loading_level(const Data& data) {
  const auto printed = [&](const char* key) { return data.printed("wang", key); };
  Row row{
      "wg-fig-2", "Fig. 2", "contact pressure and largest von Mises stress of sandstone",
      "100 N stand for the deepest bulk: 1,650 m of rock of 2,600 kg/m³. The largest von Mises stress stays "
      "below the peak pressure.",
      "Peak pressure of our sandstone at 100 N, for both strengths that the paper gives it, against ρ g h."};
  const double g = 9.81, overburden = printed("density_kg_per_m3") * g * printed("overburden_m") / MPa;
  Chart chart{"sandstone, R = 0.1 m, associated flow", "force F (N)", "stress (MPa)", {}};
  for (const auto& [press, strength] :
       {std::pair{"sandstone-3-3", "σ_c = 6.72 MPa"}, {"sandstone-3-4", "σ_c = 10.61 MPa"}}) {
    const press::Curve& curve = data.press(press);
    row.comparisons.push_back({fmt::format("peak pressure at 100 N (MPa), {}", strength), overburden,
                               at_force(curve, printed("load_N"), &press::CurvePoint::peak_pressure_Pa) / MPa,
                               0.1, Measure::relative, pressure_error});
    chart.series.push_back(over_force(curve, fmt::format("peak pressure, {}", strength),
                                      &press::CurvePoint::peak_pressure_Pa, Mark::line));
    chart.series.push_back(over_force(curve, fmt::format("von Mises, {}", strength),
                                      &press::CurvePoint::mises_max_Pa, Mark::dashed));
  }
  row.because = "The peak depends on the flow rule, which the paper leaves open for this figure: without "
                "dilation (ψ = 0) ours is about 39 MPa with "
                "6.72 MPa (docs: local press). 6.72 MPa is the strength of 3.3, 10.61 MPa that of 3.4.";
  row.charts.push_back(std::move(chart));
  return row;
}

Row plastic_flow(const Data& data) {
  Row row{"wg-fig-3", "Fig. 3", "where plastic flow reaches the free surface",
          "At about 535 N for the sandstone, read off a map of plastic strain.",
          "Force at which elements above a plastic strain connect the axis with the surface, 20 edges under "
          "the contact."};
  row.because =
      "It is a matter of the contour level, which is not given: the force grows many times from a "
      "strain of 10⁻⁵ to 10⁻³. 20 edges do not resolve it; with 40 it is 170 N for 6.72 MPa and 521 N for "
      "10.61 MPa at 5·10⁻⁴ (docs: local press).";
  Chart chart{"force of break-through", "threshold of the plastic strain  √(2/3 ε:ε)", "force F (N)", {}};
  chart.log_x = true;
  for (const char* press : {"sandstone-3-3", "sandstone-3-4"}) {
    data.press(press);
    const auto summary = nlohmann::json::parse(
        core::read_file(data.file(fmt::format("papers/presses/{}/summary.json", press))));
    Series series{
        press == std::string("sandstone-3-3") ? "σ_c = 6.72 MPa" : "σ_c = 10.61 MPa", Mark::points, {}, {}};
    for (const auto& level : summary.at("break_through")) {
      if (level.at("force_N").is_null()) continue;
      series.x.push_back(level.at("plastic_strain").get<double>());
      series.y.push_back(level.at("force_N").get<double>());
      if (std::abs(series.x.back() - 5e-4) < 1e-9)
        row.comparisons.push_back({fmt::format("force (N) at a strain of 5·10⁻⁴, {}", series.name),
                                   data.printed("wang", "plastic_flow_N"), series.y.back(), 0.15,
                                   Measure::relative, 0.1});
    }
    chart.series.push_back(std::move(series));
  }
  chart.series.push_back({"535 N", Mark::dashed, {1e-5, 1e-3}, {535, 535}});
  row.charts.push_back(std::move(chart));
  return row;
}

Series surface_of(const char* card, const std::string& name) {
  Series series{name, Mark::line, {}, {}};
  const auto model = material::read_card(card).material.model;
  for (const auto& curve : material::yield_curves(model, 0, -30 * MPa, 10 * MPa)) {
    for (const auto& [p, q] : curve.p_q) {
      series.x.push_back(-p / MPa);
      series.y.push_back(q / MPa);
    }
    break; // of Mohr-Coulomb the meridian of compression
  }
  return series;
}

/// q of a surface at p = 0, linear between its points.
double at_no_pressure(const Series& s) {
  for (std::size_t i = 1; i < s.x.size(); ++i)
    if (s.x[i - 1] <= 0 && s.x[i] >= 0 && s.x[i] > s.x[i - 1])
      return s.y[i - 1] - s.x[i - 1] * (s.y[i] - s.y[i - 1]) / (s.x[i] - s.x[i - 1]);
  return std::nan("");
}

Row equal_strengths(const Data& data) {
  const auto printed = [&](const char* key) { return data.printed("wang", key); };
  Row row{"wg-fig-4",
          "Fig. 4",
          "three yield surfaces of equal strength",
          "σ_c = 10.61 MPa gives σ_y = 6.70 MPa (14) and a cohesion of 3.2 MPa (15); φ = 27.8° gives β = "
          "47.84° (7).",
          "Read off the surfaces that our press uses: q at p = 0, slope; the cohesion by (15).",
          "(3) and (4) differ in the sign of I₁; here tension is positive. The strength of 6.72 MPa of "
          "section 3.3 would give 4.24 MPa."};
  const Series dp = surface_of("sandstone-wang-3-4", "Drucker-Prager");
  const double sin_phi = std::sin(printed("section_3_4.phi_deg") * std::numbers::pi / 180);
  const double cohesion =
      (1 - sin_phi) / (2 * std::sqrt(1 - sin_phi * sin_phi)) * printed("section_3_4.sigma_c_MPa");
  row.comparisons = {{"von Mises strength (MPa)", printed("section_3_4.sigma_y_MPa"), at_no_pressure(dp),
                      0.005, Measure::relative, formula_error},
                     {"cohesion (MPa)", printed("section_3_4.cohesion_MPa"), cohesion, 0.02,
                      Measure::relative, formula_error},
                     {"β (°)", printed("section_3_4.beta_deg"),
                      std::atan(6 * sin_phi / (3 - sin_phi)) * 180 / std::numbers::pi, 0.005,
                      Measure::relative, formula_error}};
  Chart p_q{"p–q plane", "pressure −p (MPa)", "q (MPa)", {dp}};
  p_q.series.push_back(surface_of("sandstone-wang-3-4-von-mises", "von Mises"));
  p_q.series.push_back(surface_of("sandstone-wang-3-4-mohr-coulomb", "Mohr-Coulomb, compression"));
  Chart plane{"π plane at −p = 10 MPa", "deviatoric stress (MPa)", "deviatoric stress (MPa)", {}};
  Series circle{"Drucker-Prager", Mark::line, {}, {}}, hexagon{"Mohr-Coulomb", Mark::line, {}, {}};
  const double beta = std::tan(printed("section_3_4.beta_deg") * std::numbers::pi / 180), p = 10;
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * std::numbers::pi / 180,
                 lode = std::asin(std::sin(3 * angle)) / 3; // -30 to 30 degrees
    const double radius = std::sqrt(2.0 / 3) * (printed("section_3_4.sigma_y_MPa") + p * beta);
    const double root_J2 = (p * sin_phi + cohesion * std::sqrt(1 - sin_phi * sin_phi)) /
                           (std::cos(lode) + std::sin(lode) * sin_phi / std::sqrt(3.0));
    circle.x.push_back(radius * std::cos(angle));
    circle.y.push_back(radius * std::sin(angle));
    hexagon.x.push_back(std::sqrt(2.0) * root_J2 * std::cos(angle));
    hexagon.y.push_back(std::sqrt(2.0) * root_J2 * std::sin(angle));
  }
  plane.series = {std::move(circle), std::move(hexagon)};
  plane.equal_scales = true;
  row.charts = {std::move(p_q), std::move(plane)};
  return row;
}

Row pressure_profiles(const Data& data) {
  Row row{"wg-fig-5", "Fig. 5", "contact pressure at 100 N with three yield surfaces",
          "Drucker-Prager and Mohr-Coulomb nearly the same, K = 0.778 and K = 1 as well, von Mises far off.",
          "Our presses of the same; for K = 0.778 the peak over that of K = 1."};
  Chart chart{"sandstone of section 3.4, 100 N", "radius r (mm)", "contact pressure (MPa)", {}};
  std::vector<double> peaks;
  for (const auto& [press, name] : {std::pair{"sandstone-3-4", "Drucker-Prager, K = 1"},
                                    {"sandstone-3-4-k", "Drucker-Prager, K = 0.778"},
                                    {"sandstone-mohr-coulomb", "Mohr-Coulomb"},
                                    {"sandstone-von-mises", "von Mises"}}) {
    data.press(press);
    const core::Csv profile =
        core::read_csv(data.file(fmt::format("papers/presses/{}/profile-100.csv", press)));
    Series series{name, Mark::line, {}, {}};
    for (const auto& line : profile.rows) {
      series.x.push_back(1e3 * profile.number(line, profile.column("radius_m")));
      series.y.push_back(profile.number(line, profile.column("pressure_Pa")) / MPa);
    }
    peaks.push_back(largest(series.y));
    chart.series.push_back(std::move(series));
  }
  row.comparisons.push_back({"peak of K = 0.778 over that of K = 1, said to be nearly the same", 1,
                             peaks[1] / peaks[0], 0.05, Measure::relative, pressure_error});
  row.because = fmt::format(
      "The curves are in the picture alone. Peaks of {:.1f} and {:.1f} MPa (Drucker-Prager, K = 1 "
      "and 0.778), {:.1f} (Mohr-Coulomb), {:.1f} (von Mises).",
      peaks[0], peaks[1], peaks[2], peaks[3]);
  row.charts.push_back(std::move(chart));
  return row;
}

Row steel_beads(const Data&) {
  return {
      "wg-fig-6",
      "Fig. 6",
      "two steel beads, measured and computed",
      "Measured points and a computed curve of stainless steel.",
      "–",
      "neither the properties of the steel nor the measured points are printed; they are another paper's."};
}
} // namespace

std::vector<Row> wang_rows(const Data& data) {
  std::vector<Row> rows{loading_level(data), plastic_flow(data), equal_strengths(data),
                        pressure_profiles(data), steel_beads(data)};
  std::ranges::move(wang_coefficient_rows(data), std::back_inserter(rows));
  return rows;
}

} // namespace platen::reproduce
