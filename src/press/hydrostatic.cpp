#include "press/card_fields.hpp"
#include "press/confined.hpp"

namespace platen::press {

Hydrostatic::Hydrostatic()
    : ByOverlap{.delta_bar_max = hydrostatic_zero_porosity(), .elements = 5000, .step_max = 0.01} {}

const CardFields<Hydrostatic>& card_fields(const Hydrostatic*) {
  static const CardFields<Hydrostatic> fields = confined_fields<Hydrostatic>("0.194");
  return fields;
}

// How far the cell may close depends on the material.
void check(const Hydrostatic& e, const material::Material& material, const Places& at) {
  check_cell(material, {e.delta_bar_max, e.delta_bar_max, e.delta_bar_max},
             at.path("delta_bar_max", e.delta_bar_max));
  check_path(e, at, confined_resolved);
}

WedgePlan plan(const Hydrostatic& e) {
  WedgePlan plan = confined_plan(fe::Wedge::forty_eighth, e.elements, {true, true, true},
                                 {[](double t) {
                                    return std::array{t, t, t};
                                  },
                                  {},
                                  {}},
                                 e.step_max);
  plan.halts = halts_of(e);
  return plan;
}

} // namespace platen::press
