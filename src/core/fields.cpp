#include "core/fields.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace platen::core {
namespace {

[[noreturn]] void refuse(const Table& table, const std::string& key, const Value& value,
                         std::string_view why) {
  throw InvalidInput(fmt::format("{} = {} {}", place(table, key), text_of(value), why));
}

std::string wanted(const FieldInfo& field) {
  constexpr std::string_view kinds[] = {"",     "a number",         "a whole number", "true or false",
                                        "text", "a list of numbers"};
  const bool numeric = field.kind == 1 || field.kind == 2 || field.kind == 5;
  return fmt::format("{}{}{}", kinds[field.kind], numeric ? " " + field.allowed.text() : "",
                     field.ascending ? ", each greater than the one before" : "");
}

double number_in(const Table& table, const std::string& key, const Value& whole, const Value& item,
                 const FieldInfo& field) {
  double x = 0;
  if (const auto* d = std::get_if<double>(&item.data)) x = *d;
  else if (const auto* i = std::get_if<std::int64_t>(&item.data)) x = static_cast<double>(*i);
  else {
    const auto* text = std::get_if<std::string>(&item.data);
    const std::vector<std::string> own{key};
    for (auto end = key.find('_'); text && quantity_from(*text) && end != key.npos;
         end = key.find('_', end + 1))
      if (const auto bare = key.substr(0, end); !si_key(bare, own).empty())
        refuse(table, key, whole,
               fmt::format("has a unit, and the key has one too; write {} = {}", bare, in_quotes(*text)));
    refuse(table, key, whole, fmt::format("is {}; it must be {}", kind_of(item), wanted(field)));
  }
  if (!std::isfinite(x) || !field.allowed.contains(x))
    refuse(table, key, whole, fmt::format("is not allowed; it must be {}", wanted(field)));
  return x;
}

FieldValue read_value(const Table& table, const std::string& key, const Value& value,
                      const FieldInfo& field) {
  const auto wrong_kind = [&] {
    refuse(table, key, value, fmt::format("is {}; it must be {}", kind_of(value), wanted(field)));
  };
  switch (field.kind) {
  case 1:
    return number_in(table, key, value, value, field);
  case 2: {
    if (!std::holds_alternative<std::int64_t>(value.data)) wrong_kind();
    const double x = number_in(table, key, value, value, field);
    if (std::abs(x) > std::numeric_limits<int>::max()) refuse(table, key, value, "is too large");
    return static_cast<int>(x);
  }
  case 3:
    if (!std::holds_alternative<bool>(value.data)) wrong_kind();
    return std::get<bool>(value.data);
  case 4:
    if (!std::holds_alternative<std::string>(value.data)) wrong_kind();
    return std::get<std::string>(value.data);
  default: {
    const auto* items = std::get_if<std::vector<Value>>(&value.data);
    if (!items) wrong_kind();
    std::vector<double> numbers;
    for (const auto& item : *items) numbers.push_back(number_in(table, key, value, item, field));
    if (field.ascending &&
        std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) != numbers.end())
      refuse(table, key, value, fmt::format("is not allowed; it must be {}", wanted(field)));
    return numbers;
  }
  }
}

/// A key given as a multiple of another: the product, checked as the key itself would be.
FieldValue from_ratio(const Table& table, const FieldInfo& field, double ratio, double of) {
  const double product = ratio * of;
  if (!std::isfinite(product) || !field.allowed.contains(product))
    throw InvalidInput(fmt::format("{} = {} makes {} = {}, which must be {}", place(table, field.ratio_key),
                                   number_text(ratio), field.key, number_text(product), wanted(field)));
  return product;
}

} // namespace

bool Interval::contains(double x) const {
  return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
}

std::string Interval::text() const {
  const bool bounded_below = std::isfinite(low), bounded_above = std::isfinite(high);
  if (bounded_below && bounded_above && low == high) return fmt::format("equal to {}", number_text(low));
  if (bounded_below && bounded_above)
    return fmt::format("in {}{}, {}{}", low_included ? '[' : '(', number_text(low), number_text(high),
                       high_included ? ']' : ')');
  if (bounded_below) return fmt::format("{} {}", low_included ? ">=" : ">", number_text(low));
  if (bounded_above) return fmt::format("{} {}", high_included ? "<=" : "<", number_text(high));
  return "of any size";
}

void refuse_unknown_keys(const Table& table, std::span<const std::string> known) {
  for (const auto& [key, value] : table.entries) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto line = line_in_si(key, value, known);
    const std::string start = fmt::format("{} = {}", place(table, key), text_of(value));
    if (!line.empty()) throw InvalidInput(fmt::format("{} is not in SI units; write {}", start, line));
    throw InvalidInput(fmt::format("{}: there is no such key{}", start, suggestion(key, known)));
  }
}

std::vector<FieldValue> read_values(const Table& written, std::span<const FieldInfo* const> fields,
                                    std::span<const std::string> others) {
  std::vector<std::string> known(others.begin(), others.end());
  known.reserve(others.size() + 2 * fields.size());
  for (const FieldInfo* field : fields) {
    known.push_back(field->key);
    if (!field->ratio_key.empty()) known.push_back(field->ratio_key);
  }
  const auto converted = in_si(written, known);
  const Table& table = converted ? *converted : written;
  refuse_unknown_keys(table, known);

  std::vector<FieldValue> values(fields.size());
  std::vector<std::optional<double>> ratios(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& field = *fields[i];
    const Value* direct = table.find(field.key);
    const Value* ratio = field.ratio_key.empty() ? nullptr : table.find(field.ratio_key);
    if (direct && ratio)
      throw InvalidInput(fmt::format("{}: given as well as {}; exactly one of the two is allowed",
                                     place(table, field.ratio_key), field.key));
    if (direct) values[i] = read_value(table, field.key, *direct, field);
    else if (ratio) ratios[i] = number_in(table, field.ratio_key, *ratio, *ratio, field);
    else if (field.required)
      throw InvalidInput(fmt::format("{}{} is missing: {}, {}", place(table, field.key),
                                     field.ratio_key.empty() ? "" : " (or " + field.ratio_key + ")",
                                     field.meaning + field.rule, wanted(field)));
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!ratios[i]) continue;
    const auto of = std::find_if(fields.begin(), fields.end(),
                                 [&](const FieldInfo* other) { return other->key == fields[i]->ratio_of; });
    values[i] = from_ratio(table, *fields[i], *ratios[i], std::get<double>(values.at(of - fields.begin())));
  }
  return values;
}

void check_value(const FieldInfo& field, const FieldValue& value, std::string_view section) {
  std::vector<double> numbers;
  if (const auto* x = std::get_if<double>(&value)) numbers = {*x};
  if (const auto* i = std::get_if<int>(&value)) numbers = {static_cast<double>(*i)};
  if (const auto* list = std::get_if<std::vector<double>>(&value)) numbers = *list;
  const bool admitted = std::all_of(numbers.begin(), numbers.end(),
                                    [&](double x) { return std::isfinite(x) && field.allowed.contains(x); });
  const bool grows =
      std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end();
  if (admitted && (grows || !field.ascending)) return;
  std::string line = card_line(field.key, value);
  line.pop_back();
  throw InvalidInput(fmt::format("{}{} is not allowed; it must be {}",
                                 section.empty() ? "" : fmt::format("[{}] ", section), line, wanted(field)));
}

std::string card_line(std::string_view key, const FieldValue& value) {
  struct Text {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(double x) const { return number_text(x); }
    std::string operator()(int i) const { return std::to_string(i); }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(const std::string& s) const { return in_quotes(s); }
    std::string operator()(const std::vector<double>& numbers) const {
      std::string list;
      for (const double x : numbers) list += (list.empty() ? "" : ", ") + number_text(x);
      return "[" + list + "]";
    }
  };
  const std::string text = std::visit(Text{}, value);
  return text.empty() ? "" : std::string(key).append(" = ").append(text).append("\n");
}

std::string reference_table(std::span<const FieldInfo> fields, std::span<const FieldValue> defaults) {
  std::string page = "| key | meaning | value |\n|---|---|---|\n";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& field = fields[i];
    std::string key = fmt::format("`{}`", field.key);
    if (!field.ratio_key.empty())
      key += fmt::format(", or `{}` = {}/{}", field.ratio_key, field.key, field.ratio_of);
    std::string value = wanted(field);
    if (!field.required) {
      std::string line = i < defaults.size() ? card_line("", defaults[i]) : "";
      value +=
          line.empty() ? "; may be left out" : fmt::format("; default{}", line.substr(2, line.size() - 3));
    }
    page += fmt::format("| {} | {}{} | {} |\n", key, field.meaning, field.rule, value);
  }
  return page;
}

} // namespace platen::core
