#include "surrogate/refine_study.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "study/table.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace platen::surrogate {
namespace {

namespace fs = std::filesystem;

/// The card with a table in the place of its design, and its name.
std::string refined_card(const std::string& card, const study::Study& s, const std::string& name,
                         const std::string& table) {
  std::istringstream lines(card);
  std::string text, line;
  bool skipped = false;
  const std::regex section(R"(^\s*\[\s*([^\].]+)[^\]]*\])"), name_line(R"(^\s*name\s*=.*)"),
      inline_design(R"(^\s*(design|factors|bounds)\s*=.*)");
  bool in_section = false;
  while (std::getline(lines, line)) {
    std::smatch found;
    if (std::regex_search(line, found, section)) {
      in_section = true;
      const std::string which = found[1];
      skipped = which == "design" || which == "factors" || which == "bounds";
    }
    if (skipped || (!in_section && std::regex_match(line, inline_design))) continue;
    if (!in_section && std::regex_match(line, name_line)) line = fmt::format("name = \"{}\"", name);
    text += line + "\n";
  }
  text += fmt::format("[design]\nkind = \"table\"\nfile = \"{}\"\n[factors]\n", table);
  for (const auto& factor : s.factors) text += fmt::format("\"{0}\" = {{ column = \"{0}\" }}\n", factor.name);
  return text;
}

study::Sheet table_of(const study::Study& s, const Surrogate& surrogate, const Refined& refined) {
  study::Sheet sheet{"design", {{"study", s.name}, {"surrogate", surrogate.pool}}, {"run"}, {}};
  for (const auto& factor : s.factors) sheet.columns.push_back(factor.name);
  for (const std::size_t i : refined.chosen) {
    std::vector<study::Cell> row = {static_cast<std::int64_t>(sheet.rows.size() + 1)};
    for (const auto& input : s.runs[i].inputs)
      std::visit([&](const auto& level) { row.emplace_back(level); }, input);
    sheet.rows.push_back(std::move(row));
  }
  return sheet;
}

std::vector<Description> candidates_of(const study::Study& s, const Surrogate& surrogate) {
  std::vector<Description> candidates;
  for (std::size_t i = 0; i < s.runs.size(); ++i) {
    candidates.push_back(describe(s.runs[i].press_case.material.model));
    if (candidates.back().model != surrogate.model)
      throw core::InvalidInput(fmt::format("{}: run {} is of {}, the surrogate of {}", s.file, i + 1,
                                           candidates.back().model, surrogate.model));
  }
  return candidates;
}

} // namespace

Surrogate find_surrogate(const fs::path& pool_or_file) {
  return read_surrogate(fs::is_directory(pool_or_file) ? pool_or_file / "surrogate.txt" : pool_or_file);
}

RefinedStudy refine_study(const study::Study& s, const Surrogate& surrogate, double target, std::size_t most,
                          const fs::path& output) {
  const fs::path card =
      output.empty() ? fs::path(s.file).replace_filename(fs::path(s.file).stem().string() + "-refined.toml")
                     : output;
  const auto table = fs::path(card).replace_extension(".csv");
  if (fs::exists(card) && fs::equivalent(card, s.file))
    throw core::InvalidInput(fmt::format("-o {}: that is the study itself", card.string()));
  RefinedStudy result{
      s.name, s.runs.size(), refine(surrogate, candidates_of(s, surrogate), target, most), {}, {}};
  if (result.refined.chosen.empty()) return result;
  core::write_file(table, study::csv_text(table_of(s, surrogate, result.refined)));
  core::write_file(card,
                   refined_card(core::read_file(s.file), s, s.name + "-refined", table.filename().string()));
  study::read_study(card.string()); // what was written can be run
  result.card = card, result.table = table;
  return result;
}

std::string words_of(const RefinedStudy& r, double target) {
  std::string text = fmt::format(
      "{}: of {} candidates the least certain is expected to be {:.2g} % off; {} presses, then {:.2g} %\n",
      r.study, r.candidates, 100 * r.refined.largest.front(), r.refined.chosen.size(),
      100 * r.refined.largest.back());
  if (r.refined.largest.back() > target)
    text += fmt::format("  more than the {:.2g} % of --target; more with --most\n", 100 * target);
  if (r.card.empty()) return text + "  nothing to press\n";
  return text + fmt::format("  study           {0}, its materials {1}: `platen study run {0}`\n",
                            r.card.string(), r.table.string());
}

} // namespace platen::surrogate
