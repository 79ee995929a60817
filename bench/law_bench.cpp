// What a contact costs: 10^6 contacts, one thread, state read and written, branches at random. Each contact
// takes eight steps of a random walk with a rising trend; a pass over all contacts is one step, so that no
// branch and no state can be guessed from the one before. Printed: ns per contact, and the share of contacts
// that load.

#include "law_cases.hpp"

#include "platen/law/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {

using namespace platen::law;

constexpr std::size_t contacts = 1'000'000;
constexpr std::size_t steps = 8;

/// Overlaps of all contacts at all steps; log-uniform between `low` and `high`.
std::vector<std::vector<double>> random_walks(double low, double high) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<std::vector<double>> overlap(steps, std::vector<double>(contacts));
  for (std::size_t i = 0; i < contacts; ++i) {
    const double size = low * std::pow(high / low, u(random));
    for (std::size_t t = 0; t < steps; ++t)
      overlap[t][i] = size * (0.55 + 0.05 * static_cast<double>(t)) * (0.8 + 0.4 * u(random));
  }
  return overlap;
}

enum class What { force, everything };

void pass(const Law& law, const std::vector<double>& overlap, std::vector<State>& state,
          std::vector<double>& force, What what) {
  if (what == What::force) {
    for (std::size_t i = 0; i < contacts; ++i) {
      const Response now = evaluate(law, state[i], overlap[i]);
      state[i] = now.state;
      force[i] = now.force;
    }
    return;
  }
  for (std::size_t i = 0; i < contacts; ++i) {
    const Response now = evaluate(law, state[i], overlap[i]);
    state[i] = now.state;
    force[i] = now.force + now.contact_radius + now.mean_pressure + now.dissipated_work +
               (now.in_range ? now.stiffness : 0.0);
  }
}

void run(benchmark::State& bench, const Law& law, double x_low, double x_high, What what) {
  const auto overlap = random_walks(x_low / law.scale.x_per_gamma, x_high / law.scale.x_per_gamma);
  std::vector<State> state(contacts);
  std::vector<double> force(contacts);
  double loading = 0, passes = 0;
  for (std::size_t t = 0; t < steps; ++t) // warm up, and count the branches
    for (std::size_t i = 0; i < contacts; ++i) {
      const Response now = evaluate(law, state[i], overlap[t][i]);
      loading += now.branch == Branch::loading;
      state[i] = now.state;
    }
  for (auto _ : bench) {
    bench.PauseTiming();
    std::fill(state.begin(), state.end(), State{});
    bench.ResumeTiming();
    for (std::size_t t = 0; t < steps; ++t) pass(law, overlap[t], state, force, what);
    benchmark::DoNotOptimize(force.data());
    benchmark::ClobberMemory();
    passes += steps;
  }
  bench.counters["ns/contact"] =
      benchmark::Counter(passes * contacts * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["loading"] = loading / (steps * contacts);
}

void all_forms(const std::string& name, const Law& law, double x_low, double x_high) {
  for (auto [what, suffix] : {std::pair{What::force, "/force"}, std::pair{What::everything, "/everything"}})
    benchmark::RegisterBenchmark(
        (name + suffix).c_str(),
        [law, x_low, x_high, what = what](benchmark::State& s) { run(s, law, x_low, x_high, what); })
        ->Unit(benchmark::kMillisecond)
        ->MinTime(0.5);
}

const bool registered = [] {
  for (const auto& c : platen::bench::law_cases)
    all_forms(c.name(), make_law(c.law, "", parameter_texts(std::string("radius_m=1e-3 ") + c.parameters)),
              c.x_low, c.x_high);
  return true;
}();

} // namespace
