#include "platen/law/agarwal.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/wang.hpp"
#include "random_paths.hpp"

namespace {

using namespace platen::law;
using namespace platen::law::testing;

/// The share of [x_low, x_high], in logarithms, that the table serves beyond the elastic range; everything
/// that it gives is within 1e-4 of the formulas, and the loading curve has no jump where one cell meets the
/// next, or the formulas.
template <class Law> double served(const Law& law, double x_low, double x_high) {
  int from_table = 0, all = 0;
  x_low = std::max(x_low, 1.3 * law.gamma_elastic * law.pair.x_per_gamma); // Hertz needs no table
  for (double x = x_low; x < x_high; x *= 1.0037, ++all) {
    const double gamma = x / law.pair.x_per_gamma;
    Peak<double> fast;
    if (!law.peaks.at(gamma, fast)) continue;
    ++from_table;
    const Peak<double> exact = formula_peak(law, gamma);
    const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-4 * std::abs(b); };
    RC_ASSERT(close(fast.F, exact.F) && close(fast.a, exact.a) && close(fast.work, exact.work));
    RC_ASSERT(std::abs(fast.slope - exact.slope) <= 1e-3 * exact.slope);
    if (gamma <= law.gamma_elastic) continue; // unloading retraces
    RC_ASSERT(close(fast.end.rate, exact.end.rate) && close(fast.end.alpha, exact.end.alpha));
    RC_ASSERT(fast.end.rate * gamma >= 1 - 1e-15); // no force left at no overlap
  }
  const double octaves_up = std::ceil(std::log2(x_high / law.pair.x_per_gamma));
  for (int i = 0; i < 8 * 20; ++i) { // the edges of the cells, from the top
    const double edge = std::exp2(octaves_up - 1 - i / 8) * (1 + (7 - i % 8) / 8.0);
    const double below = evaluate(law, State{}, std::nextafter(edge, 0.0)).force;
    const double above = evaluate(law, State{}, edge).force;
    RC_ASSERT(std::abs(above - below) <= 1e-12 * above);
  }
  return double(from_table) / all;
}

TEST(PeakTable, FollowsTheFormulasOfEveryLaw) {
  double least = 1, sum = 0;
  int laws = 0;
  const auto count = [&](double share) { least = std::min(least, share), sum += share, ++laws; };
  for_random_cases(60, [&] {
    const double R = log_between(1e-5, 1e-1);
    EdmansSinkaMaterial es;
    es.sigma_ref = log_between(1e5, 1e9), es.E = es.sigma_ref * log_between(5, 500), es.nu = between(0, 0.45);
    es.k = between(3, 6), es.delta_t = between(0.05, 0.2), es.a = between(1, 5);
    count(served(prepare(es, R), 1e-3, 0.5));
    es.unloadings = 3;
    for (int i = 0; i < 3; ++i)
      es.unload_delta_bar[i] = 0.1 + 0.2 * i, es.alpha[i] = between(1.2, 1.8), es.beta[i] = between(1, 3);
    served(prepare(es, R), 1e-3, 0.5);

    const WangMaterial rock{between(10e9, 30e9), between(0.1, 0.3), between(20, 40), between(5e6, 50e6)};
    count(served(prepare(rock, R), 1e-6, 1e-3));
    const double sigma_y = log_between(1e6, 1e9);
    for (const LoadingCase loading : {LoadingCase::simple, LoadingCase::die, LoadingCase::hydrostatic}) {
      const AgarwalMaterial metal{sigma_y * log_between(120, 5000), 0.3, sigma_y, loading};
      count(served(prepare(metal, R), 1e-5, 0.13));
      const ShahinMaterial hardening{1e3 * sigma_y, 0.3, sigma_y, between(0, 1), loading};
      count(served(prepare(hardening, R), 1e-5, 0.13));
    }
  });
  RecordProperty("mean_share_served", std::to_string(sum / laws));
  RecordProperty("least_share_served", std::to_string(least));
  EXPECT_GT(sum / laws,
            0.95); // the least where Hertz ends late, and unloading is long near to creating energy
}

} // namespace
