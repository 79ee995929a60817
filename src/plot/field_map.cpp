#include "plot/field_map.hpp"

#include "core/error.hpp"
#include "plot/colour_scale.hpp"
#include "plot/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace platen::plot {

namespace {

/// Element values averaged to the nodes.
std::vector<double> nodal(const press::Snapshot& snapshot, const std::vector<double>& values) {
  std::vector<double> sum(snapshot.nodes.size(), 0), count(snapshot.nodes.size(), 0);
  for (std::size_t e = 0; e < snapshot.elements.size(); ++e)
    for (const int node : snapshot.elements[e]) {
      sum[static_cast<std::size_t>(node)] += values[e];
      count[static_cast<std::size_t>(node)] += 1;
    }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= std::max(count[n], 1.0);
  return sum;
}

/// Bilinear interpolation of nodal values to the middle of the quarter at a corner.
double at_quarter(const press::Snapshot& snapshot, const std::vector<double>& at_nodes, std::size_t element,
                  std::size_t corner) {
  constexpr std::array<double, 4> weight = {9.0 / 16, 3.0 / 16, 1.0 / 16, 3.0 / 16};
  double value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value += weight[i] * at_nodes[static_cast<std::size_t>(snapshot.elements[element][(corner + i) % 4])];
  return value;
}

Field scaled_stress(std::string name, std::vector<double> press::Snapshot::*stress, double sigma_ref_Pa) {
  return {std::move(name), [stress, sigma_ref_Pa](const press::Snapshot& snapshot) {
            std::vector<double> values = snapshot.*stress;
            for (double& value : values) value /= sigma_ref_Pa;
            return values;
          }};
}

} // namespace

Field relative_density() {
  return {"relative density", [](const press::Snapshot& snapshot) { return snapshot.rho_r; }};
}

Field deviatoric_stress(double sigma_ref_Pa) {
  return scaled_stress("q/σ_ref", &press::Snapshot::q, sigma_ref_Pa);
}

Field mean_stress(double sigma_ref_Pa) {
  return scaled_stress("p/σ_ref (tension positive)", &press::Snapshot::p, sigma_ref_Pa);
}

void field_map(const std::vector<press::Snapshot>& snapshots, const Field& field, const std::string& title,
               const std::filesystem::path& file) {
  check(snapshots);
  double low = INFINITY, high = -INFINITY;
  std::vector<std::vector<double>> at_nodes;
  for (const auto& snapshot : snapshots) {
    const std::vector<double> values = field.values(snapshot);
    if (values.size() != snapshot.elements.size())
      throw core::InvalidInput(
          fmt::format("snapshot at delta_bar = {:g}: {} has {} values, and there are {} elements",
                      snapshot.delta_bar, field.name, values.size(), snapshot.elements.size()));
    for (const double value : values)
      if (!std::isfinite(value))
        throw core::InvalidInput(fmt::format("snapshot at delta_bar = {:g}: a value of {} is not finite",
                                             snapshot.delta_bar, field.name));
    at_nodes.push_back(nodal(snapshot, values));
    const auto [least, most] = std::minmax_element(at_nodes.back().begin(), at_nodes.back().end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const Range range = round_range(low, high);
  const SnapshotColour colour = [&](const press::Snapshot& snapshot) -> Colour {
    const auto& values = at_nodes[static_cast<std::size_t>(&snapshot - snapshots.data())];
    return [&, range](std::size_t element, std::size_t corner) {
      return range.level(at_quarter(snapshot, values, element, corner));
    };
  };
  const std::vector<std::string> colours = viridis();
  Sections page = sections(snapshots, title, colour, colours);
  page.scene.height =
      std::max(page.scene.height,
               colour_bar(page.scene, {page.margin, page.legend_top + 4}, field.name, range) + page.margin);
  page.scene.description = fmt::format("{}: {} in sections through a pressed particle", title, field.name);
  write(page.scene, file);
}

} // namespace platen::plot
