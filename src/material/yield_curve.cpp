#include "material/yield_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::material {
namespace {

constexpr int points = 200;

/// The stretch of s to draw.
std::array<double, 2> stretch(const auto& surface, double, double) {
  return {surface.s_min(), surface.s_max()};
}
std::array<double, 2> stretch(const VonMises::Surface&, double p_low, double p_high) {
  return {-p_high, -p_low};
}
std::array<double, 2> stretch(const DruckerPrager::Surface& f, double p_low, double) {
  return {0, std::max(f.p_apex() - p_low, 0.0)};
}

/// Meridian of Mohr-Coulomb: sigma_1 = p + high q, sigma_3 = p - low q, with (high, low) = (1/3, 2/3) where
/// two stresses are equal and the third is the most compressive, (2/3, 1/3) where it is the most tensile.
YieldCurve meridian(const MohrCoulomb& m, const char* name, double high, double low, double p_low) {
  constexpr double degree = std::numbers::pi / 180;
  const double sin_phi = std::sin(m.phi_deg * degree), cos_phi = std::cos(m.phi_deg * degree);
  YieldCurve curve{name, {}};
  for (int i = 0; i <= points; ++i) {
    const double p = m.cutoff + (p_low - m.cutoff) * i / points;
    const double shear =
        (2 * m.cohesion * cos_phi - 2 * p * sin_phi) / (high * (1 + sin_phi) + low * (1 - sin_phi));
    curve.p_q.push_back({p, std::min(shear, (m.cutoff - p) / high)});
  }
  return curve;
}

} // namespace

std::vector<YieldCurve> yield_curves(const Model& model, double phi, double p_low, double p_high) {
  if (const auto* m = std::get_if<MohrCoulomb>(&model))
    return {meridian(*m, "triaxial compression", 1.0 / 3, 2.0 / 3, p_low),
            meridian(*m, "triaxial extension", 2.0 / 3, 1.0 / 3, p_low)};
  return std::visit(
      [&]<class M>(const M& m) -> std::vector<YieldCurve> {
        if constexpr (PlasticModel<M>) {
          const auto surface = m.surface(phi);
          const auto [first, last] = stretch(surface, p_low, p_high);
          YieldCurve curve;
          for (int i = 0; i <= points; ++i) {
            const SurfacePoint f = surface.at(first + (last - first) * i / points);
            curve.p_q.push_back({f.p, std::max(f.q, 0.0)});
          }
          return {curve};
        } else return {};
      },
      model);
}

} // namespace platen::material
