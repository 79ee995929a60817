#include "calibrate/free_material.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

using core::InvalidInput, core::Table, core::Value;

constexpr const char* kappa = "hardening.kappa_Pa";

Table& parameters(Table& card) {
  for (auto& entry : card.entries)
    if (entry.key == "parameters") return std::get<Table>(entry.value.data);
  throw std::logic_error("a card without parameters");
}

const Value* found(const Table& section, const std::string& key) {
  const auto dot = key.find('.');
  if (dot == key.npos) return section.find(key);
  const Value* inner = section.find(key.substr(0, dot));
  return inner ? std::get<Table>(inner->data).find(key.substr(dot + 1)) : nullptr;
}

void put(Table& section, const std::string& key, double value) {
  if (const auto dot = key.find('.'); dot != key.npos) {
    for (auto& entry : section.entries)
      if (entry.key == key.substr(0, dot))
        return put(std::get<Table>(entry.value.data), key.substr(dot + 1), value);
    throw InvalidInput(fmt::format("{}: hardening is given in a card: --material CARD", key));
  }
  for (auto& entry : section.entries)
    if (entry.key == key) {
      entry.value.data = value;
      return;
    }
  section.entries.push_back({key, {value, 0}});
}

/// A card may write 8610000 for a stress.
void make_numbers(Table& table) {
  for (auto& entry : table.entries) {
    if (const auto* whole = std::get_if<std::int64_t>(&entry.value.data))
      entry.value.data = static_cast<double>(*whole);
    if (auto* inner = std::get_if<Table>(&entry.value.data)) make_numbers(*inner);
  }
}

bool is_stress(const std::string& key) { return key.ends_with("_Pa"); }

} // namespace

bool is_material_model(const std::string& name) {
  bool is = false;
  material::for_each_model([&]<class M>() { is = is || name == M::name; });
  return is;
}

void FreeMaterial::read_model(const std::string& model) {
  material::for_each_model([&]<class M>() {
    if (model == M::name) fields_ = M::card().fields;
  });
  if (model == "drucker-prager" || model == "mohr-coulomb")
    throw InvalidInput(fmt::format("--material {}: small contacts of rock show its strength alone; calibrate "
                                   "the law of such grains, --law wang",
                                   model));
}

FreeMaterial::FreeMaterial(const std::string& what, const law::ParameterTexts& given,
                           std::vector<std::string> wanted) {
  const bool by_name = is_material_model(what);
  if (by_name)
    card_ = core::parse_toml(fmt::format("platen = 1\nname = \"calibrated {0}\"\nmodel = \"{0}\"\n"
                                         "[parameters]\n",
                                         what),
                             "--material " + what);
  else {
    const auto card = material::read_card(what);
    card_ = core::parse_toml(card_text(card.material), what);
  }
  read_model(std::get<std::string>(card_.find("model")->data));
  Table& section = parameters(card_);
  make_numbers(section);
  for (const auto& field : fields_) { // other strengths go with the reference stress
    const Value* value = section.find(field.key);
    if (field.ratio_key.empty() || field.key == "E_Pa" || !value) continue;
    const double ratio = std::get<double>(value->data) / std::get<double>(section.find(field.ratio_of)->data);
    std::erase_if(section.entries, [&](const auto& entry) { return entry.key == field.key; });
    section.entries.push_back({field.ratio_key, {ratio, 0}});
  }
  for (const auto& [key, text] : given) {
    const auto number = core::number_from(text);
    if (!number) throw InvalidInput(fmt::format("{} = {} is not a number", key, text));
    set(key, *number);
  }
  strength_ = found(section, kappa) ? kappa : fields_.front().key == "E_Pa" ? "" : "sigma_y_Pa";
  if (wanted.empty()) {
    if (!strength_.empty()) wanted.push_back(strength_);
    if (strength_ == kappa) wanted.push_back("hardening.inverse_m");
    wanted.push_back("E_Pa");
    std::erase_if(wanted, [&](const auto& key) { return given.contains(key); });
  }
  if (wanted.empty()) throw InvalidInput("nothing is left to be looked for: all parameters are given");
  for (const auto& key : wanted) {
    if (given.contains(key))
      throw InvalidInput(fmt::format("{} is given and is to be looked for; one of the two", key));
    const Value* known = found(section, key);
    const double* number = known ? std::get_if<double>(&known->data) : nullptr;
    const auto one = sought(key, number);
    if (number) of_card_.push_back(*number);
    else set(key, one.starts[one.starts.size() / 2] * (one.in_curve_stress ? 1e7 : 1));
    free_.push_back(one);
  }
  if (of_card_.size() != free_.size()) of_card_.clear();
  try {
    (void)typical();
  } catch (const InvalidInput& error) {
    if (!by_name) throw;
    throw InvalidInput(
        fmt::format("{}; a force curve does not show it: give it with -p KEY=VALUE, or begin from a card of "
                    "a similar material, --material CARD",
                    error.what()));
  }
}

void FreeMaterial::set(const std::string& key, double value) {
  Table& section = parameters(card_);
  for (const auto& field : fields_) { // one of the pair
    if (key == field.key)
      std::erase_if(section.entries, [&](const auto& e) { return e.key == field.ratio_key; });
    if (key == field.ratio_key)
      std::erase_if(section.entries, [&](const auto& e) { return e.key == field.key; });
  }
  put(section, key, value);
}

/// Where a search of it begins, and how far it may go.
FreeParameter FreeMaterial::sought(const std::string& key, bool known) const {
  const Value* value = found(std::get<Table>(card_.find("parameters")->data), key);
  if (key == "E_Pa" && strength_.empty()) return {key, true, true, 1e-3, 1e6, {0.5, 2, 8, 32, 128}, false};
  if (key == "E_Pa") return {key, true, true, 0.5, 1e6, {3, 12, 50, 200, 800, 3200}, false};
  if (key == "sigma_y_Pa" || key == kappa)
    return {key, true, true, 1e-4, 100, {0.03, 0.06, 0.12, 0.2, 0.4, 0.8, 1.6}, false};
  std::vector<std::string> keys = {kappa, "hardening.inverse_m"};
  core::Interval allowed = core::positive;
  bool is_there = value != nullptr && std::holds_alternative<double>(value->data);
  for (const auto& field : fields_) {
    keys.push_back(field.key);
    if (!field.ratio_key.empty()) keys.push_back(field.ratio_key);
    if (field.key == key) allowed = field.allowed;
    is_there = is_there || field.key == key || field.ratio_key == key;
  }
  if (!is_there)
    throw InvalidInput(
        fmt::format("--free {}: there is no such parameter{}", key, core::suggestion(key, keys)));
  if (is_stress(key))
    throw InvalidInput(
        fmt::format("--free {}: look for it as a ratio, {}_bar", key, key.substr(0, key.size() - 3)));
  if (!known)
    throw InvalidInput(fmt::format("--free {}: where to begin? Give a card of a similar material, --material "
                                   "CARD",
                                   key));
  const double start = std::get<double>(value->data);
  if (start > 0 && !std::isfinite(allowed.high)) { // by factors
    constexpr double factor = 10;
    return {key, true, false, start / factor, start * factor, {start / 2, start, start * 2}, false};
  }
  const double low = std::isfinite(allowed.low) ? allowed.low : start - std::max(1.0, std::abs(start));
  const double high = std::isfinite(allowed.high) ? allowed.high : start + std::max(1.0, std::abs(start));
  return {key, false, false, low, high, {(low + start) / 2, start, (start + high) / 2}, false};
}

material::Material FreeMaterial::with(const law::ParameterTexts& values) const {
  Table card = card_;
  Table& section = parameters(card);
  for (const auto& free : free_)
    if (const auto at = values.find(free.key); at != values.end())
      put(section, free.key, *core::number_from(at->second));
  return material::read_card(card).material;
}

std::string FreeMaterial::held() const {
  std::vector<std::string> words;
  const auto sought_for = [&](const std::string& key) {
    return std::ranges::any_of(free_, [&](const auto& f) { return f.key == key; });
  };
  for (const auto& [key, value] : std::get<Table>(card_.find("parameters")->data).entries) {
    if (const auto* inner = std::get_if<Table>(&value.data)) {
      for (const auto& entry : inner->entries)
        if (const auto* x = std::get_if<double>(&entry.value.data); x && !sought_for(key + "." + entry.key))
          words.push_back(fmt::format("{}.{} = {:.6g}", key, entry.key, *x));
    } else if (const auto* x = std::get_if<double>(&value.data); x && !sought_for(key))
      words.push_back(fmt::format("{} = {:.6g}", key, *x));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

} // namespace platen::calibrate
