#include "material/hardening.hpp"

#include <algorithm>
#include <cmath>

namespace platen::material {
namespace {

/// Total strain at which a Hollomon law meets the elastic line.
double yield_strain(const Hollomon& h, double E) {
  return h.inverse_m < 1 ? std::pow(h.kappa / E, 1 / (1 - h.inverse_m)) : 0;
}

struct Evaluate {
  double E, sigma_y, eps_p;

  YieldStress operator()(const PerfectlyPlastic&) const { return {sigma_y, 0}; }

  YieldStress operator()(const ExponentialHardening& h) const {
    if (eps_p < 0) return {sigma_y * (1 + h.eta * eps_p), h.eta * sigma_y};
    const double sigma = sigma_y * std::exp(h.eta * eps_p);
    return {sigma, h.eta * sigma};
  }

  // eps - (kappa/E) eps^e = eps_p by Newton; the left side is convex, so that after the first step the
  // iterates come down on the root.
  YieldStress operator()(const Hollomon& h) const {
    const double r = h.kappa / E, e = h.inverse_m, smallest = 1e-300;
    const double eps_y = yield_strain(h, E);
    double eps = std::max(eps_y + std::max(eps_p, 0.0), smallest), power = r * std::pow(eps, e);
    for (int i = 0; i < 50; ++i) {
      const double gap = eps - power - std::max(eps_p, 0.0);
      const double next = std::max(eps - gap / (1 - e * power / eps), std::max(eps_y, smallest));
      const bool settled = std::abs(next - eps) <= 1e-15 * next;
      eps = next;
      power = r * std::pow(eps, e);
      if (settled) break;
    }
    const double slope = e * power / eps; // d(sigma)/d(eps)/E
    const YieldStress at{E * power, E * slope / (1 - slope)};
    return {at.value + std::min(eps_p, 0.0) * at.slope, at.slope};
  }

  YieldStress operator()(const Ludwik& h) const {
    const double e = h.inverse_n;
    const double eps_0 = e < 1 ? std::pow(e * h.K / (10 * E), 1 / (1 - e)) : 0;
    if (eps_p < eps_0) {
      // K eps_0^e g(x), x = eps_p/eps_0, g = (2 - e) x + (e - 1) x^2: g(1) = 1, g'(1) = e.
      const double x = eps_p / eps_0, sigma_0 = h.K * std::pow(eps_0, e);
      const double bent = x > 0 ? (e - 1) * x : 0;
      return {sigma_y + sigma_0 * x * (2 - e + bent), sigma_0 / eps_0 * (2 - e + 2 * bent)};
    }
    if (eps_p <= 0) return {sigma_y + (e == 1 ? h.K * eps_p : 0), e == 1 ? h.K : 0};
    const double power = h.K * std::pow(eps_p, e);
    return {sigma_y + power, e * power / eps_p};
  }

  YieldStress operator()(const HardeningTable& h) const {
    const auto& strain = h.strain;
    const auto& stress = h.stress;
    if (eps_p >= h.last_strain()) return {stress[h.size - 1], 0};
    const auto i = std::upper_bound(strain.begin() + 1, strain.begin() + h.size, eps_p) - strain.begin();
    const double slope = (stress[i] - stress[i - 1]) / (strain[i] - strain[i - 1]);
    return {stress[i - 1] + slope * (eps_p - strain[i - 1]), slope};
  }
};

} // namespace

YieldStress yield_stress(const Hardening& hardening, double E, double sigma_y, double eps_p) {
  return std::visit(Evaluate{E, sigma_y, eps_p}, hardening);
}

double initial_yield_stress(const Hardening& hardening, double E, double sigma_y) {
  if (const auto* h = std::get_if<Hollomon>(&hardening)) return E * yield_strain(*h, E);
  if (const auto* h = std::get_if<HardeningTable>(&hardening)) return h->stress.front();
  return sigma_y;
}

bool has_own_yield_stress(const Hardening& hardening) {
  return std::holds_alternative<Hollomon>(hardening) || std::holds_alternative<HardeningTable>(hardening);
}

} // namespace platen::material
