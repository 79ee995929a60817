#include "surrogate/refine.hpp"

#include "surrogate/assess.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

Description metal(double E_bar) {
  return describe(material::VonMises{E_bar * 1e6, 0.3, 1e6, material::PerfectlyPlastic{}});
}

/// Perfectly plastic metals, but those of E/sigma_y from 40 to 300.
PoolData with_a_gap() {
  auto data = read_pool_data(pools / "von-mises");
  std::erase_if(data.runs, [](const Pressed& run) {
    const double E_bar = run.description.numbers[0].value;
    return E_bar > 40 && E_bar < 300;
  });
  return data;
}

std::vector<Description> candidates() {
  std::vector<Description> all;
  for (double E_bar = 5; E_bar < 1900; E_bar *= 1.15) all.push_back(metal(E_bar));
  return all;
}

TEST(Refine, GoesWhereNothingWasPressed) {
  const auto s = fit_surrogate({with_a_gap()});
  const auto all = candidates();
  const auto refined = refine(s, all, 1e-5, 3);
  ASSERT_EQ(refined.chosen.size(), 3U);
  ASSERT_EQ(refined.largest.size(), 4U);
  const double first = all[refined.chosen[0]].numbers[0].value;
  EXPECT_GT(first, 40);
  EXPECT_LT(first, 300);
  EXPECT_TRUE(std::is_sorted(refined.largest.rbegin(), refined.largest.rend()));
  EXPECT_LT(refined.largest.back(), 0.5 * refined.largest.front());
}

// What it expects to be left is what a surrogate of these lengths says once the first was pressed.
TEST(Refine, KnowsWhatAPressWillLeave) {
  auto s = fit_surrogate({with_a_gap()});
  const auto all = candidates();
  const auto refined = refine(s, all, 1e-5, 1);
  auto& layer = s.layers[0];
  const auto at = input_of(s, all[refined.chosen[0]].coordinates);
  layer.inputs.values.insert(layer.inputs.values.end(), at.begin(), at.end());
  layer.columns = layer.inputs;
  for (auto* components : {&layer.force, &layer.radius, &layer.work, &layer.exponent})
    for (auto& p : components->processes) p.weights.push_back(0); // whatever it says
  double largest = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i != refined.chosen[0]) largest = std::max(largest, predict(s, all[i]).expected.back());
  EXPECT_NEAR(largest, refined.largest.back(), 1e-3 * largest);
}

TEST(Refine, ChoosesNothingWhereTheTargetIsMet) {
  const auto s = read_surrogate(pools / "von-mises/surrogate.txt");
  EXPECT_TRUE(refine(s, candidates(), 0.02, 10).chosen.empty());
}

} // namespace
} // namespace platen::surrogate
