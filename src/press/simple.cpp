#include "press/simple.hpp"

#include "core/error.hpp"
#include "press/by_overlap.hpp"

namespace platen::press {
namespace {

void check(const Case& c) {
  const auto refuse = [](const std::string& what) { throw core::InvalidInput(what); };
  if (!(c.delta_bar_max > 0 && c.delta_bar_max <= 0.5)) refuse("delta_bar_max must lie in (0, 0.5]");
  if (!(c.radius_m > 0)) refuse("radius_m must be positive");
  if (!(c.step_max > 0)) refuse("step_max must be positive");
  if (c.elements < 32 || c.elements > 200000) refuse("elements must lie in [32, 200000]");
  for (const double d : c.unload_from)
    if (!(d > 0 && d <= c.delta_bar_max)) refuse("unload_from must lie in (0, delta_bar_max]");
  for (const double d : c.fields_at)
    if (!(d > 0 && d <= c.delta_bar_max)) refuse("fields_at must lie in (0, delta_bar_max]");
}

} // namespace

Result simple(const Case& c, const Progress& progress) {
  check(c);
  return PressByOverlap<SphereRun>(c, progress)();
}

} // namespace platen::press
