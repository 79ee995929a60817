// What a contact costs: 10^6 contacts, one thread, state read and written, branches at random. Each contact
// takes eight steps of a random walk with a rising trend; a pass over all contacts is one step, so that no
// branch and no state can be guessed from the one before. Printed: ns per contact, and the share of contacts
// that load.

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

/// Of each law a material, and overlaps from well below yield to the end of its range: all regimes.
struct Case {
  const char *law, *parameters;
  double x_low, x_high;
};
const Case cases[] = {
    {"hertz", "E_Pa=1e9 nu=0.3", 1e-6, 1e-2},
    {"similarity", "E_Pa=2e9 nu=0.3 kappa_Pa=1e7 inverse_m=0.3", 1e-4, 3e-2},
    {"edmans-sinka", "E_Pa=4.417e8 nu=0.1472 sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5", 1e-2, 0.5},
    {"wang", "E_Pa=1e10 nu=0.15 phi_deg=25 sigma_c_Pa=15e6", 1e-6, 1e-4},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6", 1e-5, 0.5},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=die", 1e-5, 0.5},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=hydrostatic", 1e-5, 0.2},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3", 1e-5, 0.5},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3 loading=die", 1e-5, 0.47},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3 loading=hydrostatic", 1e-5, 0.19},
    {"thornton-ning", "E_Pa=1e9 nu=0.3 p_y_Pa=1.6e6", 1e-6, 1e-2},
    {"kogut-etsion", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 1e-2},
    {"etsion-unloading", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 1e-2},
    {"jackson-green", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 0.1},
    {"mdr", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 0.5},
    {"luding", "k_1_N_per_m=1e5 k_2_N_per_m=5e5 phi_f=0.1", 1e-4, 0.2},
    {"eepa", "E_Pa=1e9 nu=0.3 lambda_p=0.6", 1e-4, 0.2},
    {"pressed",
     "E_Pa=2e9 nu=0.3 sigma_ref_Pa=1e7 delta_bar=1e-4,1e-3,1e-2,0.05,0.1,0.2,0.35,0.5 "
     "F_bar=6e-5,1.6e-3,0.035,0.22,0.48,1.1,2.2,4 a_bar=0.009,0.03,0.13,0.32,0.46,0.66,0.85,1 "
     "unload_delta_bar=0.1,0.3,0.5 alpha=1.4,1.3,1.25 beta=1.2,1.5,1.7",
     1e-5, 0.5},
};

const bool registered = [] {
  for (const Case& c : cases) {
    std::string name = c.law;
    for (const char* loading : {"die", "hydrostatic"})
      if (std::string(c.parameters).find(loading) != std::string::npos) name += std::string("-") + loading;
    all_forms(name, make_law(c.law, "", parameter_texts(std::string("radius_m=1e-3 ") + c.parameters)),
              c.x_low, c.x_high);
  }
  return true;
}();

} // namespace
