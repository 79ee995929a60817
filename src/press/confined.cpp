#include "press/confined.hpp"

#include "core/error.hpp"
#include "material/update.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::press {

double hydrostatic_zero_porosity() { return 1 - std::cbrt(std::numbers::pi / 6); }

double cell_volume(const std::array<double, 3>& overlaps) {
  return 8 * (1 - overlaps[0]) * (1 - overlaps[1]) * (1 - overlaps[2]) / (4 * std::numbers::pi / 3);
}

void check_cell(const material::Material& material, const std::array<double, 3>& overlaps,
                const std::string& place) {
  const double solid = material::relative_density(material.model, 0);
  const double left = cell_volume(overlaps) / solid;
  if (left < 1 / fullest * (1 - 1e-9))
    throw core::InvalidInput(fmt::format(
        "{} leaves the cell {:.3g} of the volume of the particle's solid; the press goes down to {:.2g}",
        place, left, 1 / fullest));
}

bool is_confined(const Experiment& experiment) {
  return !std::holds_alternative<Simple>(experiment) && !std::holds_alternative<Local>(experiment);
}

WedgePlan confined_plan(fe::Wedge wedge, int elements, std::array<bool, 3> present, Motion motion,
                        double step_max) {
  WedgePlan plan{.mesh = fe::sphere_wedge(wedge, elements)};
  const auto group = fe::copies(plan.mesh);
  // Where planes with the same history are images of each other, one stands for them.
  constexpr std::array<fe::Vector3, 3> axes{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  const auto image = [](const std::array<fe::Vector3, 3>& g, const fe::Vector3& x) {
    return fe::Vector3{fe::dot(g[0], x), fe::dot(g[1], x), fe::dot(g[2], x)};
  };
  const auto same = [](const fe::Vector3& a, const fe::Vector3& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])}) < 1e-9;
  };
  const auto copies_onto = [&](const fe::Vector3& from, const fe::Vector3& to) {
    return static_cast<int>(
        std::count_if(group.begin(), group.end(), [&](const auto& g) { return same(image(g, from), to); }));
  };
  for (int k = 0; k < 3; ++k) {
    plan.plane_of[k] = -1;
    if (!present[k]) continue;
    for (int other = 0; other < k; ++other)
      if (present[other] && copies_onto(axes[other], axes[k]) > 0) plan.plane_of[k] = plan.plane_of[other];
    if (plan.plane_of[k] >= 0) continue;
    plan.plane_of[k] = static_cast<int>(plan.normals.size());
    plan.normals.push_back(axes[k]);
    plan.copies.push_back(copies_onto(axes[k], axes[k]));
  }
  plan.halves = static_cast<double>(group.size()) / 2;
  for (std::size_t n = 0; n < plan.mesh.nodes.size(); ++n)
    if (copies_onto(plan.mesh.nodes[n], axes[1]) > 0) plan.equator_node = static_cast<int>(n);
  plan.contact = {.flat_faces = true};
  plan.motion = std::move(motion);
  plan.steps = {.first = 5e-4, .relative_max = 0.1, .largest = step_max};
  return plan;
}

} // namespace platen::press
