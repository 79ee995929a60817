#include "measure/specimen.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "core/toml.hpp"
#include "measure/columns.hpp"
#include "measure/particle_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::measure {
namespace {

using core::InvalidInput;

class Importer {
 public:
  Importer(const Sheet& sheet, const ReadOptions& options) : sheet_(sheet), options_(options) {
    if (!options.displacement_is.empty() && options.displacement_is != "travel" &&
        options.displacement_is != "contact")
      throw InvalidInput(
          fmt::format("--displacement-is {}: it is travel, the way between the platens (2 delta), "
                      "or contact, that of one platen (delta)",
                      options.displacement_is));
  }

  std::vector<Specimen> read() {
    for (const auto& table : sheet_.tables) read_table(table);
    for (auto& s : specimens_) finish(s);
    say_found();
    return std::move(specimens_);
  }
  std::vector<std::string> said() { return std::move(said_); }

 private:
  struct Origin {
    const Table* table;
    Roles roles;
    std::string title;
  };

  void read_table(const Table& table) {
    for (const auto& remark : table.remarks) // of a file that `platen import` wrote
      if (const std::string text = remark.text(); text.starts_with("# machine taken off"))
        say_once(text.substr(2));
    const auto groups = groups_of(table);
    for (const auto& group : groups) {
      Origin origin{&table, roles_of(sheet_, table, group, options_), {}};
      for (auto k = group.first; k < std::min(group.first + group.count, table.titles.size()); ++k)
        if (origin.title.empty()) origin.title = table.titles[k];
      read_group(origin, groups.size() > 1);
    }
    say_columns(table);
  }

  void read_group(const Origin& origin, bool side_by_side) {
    const Table& table = *origin.table;
    const auto& roles = origin.roles;
    const auto value = [&](const Chosen& c, std::size_t row) {
      return table.columns[c.column].values[row] * c.unit.in_SI;
    };
    refuse_words(table, roles.force.column);
    refuse_words(table, roles.displacement.column);
    const auto names = names_by_row(origin);
    bool fresh = side_by_side || begins_particle(origin);
    std::vector<int> left_out;
    double diameter = 0;
    std::size_t before = 0; // the row used last
    for (std::size_t row = 0; row < table.lines.size(); ++row) {
      const double F = value(roles.force, row), x = value(roles.displacement, row);
      if (!std::isfinite(F) || !std::isfinite(x)) {
        if (!is_empty(table, roles, row)) left_out.push_back(table.lines[row]);
        continue;
      }
      double its = 0;
      if (roles.diameter) {
        its = value(*roles.diameter, row) * (roles.diameter_is_radius ? 2 : 1);
        if (!(its > 0))
          throw InvalidInput(fmt::format("{}, line {}, column {}: the diameter must be > 0", sheet_.file,
                                         table.lines[row],
                                         table.columns[roles.diameter->column].heading.text));
      }
      const bool other = !names.empty() && names[row] != names[before];
      if (fresh || other || (its != diameter && diameter > 0)) start(origin, row, names);
      if (roles.diameter && !specimens_.back().diameter_m) specimens_.back().diameter_m = its;
      diameter = its;
      before = row;
      fresh = false;
      auto& s = specimens_.back();
      s.line.push_back(table.lines[row]);
      s.travel_m.push_back(x);
      s.force_N.push_back(F);
      if (roles.time) s.time_s.push_back(value(*roles.time, row));
    }
    say_left_out(table, roles, left_out);
  }

  void start(const Origin& origin, std::size_t row, const std::vector<std::string>& names) {
    const Table& table = *origin.table;
    Specimen s;
    s.file = sheet_.file;
    s.first_line = table.lines[row];
    s.force_unit = origin.roles.force.unit;
    s.travel_unit = origin.roles.displacement.unit;
    s.force_column = table.columns[origin.roles.force.column].heading.text;
    s.travel_column = table.columns[origin.roles.displacement.column].heading.text;
    s.contact_overlap = options_.displacement_is == "contact" ||
                        (options_.displacement_is.empty() &&
                         is_contact_overlap(table.columns[origin.roles.displacement.column].heading.name));
    if (!names.empty()) s.name = core::number_from(names[row]) ? "particle " + names[row] : names[row];
    if (!origin.title.empty()) {
      if (s.name.empty()) s.name = particle_name(origin.title);
      s.diameter_m = diameter_in(origin.title, sheet_.dialect);
    }
    for (const auto& remark : table.remarks) {
      const std::string text = remark.text();
      if (const auto d = diameter_in(text, sheet_.dialect); d && !s.diameter_m) s.diameter_m = d;
      else if (s.name.empty() && names_particle(text, sheet_.dialect)) s.name = particle_name(text);
    }
    specimens_.push_back(std::move(s));
  }

  /// A table after another goes on with the same particle where only its time goes on.
  bool begins_particle(const Origin& origin) {
    if (specimens_.empty()) return true;
    const Table& table = *origin.table;
    for (const auto& remark : table.remarks)
      if (names_particle(remark.text(), sheet_.dialect)) return true;
    const auto& last = specimens_.back();
    if (!origin.roles.time || last.time_s.empty()) return true;
    const double begins =
        table.columns[origin.roles.time->column].values.front() * origin.roles.time->unit.in_SI;
    if (!(begins >= last.time_s.back())) return true;
    said_.push_back(
        fmt::format("the section from line {} on is joined to the one before, in time", table.line));
    return false;
  }

  std::vector<std::string> names_by_row(const Origin& origin) const {
    if (!origin.roles.particle) return {};
    const Table& table = *origin.table;
    const auto& column = table.columns[*origin.roles.particle];
    std::vector<std::string> names;
    names.reserve(table.lines.size());
    for (double v : column.values) names.push_back(std::isfinite(v) ? core::number_text(v) : "");
    for (const auto& [row, word] : column.words) names[row] = word;
    return names;
  }

  void refuse_words(const Table& table, std::size_t k) const {
    for (const auto& [row, word] : table.columns[k].words)
      if (!is_no_reading(word))
        throw InvalidInput(fmt::format("{}, line {}, column {}: {} is not a number", sheet_.file,
                                       table.lines[row], core::in_quotes(table.columns[k].heading.text),
                                       core::in_quotes(word.substr(0, 40))));
  }

  static bool is_empty(const Table& table, const Roles& roles, std::size_t row) {
    for (auto k : {roles.force.column, roles.displacement.column}) {
      const auto& column = table.columns[k];
      if (std::isfinite(column.values[row])) return false;
      const auto word =
          std::ranges::lower_bound(column.words, row, {}, [](const auto& entry) { return entry.first; });
      if (word != column.words.end() && word->first == row) return false;
    }
    return true;
  }

  void say_left_out(const Table& table, const Roles& roles, const std::vector<int>& lines) {
    if (lines.empty()) return;
    if (5 * lines.size() > table.lines.size())
      throw InvalidInput(
          fmt::format("{}, line {}: {} of {} rows have no reading of force and displacement; are "
                      "these the right columns?",
                      sheet_.file, lines.front(), lines.size(), table.lines.size()));
    std::string what = "an empty cell";
    for (auto k : {roles.displacement.column, roles.force.column})
      for (const auto& [row, word] : table.columns[k].words)
        if (table.lines[row] == lines.front())
          what = fmt::format("{} in column {}", core::in_quotes(word),
                             core::in_quotes(table.columns[k].heading.text));
    std::vector<int> shown(lines.begin(),
                           lines.begin() + static_cast<long>(std::min<std::size_t>(lines.size(), 5)));
    said_.push_back(fmt::format("{} without a reading left out: {} {}{} ({})",
                                lines.size() == 1 ? "1 row" : fmt::format("{} rows", lines.size()),
                                lines.size() == 1 ? "line" : "lines", fmt::join(shown, ", "),
                                lines.size() > shown.size() ? " and others" : "", what));
  }

  /// Each sentence once, though many tables have the same columns.
  void say_once(std::string sentence) {
    if (std::ranges::find(said_, sentence) == said_.end()) said_.push_back(std::move(sentence));
  }

  void say_columns(const Table& table) {
    for (const auto& column : table.columns) {
      const Quantity what = quantity_named(column.heading.name);
      const bool channel = what != Quantity::diameter && what != Quantity::radius &&
                           what != Quantity::particle &&
                           std::ranges::any_of(column.values, [](double v) { return std::isfinite(v); });
      if (channel && !column.heading.text.empty() && is_dead(column))
        say_once(fmt::format("column {} is dead, all values alike: not used",
                             core::in_quotes(column.heading.text)));
    }
  }

  void finish(Specimen& s) {
    if (s.force_N.size() < 10)
      throw InvalidInput(fmt::format("{}, line {}: {} rows; a measured curve needs 10 at least", s.file,
                                     s.first_line, s.force_N.size()));
    if (s.name.empty()) s.name = fmt::format("particle {}", 1 + (&s - specimens_.data()));
    if (options_.diameter_m) {
      if (s.diameter_m && std::abs(*s.diameter_m / *options_.diameter_m - 1) > 1e-3)
        throw InvalidInput(fmt::format("{}: {} has the diameter {:.5g} mm in the file and {:.5g} mm on the "
                                       "command line (R = {:.5g} mm); leave "
                                       "one out",
                                       s.file, s.name, *s.diameter_m * 1e3, *options_.diameter_m * 1e3,
                                       *options_.diameter_m / 2 * 1e3));
      s.diameter_m = options_.diameter_m;
    }
    const auto largest = std::ranges::max_element(s.force_N, {}, [](double F) { return std::abs(F); });
    if (*largest < 0) {
      for (double& F : s.force_N) F = -F;
      s.force_sign = -1;
    }
    if (s.travel_m[static_cast<std::size_t>(largest - s.force_N.begin())] < s.travel_m.front()) {
      for (double& x : s.travel_m) x = -x;
      s.travel_sign = -1;
    }
  }

  void say_found() {
    for (const auto& s : specimens_) {
      say_once(fmt::format("force: column {} in {}{}", core::in_quotes(s.force_column), s.force_unit.name,
                           s.force_sign < 0 ? ", sign turned" : ""));
      say_once(fmt::format("displacement: column {} in {}{}, taken as {}", core::in_quotes(s.travel_column),
                           s.travel_unit.name, s.travel_sign < 0 ? ", sign turned" : "",
                           s.contact_overlap ? "that of one platen, delta"
                                             : "the way between the platens, 2 delta"));
      const auto& unit = s.force_unit.name;
      if (unit == "g" || unit == "kg" || unit == "p")
        say_once(fmt::format("{} are forces: 1 {} = {} N", unit == "kg" ? "kilograms" : "grams", unit,
                             core::number_text(s.force_unit.in_SI)));
    }
  }

  const Sheet& sheet_;
  const ReadOptions& options_;
  std::vector<Specimen> specimens_;
  std::vector<std::string> said_;
};

} // namespace

std::string Specimen::on_scale_of_file(double travel) const {
  return fmt::format("{:.5g} {}", travel_sign * travel / travel_unit.in_SI, travel_unit.name);
}

Measurement read_measurement(const Text& text, const ReadOptions& options) {
  const Sheet sheet = read_sheet(text);
  Measurement m{text.file, {}, fmt::format("{}, {}", sheet.encoding, sheet.dialect.words()), {}, sheet.said};
  Importer importer(sheet, options);
  m.specimens = importer.read();
  for (auto& sentence : importer.said()) m.said.push_back(std::move(sentence));
  return m;
}

Measurement read_measurement(const std::filesystem::path& path, const ReadOptions& options) {
  if (!core::is_there(path)) throw InvalidInput(fmt::format("{}: there is no such file", path.string()));
  std::string bytes = core::read_file(path);
  const std::string digest = core::sha256(bytes);
  Measurement m = read_measurement(decode(std::move(bytes), path.string()), options);
  m.sha256 = digest;
  return m;
}

} // namespace platen::measure
