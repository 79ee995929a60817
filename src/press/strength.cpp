#include "press/strength.hpp"

namespace platen::press {
namespace {

struct Strength {
  using Pair = std::pair<double, double>;
  Pair operator()(const material::VonMises& m) const {
    return {0, std::holds_alternative<material::PerfectlyPlastic>(m.hardening) ? m.sigma_y : 0};
  }
  Pair operator()(const material::DruckerPrager& m) const { return {m.friction_deg(), m.sigma_c}; }
  Pair operator()(const material::MohrCoulomb& m) const { return {m.phi_deg, m.reference_stress()}; }
  Pair operator()(const auto&) const { return {0, 0}; }
};

} // namespace

std::pair<double, double> drucker_prager_strength(const material::Model& model) {
  return std::visit(Strength{}, model);
}

} // namespace platen::press
