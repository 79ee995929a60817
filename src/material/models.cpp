#include "material/models.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <concepts>
#include <type_traits>

namespace platen::material {

double initial_E(const Model& model) {
  return std::visit([](const auto& m) { return m.E; }, model);
}
double initial_nu(const Model& model) {
  return std::visit([](const auto& m) { return m.nu; }, model);
}
double reference_stress(const Model& model) {
  return std::visit([](const auto& m) { return m.reference_stress(); }, model);
}
std::string_view model_name(const Model& model) {
  return std::visit([](const auto& m) { return m.name; }, model);
}

Model run_as(const Model& model, std::string_view name) {
  if (name == model_name(model)) return model;
  const auto* porous = std::visit(
      [](const auto& m) -> const Porous* {
        if constexpr (std::derived_from<std::remove_cvref_t<decltype(m)>, Porous>) return &m;
        else return nullptr;
      },
      model);
  if (!porous)
    throw core::InvalidInput(fmt::format(
        "a {} material cannot be run as \"{}\": only vmdc and dpc have surfaces through the same points",
        model_name(model), name));
  if (name == Vmdc::name) return Vmdc{*porous};
  if (name == VonMises::name) return VonMises{porous->E, porous->nu, porous->Gamma};
  const bool published = name == "dpc-published";
  if (name != Dpc::name && !published)
    throw core::InvalidInput(
        fmt::format("a {} material can be run as vmdc, dpc, dpc-published or von-mises, not as \"{}\"",
                    model_name(model), name));
  const Dpc dpc{*porous, published};
  if (!dpc.cap_fits())
    throw core::InvalidInput(fmt::format(
        "this material cannot be run as dpc: its cap, epsilon Gamma = {:.6g} Pa long, would begin inside "
        "the failure line; it must be shorter than sigma_y = {:.6g} Pa",
        dpc.epsilon * dpc.Gamma, dpc.sigma_y));
  return dpc;
}

} // namespace platen::material
