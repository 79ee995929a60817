#include "material/walk.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::material {
namespace {

void check(const Way& way) {
  const auto refuse = [](const char* key, const auto& value, const char* rule) {
    throw core::InvalidInput(fmt::format("{} {}: it must be {}", key, value, rule));
  };
  if (!(std::abs(way.strain) > 0 && std::abs(way.strain) <= 3))
    refuse("strain", core::number_text(way.strain), "a number in [-3, 3] other than 0");
  if (!std::isfinite(way.lateral_Pa))
    refuse("lateral_Pa", core::number_text(way.lateral_Pa), "a finite number");
  if (!(way.compaction >= 0 && way.compaction <= 3))
    refuse("compaction", core::number_text(way.compaction), "a number in [0, 3]");
  if (way.steps < 1 || way.steps > 1000000) refuse("steps", way.steps, "a whole number in [1, 1000000]");
  if (way.moduli != "implicit" && way.moduli != "after-step")
    refuse("moduli", way.moduli, "implicit or after-step");
  for (std::size_t i = 0; i < way.rows.size(); ++i)
    for (const double eps : way.rows[i])
      if (!std::isfinite(eps))
        throw core::InvalidInput(fmt::format("{}: row {}: strains must be finite numbers", way.name, i + 1));
}

/// Increments of the ways that go by strain alone.
std::vector<Strains> increments(const Way& way) {
  const auto even = [&](Strains whole) {
    for (double& eps : whole) eps /= way.steps;
    return std::vector<Strains>(static_cast<std::size_t>(way.steps), whole);
  };
  const double third = way.strain / 3;
  if (way.name == "isotropic") return even({third, third, third});
  if (way.name == "uniaxial-strain") return even({way.strain, 0, 0});
  if (way.name == "shear") {
    auto all = even({-way.compaction / 3, -way.compaction / 3, -way.compaction / 3});
    if (way.compaction == 0) all.clear();
    const auto shear = even({way.strain, -way.strain, 0});
    all.insert(all.end(), shear.begin(), shear.end());
    return all;
  }
  std::vector<Strains> all;
  Strains before{};
  for (const auto& here : way.rows) {
    Strains step;
    for (std::size_t A = 0; A < 3; ++A) step[A] = here[A] - before[A];
    all.push_back(step);
    before = here;
  }
  return all;
}

} // namespace

const std::vector<std::string>& way_names() {
  static const std::vector<std::string> names = {"isotropic", "uniaxial-strain", "triaxial", "shear"};
  return names;
}

bool is_named(const Way& way) { return std::ranges::count(way_names(), way.name) > 0; }

std::vector<Strains> read_strains(const std::string& file) {
  const auto csv = core::read_csv(file);
  const std::array columns{csv.column("eps_1"), csv.column("eps_2"), csv.column("eps_3")};
  std::vector<Strains> rows;
  for (const auto& row : csv.rows) {
    rows.emplace_back();
    for (std::size_t A = 0; A < 3; ++A) rows.back()[A] = csv.number(row, columns[A]);
  }
  if (rows.empty()) throw core::InvalidInput(file + ": there is no row below the header");
  return rows;
}

Walk walk(const Model& model, const Way& way) {
  check(way);
  if (!is_named(way) && way.rows.empty())
    throw core::InvalidInput(fmt::format("path {}: neither a path{} nor a file", way.name,
                                         core::suggestion(way.name, way_names())));
  const auto scheme = way.moduli == "implicit" ? ModuliScheme::implicit : ModuliScheme::after_step;
  Walk w{{MaterialPoint{}}, ""};
  const auto take = [&](const MaterialPoint& next) {
    if (is_refused(next.last.status)) {
      w.refusal =
          fmt::format("step {} was refused: {}", w.points.size(),
                      next.last.status == Status::unstable
                          ? "densification raises the elastic stress faster than the surface gives way"
                          : "no admissible state was found; try more steps");
      return false;
    }
    w.points.push_back(next);
    return true;
  };
  if (way.name == "triaxial") {
    // The lateral stress first, all around, then the axis.
    const double bulk = initial_E(model) / (3 * (1 - 2 * initial_nu(model)));
    const double first = way.lateral_Pa / (3 * bulk);
    if (way.lateral_Pa != 0 && !take(strained_axially(model, w.points.back(), first, way.lateral_Pa, scheme)))
      return w;
    for (int i = 0; i < way.steps; ++i)
      if (!take(strained_axially(model, w.points.back(), way.strain / way.steps, way.lateral_Pa, scheme)))
        return w;
    return w;
  }
  for (const Strains& step : increments(way))
    if (!take(strained(model, w.points.back(), step, scheme))) return w;
  return w;
}

} // namespace platen::material
