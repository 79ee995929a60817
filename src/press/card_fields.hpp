#pragma once
// How experiments describe themselves to cards: their fields, and checks of what fields cannot say alone.

#include "core/fields.hpp"
#include "core/toml.hpp"
#include "press/case.hpp"
#include "press/plan.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::press {

/// Fields of the sections of an experiment's card.
template <class X> struct CardFields { std::vector<core::Field<X>> path, mesh, output; };

/// How messages name keys: with file and line where there is a card, else by section.
struct Places {
  const core::Table *path_section = nullptr, *output_section = nullptr;
  std::string path(std::string_view key) const;
  std::string path(std::string_view key, double value) const; ///< "... key = value"
  std::string output(std::string_view key) const;
};

/// InvalidInput where a list goes beyond an end.
void check_within(const std::vector<double>&, double end, const std::string& place,
                  std::string_view end_key = "delta_bar_max");
/// `resolved`: delta/R0 from which on the mesh has the force of an elastic contact to a few per cent.
void check_path(const ByOverlap&, const Places&, double resolved);
Halts halts_of(const ByOverlap&);

// In the file of each experiment. The null pointer stands for its type.
const CardFields<Simple>& card_fields(const Simple*);
const CardFields<Local>& card_fields(const Local*);
const CardFields<Die>& card_fields(const Die*);
const CardFields<Hydrostatic>& card_fields(const Hydrostatic*);
const CardFields<Triaxial>& card_fields(const Triaxial*);
void check(const Simple&, const material::Material&, const Places&);
void check(const Local&, const material::Material&, const Places&);
void check(const Die&, const material::Material&, const Places&);
void check(const Hydrostatic&, const material::Material&, const Places&);
void check(const Triaxial&, const material::Material&, const Places&);

template <class X> std::vector<core::Field<X>> mesh_fields(std::string elements, core::Interval allowed) {
  return {core::Field<X>{"elements", &X::elements, std::move(elements), allowed}.optional(),
          core::Field<X>{"step_max", &X::step_max, "largest step of delta/R0", core::left_open(0, 0.05)}
              .optional()};
}
template <class X> std::vector<core::Field<X>> output_fields(std::string fields_at, core::Interval allowed) {
  return {core::Field<X>{"fields_at", &X::fields_at, std::move(fields_at), allowed}.optional().growing()};
}
template <class X>
CardFields<X> by_overlap_fields(std::string largest, core::Interval overlaps, std::string elements,
                                core::Interval counts) {
  return {{core::Field<X>{"delta_bar_max", &X::delta_bar_max, std::move(largest), overlaps}.optional(),
           core::Field<X>{"unload_from", &X::unload_from, "delta/R0 from which a branch unloads", overlaps}
               .optional()
               .growing(),
           core::Field<X>{"reload", &X::reload, "whether each unloaded branch is loaded again"}.optional()},
          mesh_fields<X>(std::move(elements), counts),
          output_fields<X>("delta/R0 at which fields are kept", overlaps)};
}
/// `end`: zero porosity, as text.
template <class X> CardFields<X> confined_fields(const std::string& end) {
  return by_overlap_fields<X>("largest delta/R0; by default that of zero porosity, " + end,
                              core::left_open(0, 1), "wanted number of hexahedra in the wedge",
                              core::closed(200, 60000));
}

} // namespace platen::press
