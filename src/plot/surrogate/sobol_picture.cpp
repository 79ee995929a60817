#include "plot/surrogate/sobol_picture.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace platen::plot {

void sobol_picture(const surrogate::Sensitivity& s, const std::filesystem::path& file) {
  constexpr const char* shades[] = {"#9ecae1", "#4292c6", "#084594", "#d55e00",
                                    "#e69f00"}; // force, then energies
  const auto largest = [](const surrogate::SobolIndices& n) {
    return *std::max_element(n.total.begin(), n.total.end());
  };
  std::vector<std::size_t> order(s.numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return largest(s.numbers[i]) > largest(s.numbers[j]);
  });
  std::string data = "$d << EOD\n", tics;
  const double width = 0.8 / static_cast<double>(s.outputs.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    const auto& n = s.numbers[order[place]];
    tics += fmt::format("{}{} {}", place ? ", " : "", gnuplot_string(n.key), place);
    for (std::size_t o = 0; o < s.outputs.size(); ++o)
      data += fmt::format("{} {:.5f} {:.5f} {}\n",
                          static_cast<double>(place) - 0.4 + (static_cast<double>(o) + 0.5) * width,
                          std::max(0.0, n.total[o]), std::max(0.0, n.alone[o]), o);
  }
  data += "EOD\n";
  std::string plots;
  for (std::size_t o = 0; o < s.outputs.size(); ++o)
    plots +=
        fmt::format("{0}$d using ($4=={1}?$1:NaN):2 with boxes fs solid 0.35 noborder lc rgb '{2}' notitle, "
                    "'' using ($4=={1}?$1:NaN):3 with boxes fs solid 1 noborder lc rgb '{2}' title {3}",
                    o ? ", " : "plot ", o, shades[o % 5], gnuplot_string(s.outputs[o]));
  run_gnuplot(
      terminal(file, std::max(620, 110 + 75 * static_cast<int>(order.size())), 440) + data +
          fmt::format(
              "set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\nset grid y lc rgb "
              "'#e3e7eb' lt 1 lw 1\nset key top right samplen 1 tc rgb '{0}' noenhanced\nset boxwidth {1}\n"
              "set xtics ({2}) noenhanced\nset yrange [0:*]\nset xrange [-0.6:{3}]\n"
              "set ylabel 'Sobol index: alone (full), with others (pale)' tc rgb '{0}'\n",
              ink, 0.95 * width, tics, static_cast<double>(order.size()) - 0.4) +
          plots + "\n",
      file);
}

} // namespace platen::plot
