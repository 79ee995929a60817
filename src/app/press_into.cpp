#include "app/press_into.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"
#include "plot/confined_picture.hpp"
#include "plot/energy_picture.hpp"
#include "plot/local_picture.hpp"
#include "plot/zone_map.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/curve_csv.hpp"
#include "press/estimate.hpp"
#include "press/fields_vtu.hpp"
#include "press/press.hpp"
#include "press/summary.hpp"

#include <fmt/format.h>

#include <limits>

namespace platen::app {
namespace {

template <class Snapshot>
void write_fields(const press::Case& c, const std::vector<Snapshot>& snapshots, const OutputFolder& folder) {
  for (const auto& snapshot : snapshots)
    core::write_file(folder / press::fields_name(snapshot.delta_bar),
                     press::fields_vtu(snapshot, c.radius_m));
  if (!snapshots.empty()) core::write_file(folder / "fields.pvd", press::fields_series(snapshots));
}

void write_section_pictures(const press::Case& c, const press::Result& result, const OutputFolder& folder) {
  if (!result.snapshots.empty())
    plot::zone_map(result.snapshots, fmt::format("{}: where it flows", c.material.name),
                   folder / "zones.svg");
}

void write_local_pictures(const press::Result& result, const OutputFolder& folder) {
  for (const auto& profile : result.profiles)
    core::write_file(folder / press::profile_name(profile), press::profile_csv(profile));
  if (press::loading_end(result.curve)) {
    plot::approach_picture(result, folder / "approach.svg");
    plot::peaks_picture(result, folder / "peaks.svg");
  }
  if (result.snapshots.empty()) return;
  plot::pressure_picture(result, folder / "pressure.svg");
  plot::plastic_zone_picture(result, folder / "zones.svg");
}

void write_confined_pictures(const press::Case& c, const press::Result& result, const OutputFolder& folder) {
  if (press::loading_end(result.curve)) {
    plot::contacts_picture(result.curve, folder / "contacts.svg");
    plot::energy_picture(result.curve, folder / "energy.svg");
  }
  if (result.spatial.empty()) return;
  plot::particle_picture(result.spatial, fmt::format("{}: plastic strain", c.material.name),
                         folder / "particle.svg");
  plot::faces_picture(result.spatial, result.curve.sigma_ref_Pa,
                      fmt::format("{}: contact pressure", c.material.name), folder / "faces.svg");
}

/// What cost most comes first: where the disk fills, the files before are whole.
Pressed written(const press::Case& c, press::Result result, const OutputFolder& folder, Fields fields) {
  folder.forget({"case.toml", "curve.csv", "summary.json", "zones.svg", "curve.svg", "law.toml", "fields.pvd",
                 "approach.svg", "peaks.svg", "pressure.svg", "contacts.svg", "energy.svg", "particle.svg",
                 "faces.svg"});
  folder.forget_series("fields-", ".vtu");
  folder.forget_series("profile-", ".csv");
  press::write_curve(result.curve, folder / "curve.csv");
  core::write_file(folder / "case.toml", press::case_text(c));
  if (std::holds_alternative<press::Local>(c.experiment)) write_local_pictures(result, folder);
  else if (press::is_confined(c.experiment)) write_confined_pictures(c, result, folder);
  else write_section_pictures(c, result, folder);
  if (fields == Fields::pictures_and_vtu) {
    write_fields(c, result.snapshots, folder);
    write_fields(c, result.spatial, folder);
  }
  // Last: where there is a summary, the rest is there as well.
  Pressed pressed{std::move(result), ""};
  pressed.summary = press::summary_json(c, pressed.result);
  core::write_file(folder / "summary.json", pressed.summary);
  return pressed;
}

Pressed press_and_write(const press::Case& c, const OutputFolder& folder, Fields fields,
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
  return written(c, std::move(result), folder, fields);
}

} // namespace

Pressed press_into(const press::Case& c, const OutputFolder& folder, Fields fields, bool estimate_error) {
  Pressed pressed = press_and_write(c, folder, fields, estimate_error);
  const press::Result& result = pressed.result;
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
