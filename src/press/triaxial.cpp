#include "core/error.hpp"
#include "press/card_fields.hpp"
#include "press/confined.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::press {
namespace {

using Waypoint = std::array<double, 3>; ///< delta/R0 along z, x, y

/// From no overlap on; the time grows by the largest change of an overlap.
struct History {
  std::array<bool, 3> present;
  std::vector<Waypoint> points{{0, 0, 0}};
  std::vector<double> times{0};
};

History history_of(const Triaxial& e) {
  const std::array<const std::vector<double>*, 3> lists{&e.delta_bar_z, &e.delta_bar_x, &e.delta_bar_y};
  History h;
  for (int k = 0; k < 3; ++k) h.present[k] = !lists[k]->empty();
  for (std::size_t i = 0; i < e.delta_bar_z.size(); ++i) {
    Waypoint next{};
    double change = 0;
    for (int k = 0; k < 3; ++k) {
      if (h.present[k]) next[k] = (*lists[k])[i];
      change = std::max(change, std::abs(next[k] - h.points.back()[k]));
    }
    h.times.push_back(h.times.back() + change);
    h.points.push_back(next);
  }
  return h;
}

Motion motion_of(const History& h) {
  Motion m;
  for (std::size_t i = 1; i < h.points.size(); ++i) {
    double approach = 0;
    for (int k = 0; k < 3; ++k) approach += h.points[i][k] - h.points[i - 1][k];
    m.retreats.push_back(approach < 0);
  }
  m.turns.assign(h.times.begin() + 1, h.times.end());
  m.overlaps_at = [h](double t) {
    std::size_t leg = 1;
    while (leg + 1 < h.times.size() && t > h.times[leg]) ++leg;
    const double share = (t - h.times[leg - 1]) / (h.times[leg] - h.times[leg - 1]);
    Waypoint at{};
    for (int k = 0; k < 3; ++k)
      at[k] = t == h.times[leg] ? h.points[leg][k]
                                : (1 - share) * h.points[leg - 1][k] + share * h.points[leg][k];
    return at;
  };
  return m;
}

} // namespace

const CardFields<Triaxial>& card_fields(const Triaxial*) {
  using core::Field;
  static const CardFields<Triaxial> fields{
      {{"delta_bar", &Triaxial::delta_bar_z,
        "delta/R0 of the planes along z, waypoint by waypoint; the planes go straight from one to the next",
        core::right_open(0, 1)},
       Field<Triaxial>{"delta_bar_x", &Triaxial::delta_bar_x,
                       "the same along x; without it there are no planes", core::right_open(0, 1)}
           .optional(),
       Field<Triaxial>{"delta_bar_y", &Triaxial::delta_bar_y, "the same along y", core::right_open(0, 1)}
           .optional()},
      mesh_fields<Triaxial>("wanted number of hexahedra in the wedge", core::closed(200, 60000)),
      output_fields<Triaxial>(
          "delta/R0 at which fields are kept; triaxial: the way that the plane that moves most has gone",
          core::left_open(0, 10))};
  return fields;
}

void check(const Triaxial& e, const material::Material& material, const Places& at) {
  const std::size_t n = e.delta_bar_z.size();
  for (const auto& [list, key] : {std::pair{&e.delta_bar_x, "delta_bar_x"}, {&e.delta_bar_y, "delta_bar_y"}})
    if (!list->empty() && list->size() != n)
      throw core::InvalidInput(fmt::format("{} has {} waypoints and delta_bar has {}; give as many",
                                           at.path(key), list->size(), n));
  if (n == 0) throw core::InvalidInput(fmt::format("{} needs a waypoint", at.path("delta_bar")));
  const History h = history_of(e);
  for (std::size_t i = 1; i <= n; ++i) {
    if (h.points[i] == h.points[i - 1])
      throw core::InvalidInput(fmt::format("{}: at waypoint {} nothing moves", at.path("delta_bar"), i));
    if (h.present[1] && h.present[2])
      check_cell(material, h.points[i], fmt::format("{}: waypoint {}", at.path("delta_bar"), i));
  }
  check_within(e.fields_at, h.times.back(), at.output("fields_at"), "the way of the planes");
}

double path_length(const Triaxial& e) { return history_of(e).times.back(); }

WedgePlan plan(const Triaxial& e) {
  const History h = history_of(e);
  const fe::Wedge wedge = e.delta_bar_x != e.delta_bar_y   ? fe::Wedge::octant
                          : e.delta_bar_x == e.delta_bar_z ? fe::Wedge::forty_eighth
                                                           : fe::Wedge::sixteenth;
  WedgePlan plan = confined_plan(wedge, e.elements, h.present, motion_of(h), e.step_max);
  plan.halts = {.end = h.times.back(), .fields_at = e.fields_at};
  return plan;
}

} // namespace platen::press
