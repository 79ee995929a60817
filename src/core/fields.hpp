#pragma once
// A card section as a table of fields. The one table gives reading, validation, messages, writing, and the
// page of the reference; so they cannot disagree.

#include "core/toml.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace platen::core {

/// The numbers that a field admits.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = false, high_included = false;

  bool contains(double) const;
  std::string text() const; ///< "in (0, 0.5]", "> 0", "any number"
};

inline constexpr Interval any_number{};
inline constexpr Interval positive{.low = 0};
inline constexpr Interval closed(double low, double high) { return {low, high, true, true}; }
inline constexpr Interval left_open(double low, double high) { return {low, high, false, true}; }
inline constexpr Interval right_open(double low, double high) { return {low, high, true, false}; }

using FieldValue = std::variant<std::monostate, double, int, bool, std::string, std::vector<double>>;

/// What is known of a field without the type it belongs to.
struct FieldInfo {
  std::string key;
  std::string meaning;
  Interval allowed;
  bool required = true;
  std::size_t kind = 0;       ///< index in FieldValue
  std::string ratio_key = {}; ///< "E_bar": may be given instead, as a multiple of ...
  std::string ratio_of = {};  ///< ... "sigma_y_Pa"
  bool ascending = false;     ///< a list that grows
  std::string rule = {};      ///< ", at most phi": follows the meaning where a value is asked for
};

/// One field of T. `Field(key, &T::member, meaning, allowed)`, then refinements.
template <class T> struct Field : FieldInfo {
  /// The last is a number that may be left out.
  using Member = std::variant<double T::*, int T::*, bool T::*, std::string T::*, std::vector<double> T::*,
                              std::optional<double> T::*>;
  Member member;

  Field(std::string key_, Member member_, std::string meaning_, Interval allowed_ = any_number)
      : FieldInfo{std::move(key_), std::move(meaning_), allowed_}, member(member_) {
    required = !std::holds_alternative<std::optional<double> T::*>(member);
    kind = required ? member.index() + 1 : 1;
  }

  Field optional() && { return required = false, std::move(*this); }
  Field growing() && { return ascending = true, std::move(*this); }
  Field ruled(std::string rule_) && { return rule = std::move(rule_), std::move(*this); }
  /// Given directly, or as `name` times the value of `of`; exactly one of the two.
  Field or_ratio(std::string name, std::string of) && {
    ratio_key = std::move(name);
    ratio_of = std::move(of);
    return std::move(*this);
  }
};

/// Reads and validates; values in the order of the fields, monostate where an optional one is absent.
/// `others`: keys of the section that somebody else reads. InvalidInput says what is wrong.
std::vector<FieldValue> read_values(const Table&, std::span<const FieldInfo* const> fields,
                                    std::span<const std::string> others = {});

/// InvalidInput for the first key that is none of `known`: with the converted line where only the unit is
/// wrong (E_MPa), else with the nearest known key.
void refuse_unknown_keys(const Table&, std::span<const std::string> known);

/// InvalidInput unless the field admits the value, which stands in no card; `section` as messages name it.
void check_value(const FieldInfo&, const FieldValue&, std::string_view section);

/// "key = value" lines as they stand in a card.
std::string card_line(std::string_view key, const FieldValue&);

/// A Markdown table of the section for the reference; `defaults` as card text, empty where there is none.
std::string reference_table(std::span<const FieldInfo>, std::span<const FieldValue> defaults = {});

template <class T> std::vector<FieldInfo> infos(std::span<const Field<T>> fields) {
  return {fields.begin(), fields.end()};
}

template <class T, class M> void assign(T& object, M T::*member, const FieldValue& value) {
  if (const auto* given = std::get_if<M>(&value)) object.*member = *given;
}
template <class T> void assign(T& object, std::optional<double> T::*member, const FieldValue& value) {
  if (const auto* given = std::get_if<double>(&value)) object.*member = *given;
}

template <class T> [[gnu::noinline]] void assign(T& object, const Field<T>& field, const FieldValue& value) {
  std::visit([&](auto member) { assign(object, member, value); }, field.member);
}

/// The section as a T; absent optional fields keep the value they have in `defaults`.
template <class T>
T read_fields(const Table& table, const std::vector<Field<T>>& fields, T defaults = {},
              std::span<const std::string> others = {}) {
  std::vector<const FieldInfo*> infos(fields.size());
  std::ranges::transform(fields, infos.begin(), [](const auto& field) { return &field; });
  const auto values = read_values(table, infos, others);
  for (std::size_t i = 0; i < fields.size(); ++i) assign(defaults, fields[i], values[i]);
  return defaults;
}

inline FieldValue value_of(const auto& value) { return value; }
inline FieldValue value_of(const std::optional<double>& value) {
  return value ? FieldValue(*value) : FieldValue();
}
// Not inlined: where GCC 12 sees the object, it warns of the members that are too large for it.
template <class T> [[gnu::noinline]] FieldValue value_of(const Field<T>& field, const T& object) {
  return std::visit([&](auto member) { return value_of(object.*member); }, field.member);
}

/// All fields of `object` as lines of a card, in SI units.
template <class T> std::string card_lines(const std::vector<Field<T>>& fields, const T& object) {
  std::string lines;
  for (const auto& field : fields) lines += card_line(field.key, value_of(field, object));
  return lines;
}

} // namespace platen::core
