#include "press/card_fields.hpp"
#include "press/confined.hpp"

namespace platen::press {

Die::Die() : ByOverlap{.delta_bar_max = die_zero_porosity, .elements = 5000, .step_max = 0.01} {}

const CardFields<Die>& card_fields(const Die*) {
  static const CardFields<Die> fields = confined_fields<Die>("0.4764");
  return fields;
}

// How far the cell may close depends on the material.
void check(const Die& e, const material::Material& material, const Places& at) {
  check_cell(material, {e.delta_bar_max, 0, 0}, at.path("delta_bar_max", e.delta_bar_max));
  check_path(e, at, confined_resolved);
}

WedgePlan plan(const Die& e) {
  WedgePlan plan = confined_plan(fe::Wedge::sixteenth, e.elements, {true, true, true},
                                 {[](double t) {
                                    return std::array{t, 0.0, 0.0};
                                  },
                                  {},
                                  {}},
                                 e.step_max);
  plan.halts = halts_of(e);
  return plan;
}

} // namespace platen::press
