// The press beside CalculiX: von Mises, E/sigma_y = 100, equal mesh and output points, one thread each, one
// after the other. Plastic flow is of second order in the step here and of first order there: for an error of
// the same size CalculiX gets smaller steps.

#include "core/file.hpp"
#include "core/version.hpp"
#include "material/card.hpp"
#include "peers/calculix.hpp"
#include "press/press.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace {

using namespace platen;

struct Ours {
  std::vector<double> F_bar;
  press::Statistics statistics;
  double cpu_s = 0;
};

Ours run_ours(int elements, const bench::PressOfPeer& peer) {
  press::Simple e;
  e.elements = elements;
  e.fields_at = peer.delta_bar; // the press stops there exactly
  const press::Case c{material::read_card("von-mises-100").material, 1e-3, e};
  const std::clock_t start = std::clock();
  const auto result = press::press(c);
  Ours ours;
  ours.cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  ours.statistics = result.statistics;
  if (result.failure) throw std::runtime_error(*result.failure);
  for (const double d : peer.delta_bar)
    for (const auto& point : result.curve.points)
      if (point.delta_bar == d) ours.F_bar.push_back(point.F_bar);
  return ours;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App program("Presses the same sphere here and in CalculiX.", "bench_peers");
  int elements = 4000;
  std::string out, folder = "out/bench/calculix";
  program.add_option("--elements", elements, "wanted number of elements")->capture_default_str();
  program.add_option("--folder", folder, "where CalculiX works")->type_name("DIR")->capture_default_str();
  program.add_option("--out", out, "write the figures here, as JSON")->type_name("FILE.json");
  bench::PressOfPeer press;
  program.add_option("--peer-step", press.step_max, "largest step of delta_bar of CalculiX")
      ->check(CLI::Range(1e-4, 0.1))
      ->capture_default_str();
  CLI11_PARSE(program, argc, argv);
  try {
    for (int i = 1; i <= 25; ++i) press.delta_bar.push_back(i / 50.0);
    const auto mesh = fe::quarter_disc(elements);
    fmt::print(
        "von Mises, E/sigma_y = 100, {} elements, steps of delta_bar up to {}, of CalculiX {}, one thread\n",
        mesh.elements.size(), press::Simple{}.step_max, press.step_max);
    const Ours ours = run_ours(elements, press);
    const auto& s = ours.statistics;
    fmt::print("platen   {:7.1f} s of processor time, {} steps, {} iterations\n", ours.cpu_s, s.steps,
               s.iterations);
    fmt::print(stderr, "ccx runs now, for some minutes\n");
    std::fflush(stdout);
    const auto peer = bench::run_calculix(mesh, press, folder);
    fmt::print("ccx      {:7.1f} s of processor time, {} steps, {} iterations\n\n", peer.cpu_s,
               peer.increments, peer.iterations);

    double worst = 0;
    fmt::print("{:>9} {:>9} {:>9} {:>9}\n", "delta_bar", "platen", "ccx", "deviation");
    for (std::size_t i = 0; i < press.delta_bar.size(); ++i) {
      const double deviation = ours.F_bar[i] / peer.F_bar[i] - 1;
      worst = std::max(worst, std::abs(deviation));
      fmt::print("{:>9.2f} {:>9.4f} {:>9.4f} {:>8.2f}%\n", press.delta_bar[i], ours.F_bar[i], peer.F_bar[i],
                 100 * deviation);
    }
    const double ratio = peer.cpu_s / ours.cpu_s;
    fmt::print(
        "\nlargest deviation of the force {:.2f} % (limit 1.5 %); {:.1f} times faster (limit 8, target 20)\n",
        100 * worst, ratio);
    const nlohmann::ordered_json json = {
        {"program", "bench_peers"},
        {"platen", core::version},
        {"engine", core::engine},
        {"elements", mesh.elements.size()},
        {"delta_bar", press.delta_bar},
        {"ours", {{"F_bar", ours.F_bar}, {"cpu_s", ours.cpu_s}, {"iterations", s.iterations}}},
        {"calculix", {{"F_bar", peer.F_bar}, {"cpu_s", peer.cpu_s}, {"iterations", peer.iterations}}},
        {"largest_deviation", worst},
        {"times_faster", ratio}};
    if (!out.empty()) core::write_file(out, json.dump(2) + "\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_peers: {}\n", error.what());
    return 1;
  }
}
