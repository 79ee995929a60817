#include "plot/zone_map.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"
#include "plot/section.hpp"

#include <fmt/format.h>

namespace platen::plot {

namespace {

/// In the order of press::Zone. ES's hues; their lightness differs too, so that they stay apart for the
/// colour-blind and in grey print.
const std::vector<std::string> palette = {"#3b6fb5", "#f6c945", "#b5283b", "#7cc07a"};
const std::vector<std::string> names = {"elastic", "shear", "compaction", "tension"};

} // namespace

std::string zone_colour(press::Zone zone) { return palette[static_cast<std::size_t>(zone)]; }
std::string zone_name(press::Zone zone) { return names[static_cast<std::size_t>(zone)]; }

void zone_map(const std::vector<press::Snapshot>& snapshots, const std::string& title,
              const std::filesystem::path& file) {
  for (const auto& snapshot : snapshots)
    if (snapshot.zones.size() != snapshot.elements.size())
      throw core::InvalidInput(
          fmt::format("snapshot at delta_bar = {:g}: zones of {} elements, and there are {}",
                      snapshot.delta_bar, snapshot.zones.size(), snapshot.elements.size()));
  const SnapshotColour colour = [](const press::Snapshot& snapshot) -> Colour {
    return [&](std::size_t element, std::size_t corner) {
      return static_cast<int>(snapshot.zones[element][corner]);
    };
  };
  Sections page = sections(snapshots, title, colour, palette);
  double x = page.margin;
  for (const std::size_t i : {2u, 1u, 3u, 0u}) {
    const double y = page.legend_top + 7;
    page.scene.items.push_back(Polygon{{{x, y}, {x + 14, y}, {x + 14, y + 14}, {x, y + 14}}, palette[i]});
    page.scene.items.push_back(Text{{x + 20, y + 12}, names[i], 14, Anchor::start, ink, false});
    x += 20 + 8.0 * static_cast<double>(names[i].size()) + 14;
  }
  page.scene.description =
      fmt::format("{}: zones of plastic flow in sections through a pressed particle", title);
  write(page.scene, file);
}

} // namespace platen::plot
