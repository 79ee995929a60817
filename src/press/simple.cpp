#include "core/fields.hpp"
#include "fe/quarter_disc.hpp"
#include "press/card_fields.hpp"
#include "press/confined.hpp"

namespace platen::press {

// delta_bar ends at 0.5, where the published simulations end (Edmans & Sinka, section 4).
const CardFields<Simple>& card_fields(const Simple*) {
  static const CardFields<Simple> fields = by_overlap_fields<Simple>(
      "largest delta/R0", core::left_open(0, 0.5), "wanted number of elements; the mesh comes close to it",
      core::closed(32, 200000));
  return fields;
}

// Of an elastic sphere the force is 4 % above Hertz's at 1e-4, 18 % at 1e-5, 71 % at 1e-6.
void check(const Simple& e, const material::Material&, const Places& at) { check_path(e, at, 1e-4); }

namespace {
Motion upright() {
  return {[](double t) { return std::array{t, 0.0, 0.0}; }, {}, {}};
}
} // namespace

SectionPlan plan(const Simple& e) {
  SectionPlan plan{.mesh = fe::quarter_disc(e.elements)};
  plan.normals = {{0, 1}};
  plan.copies = {1};
  plan.equator_node = plan.mesh.surface.back()[1];
  plan.motion = upright();
  plan.steps = {.first = 1e-4, .relative_max = 0.04, .largest = e.step_max};
  plan.halts = halts_of(e);
  return plan;
}

WedgePlan plan_in_space(const Simple& e) {
  WedgePlan plan =
      confined_plan(fe::Wedge::sixteenth, e.elements, {true, false, false}, upright(), 2 * e.step_max);
  plan.halts = halts_of(e);
  return plan;
}

} // namespace platen::press
