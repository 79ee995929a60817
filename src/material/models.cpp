#include "material/models.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

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

Model run_as(const Model& model, std::string_view name) {
  if (name == model_name(model)) return model;
  const auto* dpc = std::get_if<Dpc>(&model);
  const auto* vmdc = std::get_if<Vmdc>(&model);
  if (!dpc && !vmdc)
    throw core::InvalidInput(fmt::format(
        "a {} material cannot be run as \"{}\": only vmdc and dpc have surfaces through the same points",
        model_name(model), name));
  const Vmdc m = dpc ? dpc->vmdc() : *vmdc;
  if (name == "vmdc") return m;
  if (name == "von-mises") return VonMises{m.E, m.nu, m.Gamma};
  if (name != "dpc" && name != "dpc-published")
    throw core::InvalidInput(
        fmt::format("a {} material can be run as vmdc, dpc, dpc-published or von-mises, not as \"{}\"",
                    model_name(model), name));
  if (m.epsilon * m.Gamma >= m.sigma_y)
    throw core::InvalidInput(fmt::format(
        "this material cannot be run as dpc: its cap, epsilon Gamma = {:.6g} Pa long, would begin inside "
        "the failure line; it must be shorter than sigma_y = {:.6g} Pa",
        m.epsilon * m.Gamma, m.sigma_y));
  return Dpc::through(m, name == "dpc-published");
}

} // namespace platen::material
