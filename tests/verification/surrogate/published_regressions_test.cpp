// The regressions that Edmans & Sinka publish (Appendix A), as printed and with two coefficients mended,
// beside the surrogate on the same pool: what is gained by interpolating curves instead of parameters.

#include "fit/samples.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "surrogate/surrogate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

struct Figures {
  double median, p95, worst;
};

/// Relative L2 of law (6) with the parameters of the regressions, over the materials for which they are
/// meant.
Figures of_appendix(const PoolData& data, law::Coefficients coefficients) {
  std::vector<double> errors;
  for (const auto& run : data.runs) {
    const double E_bar = run.description.numbers[1].value, Gamma_bar = run.description.numbers[3].value;
    if (E_bar < 4.5) continue;
    const auto p = law::edmans_sinka_appendix(Gamma_bar, E_bar, coefficients);
    std::vector<double> F_bar;
    for (const double x : data.knots)
      F_bar.push_back(x <= p.delta_t ? p.k * x : p.k * p.delta_t * std::exp(p.a * (x - p.delta_t)));
    errors.push_back(
        fit::errors({data.knots, run.F_bar, fit::trapezoid_weights(data.knots, 0)}, F_bar).relative_l2);
  }
  std::sort(errors.begin(), errors.end());
  const Figures f{errors[errors.size() / 2], errors[errors.size() * 95 / 100], errors.back()};
  std::printf("  %zu materials: median %.1f %%, 95 %% %.1f %%, worst %.1f %%\n", errors.size(),
              100 * f.median, 100 * f.p95, 100 * f.worst);
  return f;
}

TEST(PublishedRegressions, AreFurtherOffThanTheSurrogate) {
  const auto data = read_pool_data(pools / "edmans-sinka");
  const auto s = read_surrogate(pools / "edmans-sinka/surrogate.txt");
  const auto printed = of_appendix(data, law::Coefficients::printed);
  const auto mended = of_appendix(data, law::Coefficients::corrected);
  EXPECT_LT(mended.median, 0.5 * printed.median);
  EXPECT_LT(10 * s.left_out.force.median, mended.median);
}

} // namespace
} // namespace platen::surrogate
