// Whether pressing what `platen study refine` asks for helps: the grid of Edmans & Sinka alone says granules
// inside of its cells badly; 60 of these were pressed (edmans-sinka-between), and 30 others tell how far off
// curves are.

#include "surrogate/refine.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

TEST(Refine, HelpsWhereItIsAsked) {
  const auto grid = read_pool_data(pools / "edmans-sinka"),
             between = read_pool_data(pools / "edmans-sinka-between"),
             fresh = read_pool_data(pools / "fresh-edmans-sinka", Take::all);
  const auto s = fit_surrogate({grid});
  std::vector<Description> candidates;
  for (const auto& run : between.runs) candidates.push_back(run.description);
  const auto refined = refine(s, candidates, 1e-4, 15);
  ASSERT_EQ(refined.chosen.size(), 15U);
  auto more = grid, by_chance = grid;
  for (const std::size_t i : refined.chosen) more.runs.push_back(between.runs[i]);
  by_chance.runs.insert(by_chance.runs.end(), between.runs.begin(), between.runs.begin() + 15);
  const auto off = [&](const PoolData& data) {
    const auto made = fit_surrogate({data});
    const auto e = summary_of(errors_beside(made, fresh), made.band).force;
    std::printf("  %zu materials: median %.2f %%, 95 %% %.2f %%, worst %.2f %%\n", data.runs.size(),
                100 * e.median, 100 * e.p95, 100 * e.worst);
    return e;
  };
  const auto before = off(grid), after = off(more), other = off(by_chance);
  EXPECT_LT(after.median, 0.6 * before.median);
  EXPECT_LT(after.p95, 0.7 * before.p95);
  EXPECT_LT(after.median, 1.3 * other.median); // fifteen that fill the ranges are as good
}

} // namespace
} // namespace platen::surrogate
