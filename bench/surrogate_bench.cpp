// What one prediction costs, one thread: description, curve, unloading and error band of a material that no
// pool has; and the curve alone. Reading a surrogate from its file is not in it.

#include "material/card.hpp"
#include "surrogate/assess.hpp"
#include "surrogate/natural_neighbours.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <utility>

namespace {

using namespace platen;

/// The surrogate that knows the card, asked as often as wanted.
void predict(benchmark::State& state, const char* card) {
  const auto material = material::read_card(card).material;
  const auto surrogate = surrogate::ask_catalogue(surrogate::describe(material.model)).surrogate;
  for (auto _ : state)
    benchmark::DoNotOptimize(surrogate::predict(surrogate, surrogate::describe(material.model)));
  state.SetLabel(surrogate.pool);
}
/// The force at the knots, without a band.
void force(benchmark::State& state, const char* card) {
  const auto description = surrogate::describe(material::read_card(card).material.model);
  const auto surrogate = surrogate::ask_catalogue(description).surrogate;
  const auto at = surrogate::input_of(surrogate, description.coordinates);
  for (auto _ : state)
    for (const auto& layer : surrogate.layers)
      benchmark::DoNotOptimize(surrogate::values_at(layer.force, layer.columns, at));
  state.SetLabel(surrogate.pool);
}
BENCHMARK_CAPTURE(force, elastic, "elastic")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(force, metal, "von-mises-100")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(force, metal_that_hardens, "lead-ludwik")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(force, granule, "base-case")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(force, powder, "mcc-ph-200")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict, elastic, "elastic")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict, metal, "von-mises-100")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict, metal_that_hardens, "lead-ludwik")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict, granule, "base-case")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict, powder, "mcc-ph-200")->Unit(benchmark::kMicrosecond);

/// Of 162 places on a grid in four dimensions, as Table 1 of Wang et al.: the shares of a place between them.
void natural_neighbours(benchmark::State& state) {
  surrogate::Inputs sites{4, {}};
  for (int i = 0; i < 162; ++i)
    for (const auto& [step, levels] : {std::pair{54, 3}, std::pair{18, 3}, std::pair{6, 3}, std::pair{1, 6}})
      sites.values.push_back(static_cast<double>(i / step % levels) / (levels - 1));
  const surrogate::NaturalNeighbours n(sites);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (auto _ : state) {
    const std::array<double, 4> at{unit(random), unit(random), unit(random), unit(random)};
    benchmark::DoNotOptimize(n.shares(at));
  }
}
BENCHMARK(natural_neighbours)->Unit(benchmark::kMicrosecond);

} // namespace
