#include "plot/press_folder.hpp"

#include "core/file.hpp"
#include "plot/confined_picture.hpp"
#include "plot/energy_picture.hpp"
#include "plot/fit_picture.hpp"
#include "plot/local_picture.hpp"
#include "plot/zone_map.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/curve_csv.hpp"
#include "press/fields_vtu.hpp"
#include "press/summary.hpp"

#include <fmt/format.h>

namespace platen::plot {
namespace {

template <class Snapshot>
void write_fields(const press::Case& c, const std::vector<Snapshot>& snapshots,
                  const core::OutputFolder& folder) {
  for (const auto& snapshot : snapshots)
    core::write_file(folder / press::fields_name(snapshot.delta_bar),
                     press::fields_vtu(snapshot, c.radius_m));
  if (!snapshots.empty()) core::write_file(folder / "fields.pvd", press::fields_series(snapshots));
}

void write_section_pictures(const press::Case& c, const press::Result& result,
                            const core::OutputFolder& folder) {
  if (!result.snapshots.empty())
    zone_map(result.snapshots, fmt::format("{}: where it flows", c.material.name), folder / "zones.svg");
}

void write_local_pictures(const press::Result& result, const core::OutputFolder& folder) {
  for (const auto& profile : result.profiles)
    core::write_file(folder / press::profile_name(profile), press::profile_csv(profile));
  if (press::loading_end(result.curve)) {
    approach_picture(result, folder / "approach.svg");
    peaks_picture(result, folder / "peaks.svg");
  }
  if (result.snapshots.empty()) return;
  pressure_picture(result, folder / "pressure.svg");
  plastic_zone_picture(result, folder / "zones.svg");
}

void write_confined_pictures(const press::Case& c, const press::Result& result,
                             const core::OutputFolder& folder) {
  if (press::loading_end(result.curve)) {
    contacts_picture(result.curve, folder / "contacts.svg");
    energy_picture(result.curve, folder / "energy.svg");
  }
  if (result.spatial.empty()) return;
  particle_picture(result.spatial, fmt::format("{}: plastic strain", c.material.name),
                   folder / "particle.svg");
  faces_picture(result.spatial, result.curve.sigma_ref_Pa,
                fmt::format("{}: contact pressure", c.material.name), folder / "faces.svg");
}

} // namespace

/// What cost most comes first: where the disk fills, the files before are whole.
std::string write_press(const press::Case& c, const press::Result& result, const core::OutputFolder& folder,
                        Fields fields) {
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
  std::string summary = press::summary_json(c, result);
  core::write_file(folder / "summary.json", summary);
  return summary;
}

void write_laws(const press::Curve& curve, const fit::DerivedLaws& laws, bool published_first,
                const core::OutputFolder& folder) {
  core::write_file(folder / (published_first ? "pressed.toml" : "law.toml"), text_of(laws.pressed_card));
  core::write_file(folder / (published_first ? "law.toml" : "edmans-sinka.toml"), text_of(laws.fitted_card));
  fit_picture(curve, laws.fitted, folder / "curve.svg");
}

void write_law(const press::Curve& curve, const fit::WangFit& law, const core::OutputFolder& folder) {
  core::write_file(folder / "law.toml", text_of(fit::law_card(curve, law, press::curve_csv(curve))));
  fit_picture(curve, law, folder / "curve.svg");
}

} // namespace platen::plot
