#include "material/deck.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace platen::material {
namespace {

using core::InvalidInput;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Upper case, single blanks.
std::string keyword_text(std::string_view text) {
  std::string result;
  for (char c : trimmed(text)) {
    if (c == ' ' && result.ends_with(' ')) continue;
    result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return result;
}

/// Commas part cells, but not inside quotes.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  bool quoted = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != ',' || quoted)) continue;
    cells.push_back(trimmed(line.substr(start, i - start)));
    start = i + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back(); // a comma at the end
  return cells;
}

Keyword keyword_of(std::string_view line, int number) {
  Keyword keyword;
  keyword.line = number;
  for (const auto cell : cells_of(line.substr(1))) {
    const auto equals = cell.find('=');
    if (keyword.name.empty()) keyword.name = keyword_text(cell);
    else if (equals == cell.npos) keyword.parameters.emplace_back(keyword_text(cell), "");
    else {
      auto value = trimmed(cell.substr(equals + 1));
      if (value.size() > 1 && value.front() == '"' && value.back() == '"')
        value = value.substr(1, value.size() - 2);
      keyword.parameters.emplace_back(keyword_text(cell.substr(0, equals)), value);
    }
  }
  return keyword;
}

/// Keywords that end a material: those of the model and its steps.
bool is_of_material(std::string_view name) {
  static constexpr std::array others = {"STEP",
                                        "PART",
                                        "END PART",
                                        "INSTANCE",
                                        "ASSEMBLY",
                                        "NODE",
                                        "ELEMENT",
                                        "NSET",
                                        "ELSET",
                                        "SURFACE",
                                        "BOUNDARY",
                                        "AMPLITUDE",
                                        "INITIAL CONDITIONS",
                                        "SOLID SECTION",
                                        "SURFACE INTERACTION",
                                        "CONTACT PAIR",
                                        "CONTACT",
                                        "RIGID BODY",
                                        "HEADING",
                                        "PREPRINT",
                                        "RESTART",
                                        "INCLUDE",
                                        "PHYSICAL CONSTANTS",
                                        "ORIENTATION",
                                        "TRANSFORM",
                                        "SHELL SECTION",
                                        "BEAM SECTION",
                                        "MPC",
                                        "EQUATION",
                                        "TIE"};
  return std::ranges::find(others, name) == others.end();
}

void add_row(Keyword& keyword, std::string_view line, const std::string& file, int number) {
  std::vector<std::optional<double>> row;
  for (const auto cell : cells_of(line)) {
    std::string text(cell);
    std::ranges::replace_if(
        text, [](char c) { return c == 'd' || c == 'D'; }, 'e'); // Fortran
    if (text.starts_with('+')) text.erase(0, 1);
    if (text.ends_with('.')) text += '0';
    if (const auto dot = text.find(".e"); dot != text.npos) text.insert(dot + 1, "0");
    if (const auto dot = text.find(".E"); dot != text.npos) text.insert(dot + 1, "0");
    if (text.starts_with('.')) text.insert(0, "0");
    if (text.starts_with("-.")) text.insert(1, "0");
    const auto value = core::number_from(text);
    if (!value && !cell.empty())
      throw InvalidInput(fmt::format("{}, line {}, *{}: {} is not a number", file, number, keyword.name,
                                     core::in_quotes(cell.substr(0, 40))));
    row.push_back(value);
  }
  keyword.rows.push_back(std::move(row));
}

} // namespace

std::string Keyword::parameter(std::string_view wanted) const {
  for (const auto& [key, value] : parameters)
    if (key == wanted) return value;
  return {};
}

const Keyword* DeckMaterial::find(std::string_view wanted) const {
  for (const auto& keyword : keywords)
    if (keyword.name == wanted) return &keyword;
  return nullptr;
}

std::vector<DeckMaterial> read_deck(std::string_view text, const std::string& file) {
  std::vector<DeckMaterial> materials;
  bool inside = false, goes_on = false;
  std::string pending;
  int number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const auto line = trimmed(text.substr(start, end - start));
    start = end + 1;
    ++number;
    if (line.empty() || line.starts_with("**")) continue;
    if (line.front() == '*' || goes_on) {
      pending += line;
      goes_on = line.back() == ','; // a keyword line that ends with a comma goes on
      if (goes_on) continue;
      Keyword keyword = keyword_of(pending, number);
      pending.clear();
      if (keyword.name == "MATERIAL") {
        materials.push_back({file, keyword.parameter("NAME"), {}});
        inside = true;
      } else if (inside && is_of_material(keyword.name))
        materials.back().keywords.push_back(std::move(keyword));
      else inside = false;
      continue;
    }
    if (inside && !materials.back().keywords.empty()) {
      auto& keyword = materials.back().keywords.back();
      if (keyword.name != "USER OUTPUT VARIABLES") add_row(keyword, line, file, number);
    }
  }
  if (materials.empty())
    throw InvalidInput(fmt::format("{}: there is no *MATERIAL in it; is this an Abaqus input file?", file));
  return materials;
}

const DeckMaterial& choose(const std::vector<DeckMaterial>& all, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& m : all) {
    if (m.name == name || (name.empty() && all.size() == 1)) return m;
    names.push_back(core::in_quotes(m.name));
  }
  if (name.empty())
    throw InvalidInput(fmt::format("{}: {} materials: {}; choose one by its name: material NAME",
                                   all.front().file, all.size(), fmt::join(names, ", ")));
  throw InvalidInput(fmt::format("material {}: {} has {}", name, all.front().file, fmt::join(names, ", ")));
}

const std::vector<DeckUnits>& deck_units() {
  static const std::vector<DeckUnits> all = {
      {"si", "m, kg, s, N, Pa", 1, 1},
      {"mm-tonne-MPa", "mm, tonne, s, N, MPa", 1e6, 1e12},
      {"mm-kg-GPa", "mm, kg, ms, kN, GPa", 1e9, 1e9},
      {"m-tonne-kPa", "m, tonne, s, kN, kPa", 1e3, 1e3},
      {"in-lbf-psi", "inch, lbf s2/in, s, lbf, psi", 6894.757293168, 1.0686895e7},
  };
  return all;
}

const DeckUnits& deck_units(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& units : deck_units()) {
    if (units.name == name) return units;
    known.push_back(fmt::format("{} ({})", units.name, units.words));
  }
  throw InvalidInput(fmt::format("--units {}: there are {}", name, fmt::join(known, "; ")));
}

std::string which_units(const DeckMaterial& m) {
  const auto first = [&](std::string_view name) -> std::optional<double> {
    const auto* keyword = m.find(name);
    if (!keyword || keyword->rows.empty() || keyword->rows.front().empty()) return {};
    return keyword->rows.front().front();
  };
  std::vector<std::string> readings;
  for (const auto& units : deck_units()) {
    std::string reading(units.name);
    if (const auto E = first("ELASTIC")) reading += fmt::format(": E = {:.4g} Pa", *E * units.stress);
    if (const auto rho = first("DENSITY"))
      reading += fmt::format(", density {:.4g} kg/m3", *rho * units.density);
    readings.push_back(std::move(reading));
  }
  return fmt::format("{}: an input file does not say its units; give them with --units: {}", m.file,
                     fmt::join(readings, "; "));
}

} // namespace platen::material
