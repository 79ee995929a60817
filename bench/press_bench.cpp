// What a press costs with the defaults, on one thread: time per phase, iterations, memory. Medians of
// repeats.

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/version.hpp"
#include "material/card.hpp"
#include "press/press.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace {

using namespace platen;

/// A press and the seconds it may take, with what we aim for.
struct Bench {
  const char* name;
  const char* material;
  press::Experiment experiment;
  double limit_s, target_s;
};
press::Simple unloaded(std::vector<double> from) {
  press::Simple e;
  e.unload_from = std::move(from);
  return e;
}
template <class X> X meshed(int elements) {
  X e;
  e.elements = elements;
  return e;
}
const std::vector<Bench> benches = {
    {"von Mises, E/sigma_y = 100", "von-mises-100", press::Simple{}, 10, 4},
    {"VMDC base case", "base-case", press::Simple{}, 15, 5},
    {"VMDC base case, 5 unloadings", "base-case", unloaded({0.1, 0.2, 0.3, 0.4, 0.5}), 20, 8},
};
/// In space, to zero porosity, once each: three meshes, the last the default.
const std::vector<Bench> confined_benches = {
    {"die, 1,300 hexahedra", "von-mises-100", meshed<press::Die>(1300), 600, 180},
    {"die, 2,600 hexahedra", "von-mises-100", meshed<press::Die>(2600), 600, 180},
    {"die, 5,000 hexahedra", "von-mises-100", meshed<press::Die>(5000), 600, 180},
    {"hydrostatic, 5,000 hexahedra", "von-mises-100", meshed<press::Hydrostatic>(5000), 600, 180},
};
constexpr double memory_limit_MB = 500, confined_memory_limit_MB = 4000;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

/// Largest resident memory of this process so far.
double peak_memory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6; // Linux counts in KiB
}

/// The median of one entry of the statistics.
double median_of(const std::vector<press::Statistics>& runs, double press::Statistics::*seconds) {
  std::vector<double> values;
  for (const auto& run : runs) values.push_back(run.*seconds);
  return median(std::move(values));
}

nlohmann::ordered_json measure(const Bench& bench, int repeats) {
  const press::Case c{material::read_card(bench.material).material, 1e-3, bench.experiment};
  std::vector<press::Statistics> runs;
  std::vector<double> cpu_s; // what others on the machine take is not in it
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    const press::Result result = press::press(c);
    cpu_s.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (result.failure) throw core::ConvergenceError(*result.failure, 0, 0, 0);
    runs.push_back(result.statistics);
  }
  const press::Statistics& last = runs.back();
  using S = press::Statistics;
  const double total = median_of(runs, &S::total_s), material = median_of(runs, &S::material_s),
               assembly = median_of(runs, &S::assembly_s), factor = median_of(runs, &S::factorisation_s),
               solve = median_of(runs, &S::solve_s), cpu = median(cpu_s), memory = peak_memory_MB();
  fmt::print(
      "{:<30} {:>7.2f} {:>7.2f} {:>6.0f} {:>6.0f}  {:>8.2f} {:>8.2f} {:>8.2f} {:>6.2f}  {:>5} {:>5} {:>4}  "
      "{:>6.0f}\n",
      bench.name, total, cpu, bench.limit_s, bench.target_s, material, assembly, factor, solve, last.steps,
      last.iterations, last.cuts, memory);
  std::fflush(stdout);
  nlohmann::ordered_json json = {{"name", bench.name},
                                 {"material", bench.material},
                                 {"unload_from", by_overlap(c.experiment)->unload_from},
                                 {"total_s", total},
                                 {"cpu_s", cpu},
                                 {"limit_s", bench.limit_s},
                                 {"target_s", bench.target_s},
                                 {"material_s", material},
                                 {"assembly_s", assembly},
                                 {"factorisation_s", factor},
                                 {"solve_s", solve},
                                 {"elements", last.elements},
                                 {"unknowns", last.unknowns},
                                 {"steps", last.steps},
                                 {"iterations", last.iterations},
                                 {"cuts", last.cuts},
                                 {"peak_memory_MB", memory}};
  for (const auto& run : runs) json["repeats_s"].push_back(run.total_s);
  return json;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App program("Times presses with the defaults.", "bench_press");
  int repeats = 3;
  std::string out;
  program.add_option("--repeats", repeats, "presses of each kind")->check(CLI::PositiveNumber);
  program.add_option("--out", out, "write the figures here, as JSON")->type_name("FILE.json");
  CLI11_PARSE(program, argc, argv);
  try {
    fmt::print("Presses to delta_bar = 0.5, one thread, medians of {}; seconds, MB (limit {:.0f})\n\n",
               repeats, memory_limit_MB);
    fmt::print("{:<30} {:>7} {:>7} {:>6} {:>6}  {:>8} {:>8} {:>8} {:>6}  {:>5} {:>5} {:>4}  {:>6}\n", "",
               "total", "cpu", "limit", "target", "material", "assembly", "factor", "solve", "steps", "iter",
               "cuts", "memory");
    nlohmann::ordered_json json = {{"program", "bench_press"},
                                   {"platen", core::version},
                                   {"engine", core::engine},
                                   {"repeats", repeats},
                                   {"threads", 1},
                                   {"memory_limit_MB", memory_limit_MB}};
    for (const auto& bench : benches) json["presses"].push_back(measure(bench, repeats));
    fmt::print("To zero porosity, once each (memory limit {:.0f} MB)\n", confined_memory_limit_MB);
    for (const auto& bench : confined_benches) json["presses"].push_back(measure(bench, 1));
    if (!out.empty()) core::write_file(out, json.dump(2) + "\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_press: {}\n", error.what());
    return 1;
  }
}
