#include "measure/quantity.hpp"

#include "measure/dialect.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace platen::measure {
namespace {

constexpr double gram_force = 9.80665e-3; // N, standard gravity
constexpr double pound_force = 4.4482216152605, inch = 0.0254;

struct Known {
  std::string_view name;
  Quantity measures;
  double in_SI;
  bool any_case = false;
};
constexpr auto F = Quantity::force, L = Quantity::displacement, T = Quantity::time;
constexpr std::array known = {
    Known{"N", F, 1},
    Known{"mN", F, 1e-3},
    Known{"cN", F, 1e-2},
    Known{"daN", F, 10},
    Known{"uN", F, 1e-6},
    Known{"µN", F, 1e-6},
    Known{"μN", F, 1e-6},
    Known{"nN", F, 1e-9},
    Known{"kN", F, 1e3, true},
    Known{"MN", F, 1e6},
    Known{"newton", F, 1, true},
    Known{"g", F, gram_force},
    Known{"gf", F, gram_force, true},
    Known{"p", F, gram_force},
    Known{"mgf", F, 1e-3 * gram_force, true},
    Known{"kg", F, 1e3 * gram_force, true},
    Known{"kgf", F, 1e3 * gram_force, true},
    Known{"kp", F, 1e3 * gram_force, true},
    Known{"lbf", F, pound_force, true},
    Known{"lb", F, pound_force, true},
    Known{"lbs", F, pound_force, true},
    Known{"ozf", F, pound_force / 16, true},
    Known{"dyn", F, 1e-5, true},
    Known{"m", L, 1},
    Known{"cm", L, 1e-2},
    Known{"mm", L, 1e-3, true},
    Known{"um", L, 1e-6},
    Known{"µm", L, 1e-6},
    Known{"μm", L, 1e-6},
    Known{"micron", L, 1e-6, true},
    Known{"microns", L, 1e-6, true},
    Known{"nm", L, 1e-9},
    Known{"in", L, inch, true},
    Known{"inch", L, inch, true},
    Known{"inches", L, inch, true},
    Known{"mil", L, 1e-3 * inch, true},
    Known{"s", T, 1, true},
    Known{"sec", T, 1, true},
    Known{"secs", T, 1, true},
    Known{"sek", T, 1, true},
    Known{"second", T, 1, true},
    Known{"seconds", T, 1, true},
    Known{"ms", T, 1e-3},
    Known{"min", T, 60, true},
    Known{"h", T, 3600},
    Known{"秒", T, 1},
};

/// UTF-8 letters with accents to those without, and capitals of them.
std::string without_accents(std::string_view text) {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array pairs = {Pair{"ä", "a"}, Pair{"ö", "o"},     Pair{"ü", "u"},  Pair{"Ä", "a"},
                                       Pair{"Ö", "o"}, Pair{"Ü", "u"},     Pair{"ß", "ss"}, Pair{"é", "e"},
                                       Pair{"è", "e"}, Pair{"ê", "e"},     Pair{"à", "a"},  Pair{"ç", "c"},
                                       Pair{"É", "e"}, Pair{"\u00A0", " "}};
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    bool replaced = false;
    for (const auto& [from, to] : pairs)
      if (text.substr(i).starts_with(from)) {
        result += to;
        i += from.size();
        replaced = true;
        break;
      }
    if (!replaced) result += text[i++];
  }
  return result;
}

bool has_any(const std::string& text, std::span<const std::string_view> parts) {
  return std::ranges::any_of(parts, [&](auto part) { return text.find(part) != text.npos; });
}

/// A word of its own.
bool has_word(const std::string& text, std::span<const std::string_view> whole) {
  for (std::size_t start = 0; start < text.size();) {
    const auto stop = std::min(text.find(' ', start), text.size());
    if (std::ranges::find(whole, std::string_view(text).substr(start, stop - start)) != whole.end())
      return true;
    start = stop + 1;
  }
  return false;
}

constexpr std::string_view other_parts[] = {"speed",    "geschwindig", "rate ",   "stress",
                                            "spannung", "strain",      "dehnung", "temperat",
                                            "energy",   "arbeit",      "work",    "modul"};
constexpr std::string_view time_parts[] = {"time", "zeit", "temps", "elapsed", "時間"};
constexpr std::string_view length_parts[] = {
    "distance", "extension", "displace", "travel",   "stroke",     "crosshead", "position", "depth",
    "deform",   "verform",   "stauch",   "eindring", "indent",     "weg",       "travers",  "verschieb",
    "deplace",  "course",    "変位",     "深さ",     "ストローク", "圧縮量"};
constexpr std::string_view length_words[] = {"s",       "x",           "z",     "hub",     "gap", "spalt",
                                             "abstand", "compression", "delta", "overlap", "lvdt"};
constexpr std::string_view force_parts[] = {"force", "load", "kraft", "荷重", "試験力", "力"};
constexpr std::string_view force_words[] = {"f", "p", "last", "effort", "charge"};
constexpr std::string_view particle_parts[] = {"particle", "partikel", "teilchen", "granule",
                                               "specimen", "granulat", "sample",   "pellet",
                                               "bead",     "probe",    "粒子",     "試料"};
constexpr std::string_view particle_words[] = {"test", "korn", "grain", "kugel", "id", "no", "nr"};
constexpr std::string_view diameter_parts[] = {"diameter", "durchmesser", "diametre", "height",
                                               "hohe",     "粒子径",      "直径"};
constexpr std::string_view diameter_words[] = {"d", "dia", "hohe", "size"};
/// "platen diameter" is not the particle's.
constexpr std::string_view tool_parts[] = {"platen",     "indent", "punch",   "stempel", "plate",
                                           "platte",     "anvil",  "tool",    "stylus",  "pruefk",
                                           "prufkorper", "sensor", "cylinder"};

} // namespace

std::optional<Unit> unit_named(std::string_view text) {
  text = trimmed(text);
  for (const auto& unit : known)
    if (unit.name == text) return Unit{std::string(text), unit.measures, unit.in_SI};
  const std::string small = folded(text);
  for (const auto& unit : known)
    if (unit.any_case && folded(unit.name) == small)
      return Unit{std::string(text), unit.measures, unit.in_SI};
  return {};
}

Heading heading_of(std::string_view text) {
  text = trimmed(text);
  Heading heading{std::string(text), std::string(text), {}};
  const auto take = [&](std::string_view name, std::string_view unit) {
    heading.name = trimmed(name);
    heading.unit = trimmed(unit);
  };
  if (text.ends_with(':')) text = trimmed(text.substr(0, text.size() - 1));
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}, std::pair{'<', '>'}})
    if (const auto from = text.rfind(open); from != text.npos && text.ends_with(close)) {
      take(text.substr(0, from), text.substr(from + 1, text.size() - from - 2));
      return heading;
    }
  for (const std::string_view between : {" in ", " / ", "/", ", ", "_", " "})
    if (const auto at = text.rfind(between); at != text.npos && at > 0) {
      const auto unit = unit_named(text.substr(at + between.size()));
      // "load in" ends with a word, not with inches; "Nr g" is rather a name.
      const bool word = between == " " && (unit && (unit->name == "in" || unit->name.size() == 1));
      if (unit && (!word || unit->name == "N")) {
        take(text.substr(0, at), text.substr(at + between.size()));
        return heading;
      }
    }
  heading.name = text;
  return heading;
}

std::string folded(std::string_view text) {
  std::string result = without_accents(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    else if (c > 0 && !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9')) c = ' ';
  }
  return std::string(trimmed(result));
}

Quantity quantity_named(std::string_view name) {
  const std::string text = folded(name);
  if (text == "branch" || text == "branch id") return Quantity::branch;
  if (has_any(text, other_parts)) return Quantity::other;
  const bool tool = has_any(text, tool_parts);
  if (has_any(text, diameter_parts) || has_word(text, diameter_words))
    return tool ? Quantity::other : Quantity::diameter;
  if (!tool && (text.find("radius") != text.npos || text == "r")) return Quantity::radius;
  constexpr std::string_view time_word[] = {"t"};
  if (has_any(text, time_parts) || has_word(text, time_word)) return Quantity::time;
  if (has_any(text, length_parts) || has_word(text, length_words)) return Quantity::displacement;
  if (has_any(text, force_parts) || has_word(text, force_words)) return Quantity::force;
  if (has_any(text, particle_parts) || has_word(text, particle_words)) return Quantity::particle;
  return Quantity::other;
}

bool is_contact_overlap(std::string_view name) {
  const std::string text = folded(name);
  return text == "delta" || text == "delta m" || text == "overlap" || text == "overlap m";
}

std::string_view words(Quantity quantity) {
  switch (quantity) {
  case Quantity::time:
    return "time";
  case Quantity::force:
    return "force";
  case Quantity::displacement:
    return "length";
  case Quantity::particle:
    return "particle";
  case Quantity::diameter:
    return "diameter";
  case Quantity::radius:
    return "radius";
  default:
    return "something else";
  }
}

} // namespace platen::measure
