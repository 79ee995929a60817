// What docs/explanation/predict.md claims of 30 powders drawn after the fit, each pressed on few elements
// first.

#include "surrogate/surrogate.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

TEST(Surrogate, SaysAllFreshPowders) {
  const auto s = read_surrogate(pools / "powders/surrogate.txt");
  const auto fresh = read_pool_data(pools / "fresh-powders", Take::all);
  ASSERT_EQ(fresh.runs.size(), 30U);
  const auto guided = summary_of(errors_beside(s, fresh, true), s.guide->band);
  EXPECT_LE(guided.locked, 9);
  EXPECT_LT(guided.force.median, 0.007);
  EXPECT_LT(guided.force.p95, 0.02);
  EXPECT_LT(guided.force.worst, 0.03);
  EXPECT_LT(guided.radius.p95, 0.015);
  EXPECT_LT(guided.work.median, 0.01);
  EXPECT_LT(guided.work.p95, 0.04);
  EXPECT_GT(guided.coverage, 0.85);
  EXPECT_LT(guided.coverage, 0.95);
}

} // namespace
} // namespace platen::surrogate
