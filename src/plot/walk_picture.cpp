#include "plot/walk_picture.hpp"

#include "material/yield_curve.hpp"
#include "plot/yield_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace platen::plot {

void walk_picture(const material::Material& m, const material::Way& way, const material::Walk& w,
                  const std::filesystem::path& file) {
  StressPath path;
  double p_low = 0, p_high = 0, phi_first = 0, phi_last = 0;
  for (const auto& point : w.points) {
    path.p_q.push_back({point.last.p, point.last.q});
    path.zones.push_back(point.last.zone);
    p_low = std::min(p_low, point.last.p), p_high = std::max(p_high, point.last.p);
    phi_first = std::min(phi_first, point.phi), phi_last = std::max(phi_last, point.phi);
  }
  const double size = material::reference_stress(m.model);
  p_low -= 0.2 * (p_high - p_low) + (std::holds_alternative<material::Elastic>(m.model) ? 0 : size);
  const bool porous =
      std::holds_alternative<material::Vmdc>(m.model) || std::holds_alternative<material::Dpc>(m.model);
  const auto* metal = std::get_if<material::VonMises>(&m.model);
  const bool evolves =
      porous || (metal && !std::holds_alternative<material::PerfectlyPlastic>(metal->hardening));
  const int states = evolves && phi_last > phi_first ? 5 : 1;
  std::vector<NamedCurve> curves;
  for (int i = 0; i < states; ++i) {
    const double phi = states == 1 ? 0 : phi_first + (phi_last - phi_first) * i / (states - 1);
    for (const auto& curve : material::yield_curves(m.model, phi, p_low, p_high)) {
      const std::string state = porous ? fmt::format("ρᵣ = {:.3g}", material::relative_density(m.model, phi))
                                : evolves ? fmt::format("εₚ = {:.3g}", phi)
                                          : "yield";
      curves.push_back({curve.name.empty() ? state : curve.name, curve.p_q});
    }
  }
  yield_picture(curves, path,
                fmt::format("{} ({}): {}", m.name, material::model_name(m.model),
                            is_named(way) ? way.name : std::filesystem::path(way.name).filename().string()),
                file);
}

} // namespace platen::plot
