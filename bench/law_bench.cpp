// What a contact costs: one thread, state read and written, branches at random. Each contact takes eight
// steps of a random walk with a rising trend; a pass over all contacts is one step, so that no branch and no
// state can be guessed from the one before. In batches (batch.hpp), as a DEM code does it, and one by one.
// 10^6 contacts, which come from memory, and 20,000, which stay in the cache: what the call itself costs.
// Printed: ns per contact, and the share of contacts that load.

#include "law_cases.hpp"

#include "platen/law/batch.hpp"
#include "platen/law/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {

using namespace platen::law;

constexpr std::size_t steps = 8;

/// Overlaps of all contacts at all steps; log-uniform between `low` and `high`.
std::vector<std::vector<double>> random_walks(std::size_t contacts, double low, double high) {
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

template <Want want> double read(const Response& now) {
  if constexpr (want == Want::force) return now.force;
  return now.force + now.contact_radius + now.mean_pressure + now.dissipated_work +
         (now.in_range ? now.stiffness : 0.0);
}

template <Want want>
void one_by_one(const Law& law, const std::vector<double>& overlap, std::vector<State>& state,
                std::vector<double>& read_out) {
  for (std::size_t i = 0; i < overlap.size(); ++i) {
    const Response now = evaluate(law, state[i], overlap[i]);
    state[i] = now.state;
    read_out[i] = read<want>(now);
  }
}

template <Want want>
void in_batches(const Law& law, const std::vector<double>& overlap, std::vector<State>& state,
                std::vector<double>& read_out) {
  static Batch b;
  for (int c = 0; c < Batch::size; ++c) b.law(c, *law.table, law.scale);
  for (std::size_t first = 0; first < overlap.size(); first += Batch::size) {
    const std::size_t count = std::min<std::size_t>(Batch::size, overlap.size() - first);
    for (std::size_t c = 0; c < count; ++c)
      b.overlap[c] = overlap[first + c], b.gamma_max[c] = state[first + c].gamma_max;
    evaluate<want>(b, static_cast<int>(count));
    for (std::size_t c = 0; c < count; ++c) {
      state[first + c] = {overlap[first + c], b.gamma_max[c]};
      read_out[first + c] = b.force[c];
      if constexpr (want == Want::everything)
        read_out[first + c] += b.contact_radius[c] + b.mean_pressure[c] + b.dissipated_work[c] +
                               (b.in_range[c] ? b.stiffness[c] : 0.0);
    }
  }
}

using Pass = decltype(one_by_one<Want::force>);

void run(benchmark::State& bench, const Law& law, double x_low, double x_high, Pass* pass) {
  const auto contacts = static_cast<std::size_t>(bench.range(0));
  const auto overlap = random_walks(contacts, x_low / law.scale.x_per_gamma, x_high / law.scale.x_per_gamma);
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
    for (std::size_t t = 0; t < steps; ++t) pass(law, overlap[t], state, force);
    benchmark::DoNotOptimize(force.data());
    benchmark::ClobberMemory();
    passes += steps;
  }
  bench.counters["ns/contact"] =
      benchmark::Counter(passes * static_cast<double>(contacts) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["loading"] = loading / static_cast<double>(steps * contacts);
}

void all_forms(const std::string& name, const Law& law, double x_low, double x_high) {
  const std::pair<Pass*, std::string> forms[] = {{in_batches<Want::force>, "/force"},
                                                 {in_batches<Want::everything>, "/everything"},
                                                 {one_by_one<Want::force>, "/one by one/force"},
                                                 {one_by_one<Want::everything>, "/one by one/everything"}};
  for (const auto& [pass, suffix] : forms)
    benchmark::RegisterBenchmark(
        (name + suffix).c_str(),
        [law, x_low, x_high, pass = pass](benchmark::State& s) { run(s, law, x_low, x_high, pass); })
        ->ArgName("contacts")
        ->Arg(1'000'000)
        ->Arg(20'000)
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
