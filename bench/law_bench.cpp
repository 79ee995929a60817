// What a contact costs: 10^6 contacts, one thread, state read and written, branches at random. Each contact
// takes eight steps of a random walk with a rising trend; a pass over all contacts is one step, so that no
// branch and no state can be guessed from the one before. Printed: ns per contact, and the share of contacts
// that load.

#include "platen/law/agarwal.hpp"
#include "platen/law/batch.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/hertz.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/wang.hpp"

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

enum class What { force, everything, batch };

template <class Law>
void pass(const Law& law, const std::vector<double>& overlap, std::vector<State>& state,
          std::vector<double>& force, std::vector<double>& stiffness, What what) {
  if (what == What::batch) {
    evaluate_all(law, overlap, state, force, stiffness);
    return;
  }
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

template <class Law>
void run(benchmark::State& bench, const Law& law, double x_low, double x_high, What what) {
  const auto overlap = random_walks(x_low / law.pair.x_per_gamma, x_high / law.pair.x_per_gamma);
  std::vector<State> state(contacts);
  std::vector<double> force(contacts), stiffness(contacts);
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
    for (std::size_t t = 0; t < steps; ++t) pass(law, overlap[t], state, force, stiffness, what);
    benchmark::DoNotOptimize(force.data());
    benchmark::ClobberMemory();
    passes += steps;
  }
  bench.counters["ns/contact"] =
      benchmark::Counter(passes * contacts * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["loading"] = loading / (steps * contacts);
}

template <class Law> void all_forms(const std::string& name, const Law& law, double x_low, double x_high) {
  for (auto [what, suffix] : {std::pair{What::force, "/force"}, std::pair{What::everything, "/everything"},
                              std::pair{What::batch, "/batch"}})
    benchmark::RegisterBenchmark(
        (name + suffix).c_str(),
        [law, x_low, x_high, what = what](benchmark::State& s) { run(s, law, x_low, x_high, what); })
        ->Unit(benchmark::kMillisecond)
        ->MinTime(0.5);
}

const bool registered = [] {
  const double R = 1e-3;
  all_forms("hertz", prepare_hertz(sphere(R, 1e9, 0.3), sphere(R, 1e9, 0.3)), 1e-6, 1e-2);
  all_forms("similarity", prepare(SimilarityMaterial{2e9, 0.3, 1e7, 0.3}, R), 1e-4, 3e-2);
  EdmansSinkaMaterial mcc; // as in the project's example of a law card
  mcc.sigma_ref = 8.61e6, mcc.E = 4.417e8, mcc.nu = 0.1472, mcc.k = 4.2, mcc.delta_t = 0.09, mcc.a = 3.5;
  all_forms("edmans-sinka", prepare(mcc, R), 1e-2, 0.5);
  all_forms("wang", prepare(WangMaterial{10e9, 0.15, 25, 15e6}, 0.1), 1e-6, 1e-4);
  // x from well below yield to the end of the range: all regimes
  all_forms("agarwal-simple", prepare(AgarwalMaterial{500e6, 0.3, 1e6, LoadingCase::simple}, R), 1e-5, 0.5);
  all_forms("agarwal-die", prepare(AgarwalMaterial{500e6, 0.3, 1e6, LoadingCase::die}, R), 1e-5, 0.5);
  all_forms("agarwal-hydrostatic", prepare(AgarwalMaterial{500e6, 0.3, 1e6, LoadingCase::hydrostatic}, R),
            1e-5, 0.2);
  all_forms("shahin-simple", prepare(ShahinMaterial{1e9, 0.3, 1e6, 0.3, LoadingCase::simple}, R), 1e-5, 0.5);
  all_forms("shahin-die", prepare(ShahinMaterial{1e9, 0.3, 1e6, 0.3, LoadingCase::die}, R), 1e-5, 0.47);
  all_forms("shahin-hydrostatic", prepare(ShahinMaterial{1e9, 0.3, 1e6, 0.3, LoadingCase::hydrostatic}, R),
            1e-5, 0.19);
  return true;
}();

} // namespace
