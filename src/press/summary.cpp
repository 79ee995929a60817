#include "press/summary.hpp"

#include "core/toml.hpp"
#include "core/version.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/regimes.hpp"
#include "press/tension.hpp"

#include <nlohmann/json.hpp>

namespace platen::press {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const core::Table&);
Json json_of(const core::Value&);

struct Convert {
  Json operator()(const core::Table& table) const { return json_of(table); }
  Json operator()(const std::vector<core::Value>& items) const {
    Json list = Json::array();
    for (const auto& item : items) list.push_back(json_of(item));
    return list;
  }
  Json operator()(const auto& scalar) const { return scalar; }
};

Json json_of(const core::Value& value) { return std::visit(Convert{}, value.data); }

Json json_of(const core::Table& table) {
  Json object = Json::object();
  for (const auto& [key, value] : table.entries) object[key] = json_of(value);
  return object;
}

Json json_of(const Statistics& s) {
  return {{"steps", s.steps},
          {"iterations", s.iterations},
          {"cuts", s.cuts},
          {"elements", s.elements},
          {"unknowns", s.unknowns},
          {"local_continuations", s.local_continuations},
          {"quadratic_steps", s.quadratic_steps},
          {"material_s", s.material_s},
          {"assembly_s", s.assembly_s},
          {"factorisation_s", s.factorisation_s},
          {"solve_s", s.solve_s},
          {"total_s", s.total_s}};
}

/// Of loading: branches go back from it.
Json last_point(const Curve& curve) {
  const CurvePoint* p = loading_end(curve);
  if (!p) return nullptr;
  return {{"delta_bar", p->delta_bar},
          {"F_bar", p->F_bar},
          {"force_N", p->force_N},
          {"contact_radius_m", p->contact_radius_m},
          {"work_J", p->work_J}};
}

Json json_of(const Tension& tension) {
  constexpr const char* branches[] = {"loading", "unloading", "reloading"};
  return {{"sigma_1_Pa", tension.sigma_1_Pa},
          {"delta_bar", tension.delta_bar},
          {"branch", branches[static_cast<int>(tension.branch)]},
          {"branch_id", tension.branch_id}};
}

Json fracture_of(const Case& c, const Curve& curve) {
  if (!c.material.tensile_strength) return nullptr;
  const auto first = fracture(curve, *c.material.tensile_strength);
  return {{"tensile_strength_Pa", *c.material.tensile_strength},
          {"reached", first ? json_of(*first) : Json(nullptr)}};
}

} // namespace

namespace {

Json summary_of(const Case& c, const Result& result) {
  Json summary = {{"platen", core::version}, {"engine", core::engine}};
  // Through the text of the card, so that card and summary cannot say different things.
  summary["case"] = json_of(core::parse_toml(case_text(c), "case"));
  summary["complete"] = !result.failure && !result.interrupted;
  summary["failure"] = result.failure ? Json(*result.failure) : Json(nullptr);
  summary["interrupted"] = result.interrupted;
  summary["points"] = result.curve.points.size();
  summary["last_point"] = last_point(result.curve);
  summary["largest_tension"] = json_of(largest_tension(result.curve));
  summary["fracture"] = fracture_of(c, result.curve);
  summary["flags"] = result.flags;
  if (const auto& e = result.error)
    summary["error_estimate"] = {{"force_relative", e->force},
                                 {"contact_radius_relative", e->radius},
                                 {"elements", e->elements},
                                 {"coarse_elements", e->coarse_elements}};
  summary["statistics"] = json_of(result.statistics);
  return summary;
}

std::string text_of(const Json& summary) {
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json json_of(const std::optional<Onset>& onset) {
  if (!onset) return nullptr;
  return {{"force_N", onset->force_N}, {"r_over_a", onset->r_over_a}, {"depth_over_a", onset->depth_over_a}};
}

Json json_of(const Regimes& found) {
  Json json = Json::object();
  for (const auto& boundary : regime_boundaries()) {
    const auto& at = found.*boundary.delta_bar;
    json[boundary.key] =
        at ? Json{{"from_delta_bar", *at}, {"criterion", boundary.criterion}} : Json(nullptr);
  }
  json["yields_in_first_row"] = found.yields_in_first_row;
  json["stored_share_at_end"] = found.stored_share_at_end ? Json(*found.stored_share_at_end) : Json(nullptr);
  return json;
}

} // namespace

std::string summary_json(const Case& c, const Result& result) {
  Json summary = summary_of(c, result);
  if (std::holds_alternative<Local>(c.experiment)) {
    summary["yield_on_axis"] = json_of(result.axis);
    summary["yield_at_edge"] = json_of(result.edge);
    Json broken = Json::array();
    for (const auto& b : result.break_through)
      broken.push_back({{"plastic_strain", b.plastic_strain}, {"force_N", b.force_N}});
    summary["break_through"] = broken;
  }
  if (!is_confined(c.experiment)) return text_of(summary);
  if (const CurvePoint* p = loading_end(result.curve)) {
    summary["cell_filling"] = p->cell_filling;
    summary["mesh_quality"] = p->mesh_quality;
    constexpr std::array axes{"z", "x", "y"};
    for (int k = 0; k < 3; ++k) {
      const PlanePoint& plane = p->plane(k);
      summary["planes"][axes[k]] = {{"delta_m", plane.delta_m},
                                    {"force_N", plane.force_N},
                                    {"contact_radius_m", plane.contact_radius_m},
                                    {"mean_pressure_Pa", plane.mean_pressure_Pa}};
    }
  }
  summary["regimes"] = json_of(regimes(result.curve));
  return text_of(summary);
}

} // namespace platen::press
