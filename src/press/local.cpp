#include "fe/contact_grid.hpp"
#include "press/card_fields.hpp"

namespace platen::press {

// Wang et al. 3.3: loads to 100 N.
const CardFields<Local>& card_fields(const Local*) {
  using core::closed, core::left_open, core::positive;
  using Field = core::Field<Local>;
  static const CardFields<Local> fields{
      {Field{"force_max_N", &Local::force_max_N,
             "largest force; not limited where delta_bar_max alone is given", positive}
           .optional(),
       Field{"unload_from_N", &Local::unload_from_N, "force from which a branch unloads", positive}
           .optional()
           .growing(),
       Field{"delta_bar_max", &Local::delta_bar_max, "largest delta/R0; loading ends where either is met",
             left_open(0, 0.5)}
           .optional(),
       Field{"unload_from", &Local::unload_from, "delta/R0 from which a branch unloads", left_open(0, 0.5)}
           .optional()
           .growing(),
       Field{"reload", &Local::reload, "whether each unloaded branch is loaded again"}.optional()},
      {Field{"edges", &Local::edges, "of elements under the contact, at least", closed(8, 100)}.optional(),
       Field{"first_contact_bar", &Local::first_contact_bar,
             "contact radius/R0 from which on so many edges lie under it", closed(1e-4, 0.02)}
           .optional()},
      {Field{"fields_at_N", &Local::fields_at_N, "force at which fields and the pressure profile are kept",
             positive}
           .optional()
           .growing(),
       Field{"fields_at", &Local::fields_at, "delta/R0 at which they are kept", left_open(0, 0.5)}
           .optional()
           .growing()}};
  return fields;
}

void check(const Local& e, const material::Material&, const Places& at) {
  check_within(e.unload_from, e.delta_bar_max, at.path("unload_from"));
  check_within(e.unload_from_N, e.force_max_N, at.path("unload_from_N"), "force_max_N");
  check_within(e.fields_at, e.delta_bar_max, at.output("fields_at"));
  check_within(e.fields_at_N, e.force_max_N, at.output("fields_at_N"), "force_max_N");
}

SectionPlan plan(const Local& e) {
  SectionPlan plan{.mesh = fe::contact_disc({.first_radius = e.first_contact_bar, .columns = e.edges})};
  plan.normals = {{0, 1}};
  plan.copies = {1};
  plan.equator_node = plan.mesh.surface.back()[1];
  // Local curves are compared with Hertz to parts of a per cent.
  plan.contact = {.elastic = 1000, .pole = e.first_contact_bar, .uniform = true, .flat_faces = true};
  plan.newton.relative_residual_tolerance = 1e-6;
  plan.motion = {[](double t) { return std::array{t, 0.0, 0.0}; }, {}, {}};
  // The first step presses a contact of half the smallest resolved radius; then the radius grows by half as
  // much as delta, about an edge a step.
  const double first = 0.5 * e.first_contact_bar;
  plan.steps = {
      .first = first * first, .relative_max = 0.08, .smallest = 1e-12, .unloading = 30, .separated = 1e-3};
  plan.halts = {e.delta_bar_max, e.force_max_N, e.unload_from, e.fields_at,
                e.unload_from_N, e.fields_at_N, e.reload};
  return plan;
}

} // namespace platen::press
