// What a Gauss point of a finite element pays to enter and leave the principal axes in which the material is
// updated (material_bench), one thread, ns a point: b_e^tr to its eigenvalues, axes and logarithmic strains,
// and principal stresses back to a tensor.

#include "fe/tensor.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace platen;

constexpr std::size_t count = 4096;

/// Elastic left Cauchy-Green tensors of strains of about 1 %, axes anywhere.
std::vector<fe::Symmetric3> tensors() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> strain(0, 0.01);
  std::vector<fe::Symmetric3> all(count);
  for (auto& b : all)
    for (int i = 0; i < 6; ++i) b[i] = (i < 3 ? 1 : 0) + 2 * strain(random);
  return all;
}

void report(benchmark::State& state) {
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(count),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// In space, by rotations (hexahedra).
void space_to_axes(benchmark::State& state) {
  const auto all = tensors();
  for (auto _ : state)
    for (const auto& b : all) {
      const fe::Spectral s = fe::spectral(b);
      std::array<double, 3> eps;
      for (int A = 0; A < 3; ++A) eps[A] = std::log(s.value[A]) / 2;
      benchmark::DoNotOptimize(s);
      benchmark::DoNotOptimize(eps);
    }
  report(state);
}
void space_from_axes(benchmark::State& state) {
  std::vector<fe::Spectral> all;
  for (const auto& b : tensors()) all.push_back(fe::spectral(b));
  for (auto _ : state)
    for (const auto& s : all) benchmark::DoNotOptimize(fe::compose(s.value, s.axis));
  report(state);
}

/// In the section of a solid of revolution, the hoop beside it.
void section_to_axes(benchmark::State& state) {
  const auto all = tensors();
  for (auto _ : state)
    for (const auto& b : all) {
      const fe::PlaneSpectral s = fe::plane_spectral(b[0], b[1], b[3]);
      const std::array eps{std::log(s.value_1) / 2, std::log(s.value_2) / 2, std::log(b[2]) / 2};
      benchmark::DoNotOptimize(s);
      benchmark::DoNotOptimize(eps);
    }
  report(state);
}
void section_from_axes(benchmark::State& state) {
  std::vector<fe::PlaneSpectral> all;
  for (const auto& b : tensors()) all.push_back(fe::plane_spectral(b[0], b[1], b[3]));
  for (auto _ : state)
    for (const auto& s : all) benchmark::DoNotOptimize(fe::compose(s.value_1, s.value_2, s));
  report(state);
}

BENCHMARK(space_to_axes);
BENCHMARK(space_from_axes);
BENCHMARK(section_to_axes);
BENCHMARK(section_from_axes);

} // namespace
