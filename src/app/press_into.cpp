#include "app/press_into.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"
#include "press/estimate.hpp"
#include "press/press.hpp"

#include <fmt/format.h>

#include <limits>

namespace platen::app {
namespace {

Pressed press_and_write(const press::Case& c, const core::OutputFolder& folder, plot::Fields fields,
                        bool estimate_error) {
  core::Progress progress(fmt::format("pressing {}", c.material.name));
  const bool by_force = std::holds_alternative<press::Local>(c.experiment);
  auto result = press::press(c, [&](double fraction, const press::CurvePoint& point) {
    progress.show(fraction, by_force ? fmt::format("F = {:.3g} N", point.force_N)
                                     : fmt::format("delta_bar = {:.3f}", point.delta_bar));
    return !core::interrupted();
  });
  if (estimate_error && !result.failure && !result.interrupted) {
    core::Progress again(fmt::format("pressing {} on a coarser mesh", c.material.name));
    result.error = press::estimate_error(c, result, [&](double fraction, const press::CurvePoint&) {
      again.show(fraction, "");
      return !core::interrupted();
    });
    result.interrupted = core::interrupted();
  }
  std::string summary = plot::write_press(c, result, folder, fields);
  return {std::move(result), std::move(summary)};
}

} // namespace

Pressed press_into(const press::Case& c, const core::OutputFolder& folder, plot::Fields fields,
                   bool estimate_error) {
  Pressed pressed = press_and_write(c, folder, fields, estimate_error);
  const press::Result& result = pressed.result;
  const press::CurvePoint* end = press::loading_end(result.curve);
  const double reached = end ? end->delta_bar : 0;
  if (result.out_of_memory)
    throw core::IoError(fmt::format("{}; ask for fewer elements; the curve up to delta_bar = {:.4g} is in {}",
                                    *result.failure, reached, (folder / "curve.csv").string()));
  if (result.failure) {
    print_flags(result);
    throw core::ConvergenceError(fmt::format("{}; the curve up to delta_bar = {:.4g} is in {}",
                                             *result.failure, reached, (folder / "curve.csv").string()),
                                 result.statistics.steps, result.statistics.iterations,
                                 std::numeric_limits<double>::quiet_NaN());
  }
  if (result.interrupted)
    throw core::Interrupted(fmt::format("stopped as asked; the curve up to delta_bar = {:.4g} is in {}",
                                        reached, (folder / "curve.csv").string()));
  return pressed;
}

std::string error_words(const press::Result& result) {
  if (!result.error) return "";
  return fmt::format(
      "within about {:.2g} % in force and {:.2g} % in contact radius of the limit of fine meshes "
      "({} against {} elements)\n",
      100 * result.error->force, 100 * result.error->radius, result.error->elements,
      result.error->coarse_elements);
}

void print_flags(const press::Result& result) {
  for (const auto& flag : result.flags) core::say(fmt::format("note: {}\n", flag));
}

} // namespace platen::app
