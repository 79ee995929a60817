#include "reproduce/numbers.hpp"

#include "core/csv.hpp"
#include "core/number.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace platen::reproduce {
namespace {

std::string cell(std::string text) { // a comma would be another cell
  std::ranges::replace(text, ',', ';');
  return text;
}

/// What the difference of a comparison may move by: its error is relative to ours.
double allowed(const Comparison& c) {
  const double scale = c.measure == Measure::relative ? std::abs(c.theirs) : 1;
  return c.error * std::abs(c.ours) / scale;
}

} // namespace

std::string numbers_csv(const std::vector<Paper>& papers) {
  std::string text =
      fmt::format("# engine = {}\n# version = "
                  "{}\npaper,row,place,what,theirs,ours,difference,tolerance,measure,error,verdict\n",
                  core::engine, core::version);
  for (const Paper& paper : papers)
    for (const Row& row : paper.rows)
      for (std::size_t i = 0; i < row.comparisons.size(); ++i) {
        const Comparison& c = row.comparisons[i];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.8g},{:.8g},{:.6g},{:.6g},{},{:.6g},{}\n",
                       paper.name, row.id, i + 1, cell(c.what), c.theirs, c.ours, difference(c), c.tolerance,
                       c.measure == Measure::relative ? "relative" : "absolute", c.error,
                       name_of(verdict(row)));
      }
  return text;
}

Earlier read_numbers(const std::filesystem::path& file) {
  const core::Csv csv = core::read_csv(file);
  Earlier earlier{csv.note("engine"), csv.note("version"), {}};
  const auto row = csv.column("row"), place = csv.column("place"), ours = csv.column("ours"),
             off = csv.column("difference"), verdict = csv.column("verdict");
  for (const auto& line : csv.rows)
    earlier.numbers[line.cells[row] + "/" + line.cells[place]] = {csv.number(line, ours),
                                                                  csv.number(line, off), line.cells[verdict]};
  return earlier;
}

std::vector<Change> changes(const std::vector<Paper>& papers, const Earlier& earlier) {
  std::vector<Change> list;
  for (const Paper& paper : papers)
    for (const Row& row : paper.rows)
      for (std::size_t i = 0; i < row.comparisons.size(); ++i) {
        const auto before = earlier.numbers.find(fmt::format("{}/{}", row.id, i + 1));
        if (before == earlier.numbers.end()) continue;
        const Comparison& c = row.comparisons[i];
        const std::string now(name_of(verdict(row)));
        const bool moved = !(std::abs(difference(c) - before->second.difference) <=
                             allowed(c) + 1e-5 * std::abs(before->second.difference)); // six digits are kept
        if (moved || now != before->second.verdict)
          list.push_back({row.id, row.name, c.what, before->second.difference, difference(c), c.measure,
                          before->second.verdict, now});
      }
  return list;
}

} // namespace platen::reproduce
