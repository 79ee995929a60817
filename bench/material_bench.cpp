// What a material point costs, one thread, ns a point: the update in principal axes with its tangent, for
// points that flow and points that do not. The states lie on the yield surface at random densities and Lode
// angles, the increments are log-uniform between 1e-4 and 1e-2 (a press takes steps of that size).

#include "material/update.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace platen;

// Edmans & Sinka, Table 6, and the shear, compaction and tension they allow.
const material::Vmdc base_case{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5};
const material::VonMises von_mises{15e9, 0.3, 150e6};

struct Points {
  std::vector<std::array<double, 3>> eps;
  std::vector<double> phi;
  std::vector<material::PointUpdate> updates;
};

constexpr double p_max = 5e8; // where a surface is a line without end

/// Random points of which all flow, or none; of VMDC, all in one zone.
template <class Model>
Points points(const Model& model, material::Zone zone, double phi_min, double phi_max) {
  constexpr std::size_t count = 4096;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  Points all;
  while (all.eps.size() < count) {
    const double phi = phi_min + (phi_max - phi_min) * unit(random);
    const auto surface = model.surface(phi);
    const auto moduli = model.moduli(phi);
    const double s_min = std::max(surface.s_min(), -p_max), s_max = std::min(surface.s_max(), p_max);
    const auto f = surface.at(s_min + (s_max - s_min) * unit(random));
    const double lode = 2 * std::numbers::pi * unit(random),
                 inside = zone == material::Zone::elastic ? 0.5 : 1;
    const double size = std::pow(10, -4 + 2 * unit(random));
    std::array<double, 3> eps;
    for (int A = 0; A < 3; ++A)
      eps[A] = inside * (f.p / (3 * moduli.K) +
                         f.q / (3 * moduli.G) * std::cos(lode + 2 * std::numbers::pi / 3 * A)) +
               (zone == material::Zone::elastic ? 1e-3 * size : size) * sign(random);
    material::PointUpdate u;
    (void)material::update(model, {&eps, 1}, {&phi, 1}, {&u, 1});
    if (u.zone != zone || u.status == material::Status::refused) continue;
    all.eps.push_back(eps);
    all.phi.push_back(phi);
  }
  all.updates.resize(count);
  return all;
}

template <class Model>
void update(benchmark::State& state, const Model& model, material::Zone zone, double phi_min,
            double phi_max) {
  Points p = points(model, zone, phi_min, phi_max);
  const material::Model any = model;
  for (auto _ : state) {
    benchmark::DoNotOptimize(material::update(any, p.eps, p.phi, p.updates));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(p.eps.size()));
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(p.eps.size()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

using material::Zone;
BENCHMARK_CAPTURE(update, vmdc_compaction, base_case, Zone::compaction, -0.2, 0.3);
BENCHMARK_CAPTURE(update, vmdc_shear, base_case, Zone::shear, -0.2, 0.3);
BENCHMARK_CAPTURE(update, vmdc_tension, base_case, Zone::tension, -0.2, 0.3);
BENCHMARK_CAPTURE(update, vmdc_elastic, base_case, Zone::elastic, -0.2, 0.3);
BENCHMARK_CAPTURE(update, vmdc_elastic_virgin, base_case, Zone::elastic, 0.0, 0.0);
BENCHMARK_CAPTURE(update, von_mises_plastic, von_mises, Zone::shear, 0.0, 0.3);
BENCHMARK_CAPTURE(update, von_mises_elastic, von_mises, Zone::elastic, 0.0, 0.3);

} // namespace
