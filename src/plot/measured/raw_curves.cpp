#include "plot/measured/raw_curves.hpp"

#include "plot/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace platen::plot {

namespace {

/// Okabe and Ito; in the order of the stages, unloading and reloading alike.
struct Kind {
  const char *name, *colour, *title;
};
constexpr std::array kinds = {Kind{"before", "#8a949e", "before contact"},
                              Kind{"loading", "#0072b2", "loading"}, Kind{"hold", "#e69f00", "held"},
                              Kind{"back", "#009e73", "unloading, reloading"},
                              Kind{"cut", "#d55e00", "broken: kept out"}};

std::size_t kind_of(measure::Stage stage) {
  switch (stage) {
  case measure::Stage::approach:
    return 0;
  case measure::Stage::loading:
    return 1;
  case measure::Stage::hold:
    return 2;
  case measure::Stage::unloading:
  case measure::Stage::reloading:
    return 3;
  default:
    return 4;
  }
}

} // namespace

std::string data_block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name,
                     rows.find_first_not_of('\n') == rows.npos ? "NaN NaN\n" : rows);
}

std::string panel_style() {
  return fmt::format(
      "set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
      "set grid lc rgb '#e3e7eb' lt 1 lw 1\nset key left top Left reverse noenhanced samplen 2 tc rgb "
      "'{0}'\n",
      ink);
}

RawPanel raw_panel(const std::vector<Staged>& particles) {
  constexpr std::size_t drawn = 2000; // rows of a particle
  std::array<std::string, kinds.size()> rows;
  double force_most = 0;
  for (const auto& [s, stages] : particles) {
    const std::size_t stride = std::max<std::size_t>(1, s->force_N.size() / drawn);
    const auto row = [&](std::size_t kind, std::size_t i) {
      rows[kind] += fmt::format("{:.7g} {:.7g}\n", s->travel_m[i] * 1e6, s->force_N[i]);
    };
    std::size_t last = kinds.size();
    for (std::size_t i = 0; i < s->force_N.size(); i += stride) {
      const std::size_t kind = stages->broke ? 4 : kind_of(stages->of_row[i]);
      if (last < kinds.size() && kind != last)
        row(last, i), rows[last] += "\n"; // the line goes on to the next
      row(kind, i);
      force_most = std::max(force_most, s->force_N[i]);
      last = kind;
    }
    rows[last] += "\n"; // lines of particles are not joined
  }
  const Unit force = unit_for(force_most, {{"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"µN", 1e-6}});
  RawPanel panel;
  panel.commands = fmt::format("set title 'as measured' tc rgb '{0}'\n"
                               "set xlabel 'travel, sign turned where it was  (µm)' tc rgb '{0}'\n"
                               "set ylabel 'force  ({1})' tc rgb '{0}'\nplot ",
                               ink, force.name);
  bool first = true;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (rows[k].empty()) continue;
    panel.data += data_block(kinds[k].name, rows[k]);
    panel.commands +=
        fmt::format("{}${} using 1:($2/{}) with lines lw 1.5 lc rgb '{}' title '{}'", first ? "" : ", ",
                    kinds[k].name, force.in_SI, kinds[k].colour, kinds[k].title);
    first = false;
  }
  panel.commands += "\n";
  return panel;
}

} // namespace platen::plot
