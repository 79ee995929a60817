#include "material/models.hpp"

namespace platen::material {

double initial_E(const Model& model) {
  return std::visit([](const auto& m) { return m.E; }, model);
}
double initial_nu(const Model& model) {
  return std::visit([](const auto& m) { return m.nu; }, model);
}
double reference_stress(const Model& model) {
  return std::visit(
      [](const auto& m) {
        if constexpr (requires { m.reference_stress(); }) return m.reference_stress();
        else if constexpr (requires { m.sigma_y; }) return m.sigma_y;
        else return m.E;
      },
      model);
}

} // namespace platen::material
