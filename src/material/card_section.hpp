#pragma once
// What a model says of its card: the one description behind reading, messages, writing and the reference
// page.

#include "core/fields.hpp"

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace platen::material {

/// Key, value in SI units (a choice: 1 or 0), meaning.
struct Parameter {
  std::string key;
  double value;
  std::string meaning;
};

/// A line of a card.
struct CardEntry {
  std::string key; ///< "hardening.kind": stands in the section `hardening`, written in one line
  core::FieldValue value;
  std::string_view meaning; ///< the field's own
};

/// "key = value" lines; none where there is no value.
std::string card_lines(const std::vector<CardEntry>&);
/// The numbers and choices among the entries.
std::vector<Parameter> parameters(const std::vector<CardEntry>&);

/// The section of a card that describes a T. `others`: keys of the section that somebody else reads.
template <class T> struct CardSection {
  std::vector<core::FieldInfo> fields;
  std::function<T(const core::Table&, std::span<const std::string> others)> read;
  std::function<std::vector<CardEntry>(const T&)> entries;
  std::string note; ///< under the table of the reference page
};

template <class T>
std::vector<CardEntry> entries_of(const std::vector<core::Field<T>>& fields, const T& object) {
  std::vector<CardEntry> entries;
  entries.reserve(fields.size());
  for (const auto& field : fields)
    entries.push_back({field.key, core::value_of(field, object), field.meaning});
  return entries;
}

/// A section whose fields fill a `Given`, from which `make` makes a T, or says with InvalidInput why it
/// cannot, and which `given` gives back.
template <class T, class Given = T>
CardSection<T> section_of(
    std::vector<core::Field<Given>> fields,
    std::type_identity_t<std::function<T(const core::Table&, const Given&)>> make =
        [](const core::Table&, const T& all) { return all; },
    std::type_identity_t<std::function<Given(const T&)>> given = std::identity{}, std::string note = {}) {
  return {core::infos<Given>(fields),
          [fields, make = std::move(make)](const core::Table& table, std::span<const std::string> others) {
            return make(table, core::read_fields<Given>(table, fields, {}, others));
          },
          [fields = std::move(fields), given = std::move(given)](const T& object) {
            return entries_of(fields, given(object));
          },
          std::move(note)};
}

} // namespace platen::material
