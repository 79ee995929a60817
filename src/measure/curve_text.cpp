#include "measure/curve_text.hpp"

#include "core/number.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace platen::measure {
namespace {

/// A name as a cell: without the signs that would part it.
std::string cell(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == ',' || c == '"' || c == ';' || c == '\t'; }, ' ');
  return name;
}

} // namespace

std::string curve_text(const Measurement& m, const std::vector<Stages>& stages, const Machine& machine) {
  std::string text = fmt::format("# source = {}\n# sha256 = {}\n# read as {}\n", m.file, m.sha256, m.read_as);
  for (const auto& sentence : m.said) text += fmt::format("# {}\n", sentence);
  text += machine.given() ? fmt::format("# machine taken off the travel, {}\n", machine.said)
                          : "# no compliance of the machine taken off\n";
  text += fmt::format("# version = {}\n", core::version);
  const auto all = [&](auto has) { return std::ranges::all_of(m.specimens, has); };
  const bool timed = all([](const Specimen& s) { return !s.time_s.empty(); });
  const bool sized = all([](const Specimen& s) { return s.diameter_m.has_value(); });
  const bool overlap = m.specimens.front().contact_overlap;
  text += fmt::format("particle,{}{}{},force_N,branch\n", sized ? "diameter_m," : "", timed ? "time_s," : "",
                      overlap ? "delta_m" : "travel_m");
  const auto number = [](double v) { return fmt::format("{:.9g}", v); };
  for (std::size_t k = 0; k < m.specimens.size(); ++k) {
    const auto& s = m.specimens[k];
    const std::string head = cell(s.name) + "," + (sized ? number(*s.diameter_m) + "," : "");
    for (std::size_t i = 0; i < s.force_N.size(); ++i)
      fmt::format_to(std::back_inserter(text), "{}{}{},{},{}\n", head, timed ? number(s.time_s[i]) + "," : "",
                     number(s.travel_m[i] - machine.travel(s.force_N[i])), number(s.force_N[i]),
                     name_of(stages[k].of_row[i]));
  }
  return text;
}

} // namespace platen::measure
