#include "surrogate/sobol.hpp"

#include "core/error.hpp"
#include "material/card.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace platen::surrogate {
namespace {

// Ishigami & Homma (1990): f = sin x + 7 sin^2 y + 0.1 z^4 sin x on [-pi, pi]^3. Its indices in closed form:
// V = 49/8 + 0.1 pi^4/5
// + 0.01 pi^8/18 + 1/2, S = (1 + 0.1 pi^4/5)^2/2/V, 49/8/V, 0; T = S but for x and z, which share 8 pi^8
// 0.01/225/V.
TEST(Sobol, MeetsAFunctionOfWhichTheIndicesAreKnown) {
  constexpr double pi = std::numbers::pi;
  std::vector<SobolIndices> numbers(3, {"", -pi, pi, {}, {}});
  sobol_indices(
      [](const std::vector<double>& x) {
        return std::vector{std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) +
                           0.1 * std::pow(x[2], 4) * std::sin(x[0])};
      },
      numbers, 20000, 3);
  const double p4 = std::pow(pi, 4), V = 49.0 / 8 + 0.1 * p4 / 5 + 0.01 * p4 * p4 / 18 + 0.5,
               shared = 8 * p4 * p4 * 0.01 / 225 / V;
  const double alone[] = {std::pow(1 + 0.1 * p4 / 5, 2) / 2 / V, 49.0 / 8 / V, 0};
  const double total[] = {alone[0] + shared, alone[1], shared};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(numbers[i].alone[0], alone[i], 0.02) << i;
    EXPECT_NEAR(numbers[i].total[0], total[i], 0.02) << i;
  }
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

// Edmans & Sinka, 6.2: nu_0, xi_1 and xi have little influence on the response.
TEST(Sobol, PoissonsRatioAndGrowingStiffnessHardlyMatter) {
  for (const char* name : {"base-case", "mcc-ph-200"}) {
    const auto s = sobol_of_catalogue(material::read_card(name).material, 0.1);
    EXPECT_EQ(s.pool, "powders");
    for (const auto& n : s.numbers) {
      if (n.key == "nu" || n.key == "xi_1" || n.key == "xi") {
        EXPECT_LT(largest({n.total.begin(), n.total.begin() + 4}), 0.01)
            << name << " " << n.key; // force, work put in
      }
      if (n.key == "Gamma_bar") { EXPECT_GT(*std::min_element(n.total.begin(), n.total.end()), 0.4) << name; }
    }
  }
}

TEST(Sobol, RefusesMaterialsThatItCannotVary) {
  EXPECT_THROW(sobol_of_catalogue(material::read_card("lead-hollomon").material, 0.2), core::InvalidInput);
  EXPECT_THROW(sobol_of_catalogue(material::read_card("wang-type-1").material, 0.2), core::InvalidInput);
}

} // namespace
} // namespace platen::surrogate
