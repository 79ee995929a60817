#include "app/study_refine.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "study/card.hpp"
#include "study/table.hpp"
#include "surrogate/refine.hpp"

#include <fmt/format.h>

#include <memory>
#include <regex>
#include <sstream>
#include <string>

namespace platen::app {
namespace {

struct Options {
  std::string card, file, output;
  double target = 0.01;
  int most = 50;
};

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

void refine(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto surrogate = surrogate::read_surrogate(std::filesystem::is_directory(o.file)
                                                       ? std::filesystem::path(o.file) / "surrogate.txt"
                                                       : std::filesystem::path(o.file));
  std::vector<surrogate::Description> candidates;
  for (std::size_t i = 0; i < s.runs.size(); ++i) {
    candidates.push_back(surrogate::describe(s.runs[i].press_case.material.model));
    if (candidates.back().model != surrogate.model)
      throw core::InvalidInput(fmt::format("{}: run {} is of {}, the surrogate of {}", o.card, i + 1,
                                           candidates.back().model, surrogate.model));
  }
  const auto refined = surrogate::refine(surrogate, candidates, o.target, static_cast<std::size_t>(o.most));
  fmt::print(
      "{}: of {} candidates the least certain is expected to be {:.2g} % off; {} presses, then {:.2g} %\n",
      s.name, candidates.size(), 100 * refined.largest.front(), refined.chosen.size(),
      100 * refined.largest.back());
  if (refined.largest.back() > o.target)
    fmt::print("  more than the {:.2g} % of --target; more with --most\n", 100 * o.target);
  if (refined.chosen.empty()) {
    fmt::print("  nothing to press\n");
    return;
  }
  const std::filesystem::path card =
      o.output.empty() ? std::filesystem::path(o.card).replace_filename(
                             std::filesystem::path(o.card).stem().string() + "-refined.toml")
                       : std::filesystem::path(o.output);
  const auto table = std::filesystem::path(card).replace_extension(".csv");
  if (std::filesystem::exists(card) && std::filesystem::equivalent(card, o.card))
    throw core::InvalidInput(fmt::format("-o {}: that is the study itself", card.string()));
  study::Sheet sheet{"design", {{"study", s.name}, {"surrogate", surrogate.pool}}, {"run"}, {}};
  for (const auto& factor : s.factors) sheet.columns.push_back(factor.name);
  for (const std::size_t i : refined.chosen) {
    std::vector<study::Cell> row = {static_cast<std::int64_t>(sheet.rows.size() + 1)};
    for (const auto& input : s.runs[i].inputs)
      std::visit([&](const auto& level) { row.emplace_back(level); }, input);
    sheet.rows.push_back(std::move(row));
  }
  core::write_file(table, study::csv_text(sheet));
  core::write_file(card,
                   refined_card(core::read_file(o.card), s, s.name + "-refined", table.filename().string()));
  study::read_study(card.string()); // what was written can be run
  fmt::print("  study           {0}, its materials {1}: `platen study run {0}`\n", card.string(),
             table.string());
}

} // namespace

void add_study_refine(Command study) {
  auto command = study.add_subcommand(
      "refine", "which materials to press next: those of which a surrogate is least sure");
  auto o = std::make_shared<Options>();
  command.add_option("STUDY.toml", o->card, "its runs are the candidates; the more, the better").required();
  command.add_option("--surrogate", o->file, "what is to become surer: a pool with a surrogate, or its file")
      .type_name("POOL")
      .required();
  command.add_option("--target", o->target, "until no candidate's curve is expected to be further off")
      .range(1e-5, 1.0)
      .type_name("SHARE")
      .capture_default_str();
  command.add_option("--most", o->most, "presses").range(1, 100000).capture_default_str();
  command.add_option("-o", o->output, "the study to run; default STUDY-refined.toml beside it, with a table")
      .type_name("FILE");
  command.footer(
      "Example: platen study refine candidates.toml --surrogate catalogue/pools/edmans-sinka --target 0.01");
  command.callback([o] { refine(*o); });
}

} // namespace platen::app
