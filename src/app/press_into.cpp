#include "app/press_into.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"
#include "plot/local_picture.hpp"
#include "plot/zone_map.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/fields_vtu.hpp"
#include "press/summary.hpp"

#include <fmt/format.h>

#include <limits>

namespace platen::app {
namespace {

press::LocalResult press_with_progress(const press::Case& c) {
  core::Progress progress(fmt::format("pressing {}", c.material.name));
  if (c.experiment == "local")
    return press::local(c, [&](double fraction, const press::CurvePoint& point) {
      progress.show(fraction, fmt::format("F = {:.3g} N", point.force_N));
      return !core::interrupted();
    });
  return {press::simple(c,
                        [&](double fraction, const press::CurvePoint& point) {
                          progress.show(fraction, fmt::format("delta_bar = {:.3f}", point.delta_bar));
                          return !core::interrupted();
                        }),
          {},
          {},
          {},
          {}};
}

void write_fields(const press::Case& c, const press::Result& result, const OutputFolder& folder) {
  for (const auto& snapshot : result.snapshots)
    core::write_file(folder / press::fields_name(snapshot), press::fields_vtu(snapshot, c.radius_m));
  core::write_file(folder / "fields.pvd", press::fields_series(result.snapshots));
}

void write_local(const press::Case& c, const press::LocalResult& result, const OutputFolder& folder,
                 Fields fields) {
  for (const auto& profile : result.profiles)
    core::write_file(folder / press::profile_name(profile), press::profile_csv(profile));
  if (!result.snapshots.empty() && fields == Fields::pictures_and_vtu) write_fields(c, result, folder);
  if (press::loading_end(result.curve)) {
    plot::approach_picture(result, folder / "approach.svg");
    plot::peaks_picture(result, folder / "peaks.svg");
  }
  if (result.snapshots.empty()) return;
  plot::pressure_picture(result, folder / "pressure.svg");
  plot::plastic_zone_picture(result, folder / "zones.svg");
}

/// What cost most comes first: where the disk fills, the files before are whole.
void write_results(const press::Case& c, const press::LocalResult& result, const OutputFolder& folder,
                   Fields fields) {
  folder.forget({"case.toml", "curve.csv", "summary.json", "zones.svg", "curve.svg", "law.toml", "fields.pvd",
                 "approach.svg", "peaks.svg", "pressure.svg"});
  folder.forget_series("fields-", ".vtu");
  folder.forget_series("profile-", ".csv");
  press::write_curve(result.curve, folder / "curve.csv");
  core::write_file(folder / "case.toml", press::case_text(c));
  const bool local = c.experiment == "local";
  if (local) write_local(c, result, folder, fields);
  if (!result.snapshots.empty() && !local) {
    plot::zone_map(result.snapshots, fmt::format("{}: where it flows", c.material.name),
                   folder / "zones.svg");
    if (fields == Fields::pictures_and_vtu) write_fields(c, result, folder);
  }
  // Last: where there is a summary, the rest is there as well.
  core::write_file(folder / "summary.json",
                   local ? press::summary_json(c, result)
                         : press::summary_json(c, static_cast<const press::Result&>(result)));
}

} // namespace

press::LocalResult press_into(const press::Case& c, const OutputFolder& folder, Fields fields) {
  press::LocalResult result = press_with_progress(c);
  write_results(c, result, folder, fields);
  const press::CurvePoint* end = press::loading_end(result.curve);
  const double reached = end ? end->delta_bar : 0;
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
  return result;
}

void print_flags(const press::Result& result) {
  for (const auto& flag : result.flags) core::say(fmt::format("note: {}\n", flag));
}

} // namespace platen::app
