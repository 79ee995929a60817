// What docs/explanation/predict.md claims of the surrogates of the catalogue, asked of its pools again.

#include "surrogate/assess.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

/// The errors of the pool's materials, each left out, with the lengths that the file has.
LeaveOneOut figures(const char* pool, const std::vector<const char*>& with = {}) {
  const auto s = read_surrogate(pools / pool / "surrogate.txt");
  auto data = read_pool_data(pools / pool);
  for (const char* other : with) append(data, read_pool_data(pools / other));
  return summary_of(leave_out(s, {data}), s.band);
}

/// How well a surrogate says materials that it was not made of.
LeaveOneOut beside(const char* pool, const char* fresh) {
  const auto s = read_surrogate(pools / pool / "surrogate.txt");
  return summary_of(errors_beside(s, read_pool_data(pools / fresh, Take::all)), s.band);
}

void expect_same(const LeaveOneOut& again, const LeaveOneOut& file) {
  EXPECT_NEAR(again.force.median, file.force.median, 1e-6);
  EXPECT_NEAR(again.force.worst, file.force.worst, 1e-5);
  EXPECT_NEAR(again.work.p95, file.work.p95, 1e-4);
}

TEST(LeaveOneOut, OfTheGranulesOfEdmansAndSinka) {
  const auto e = figures("edmans-sinka", {"edmans-sinka-between"});
  EXPECT_LT(e.force.median, 0.004);
  EXPECT_LT(e.force.p95, 0.02);
  EXPECT_LT(e.force.worst, 0.03);
  EXPECT_LT(e.radius.median, 0.004);
  EXPECT_LT(e.radius.p95, 0.006);
  EXPECT_LT(e.work.median, 0.006);
  EXPECT_LT(e.work.p95, 0.025);
  EXPECT_LT(e.residual.p95, 0.01);
  expect_same(e, read_surrogate(pools / "edmans-sinka/surrogate.txt").left_out);
}

TEST(LeaveOneOut, OfPerfectlyPlasticMetals) {
  const auto e = figures("von-mises", {"von-mises-between", "von-mises-edges"});
  EXPECT_LT(e.force.median, 0.001);
  EXPECT_LT(e.force.p95, 0.002);
  EXPECT_LT(e.force.worst, 0.005);
  EXPECT_LT(e.radius.worst, 0.005);
  EXPECT_LT(e.work.p95, 0.006);
  expect_same(e, read_surrogate(pools / "von-mises/surrogate.txt").left_out);
}

TEST(LeaveOneOut, OfMetalsThatHarden) {
  const auto e = figures("metals");
  EXPECT_LT(e.force.median, 0.003);
  EXPECT_LT(e.force.p95, 0.01);
  EXPECT_LT(e.radius.p95, 0.006);
  EXPECT_LT(e.work.p95, 0.02);
  expect_same(e, read_surrogate(pools / "metals/surrogate.txt").left_out);
}

TEST(LeaveOneOut, OfElasticSpheres) {
  const auto e = figures("elastic");
  EXPECT_LT(e.force.worst, 0.005);
  EXPECT_LT(e.radius.worst, 0.005);
}

TEST(LeaveOneOut, OfPowders) {
  const auto s = read_surrogate(pools / "powders/surrogate.txt");
  const auto fine = read_pool_data(pools / "powders"), coarse = read_pool_data(pools / "powders-coarse");
  const auto quick = summary_of(leave_out(s, {fine, &coarse}), s.band);
  EXPECT_LT(quick.force.median, 0.025);
  EXPECT_LT(quick.radius.median, 0.01);
  EXPECT_LT(quick.work.median, 0.033);
  EXPECT_LT(quick.work.p95, 0.19);
  expect_same(quick, s.left_out);
  const auto guided = summary_of(leave_out_guided(s, {fine, &coarse}), s.guide->band);
  EXPECT_LT(guided.force.median, 0.005);
  EXPECT_LT(guided.force.p95, 0.02);
  EXPECT_LT(guided.radius.p95, 0.01);
  EXPECT_LT(guided.work.median, 0.008);
  EXPECT_LT(guided.work.p95, 0.04);
  EXPECT_LT(guided.residual.p95, 0.01);
  expect_same(guided, s.guide->left_out);
}

// The powders of Edmans & Sinka, Table 4, and their base case, none of them in the pool.
TEST(Surrogate, SaysPublishedPowders) {
  const auto s = read_surrogate(pools / "powders/surrogate.txt");
  const auto published = read_pool_data(pools / "published-powders", Take::all);
  const auto quick = errors_beside(s, published), guided = errors_beside(s, published, true);
  ASSERT_EQ(guided.size(), 8U);
  for (std::size_t i = 0; i < guided.size(); ++i) {
    const auto& name = published.runs[i].material.name;
    EXPECT_EQ(guided[i].locks, name == "Dical Emcompress") << name;
    if (guided[i].locks) continue;
    EXPECT_LT(guided[i].force, 0.015) << name;
    EXPECT_LT(guided[i].radius, 0.015) << name;
    EXPECT_LT(quick[i].force, 0.1) << name;
  }
  const auto summary = summary_of(guided, s.guide->band);
  EXPECT_LT(summary.force.median, 0.007);
  EXPECT_GT(summary.coverage, 0.85);
}

// Between those that were pressed, by another seed.
TEST(Surrogate, SaysFreshGranulesAndMetals) {
  const auto granules = beside("edmans-sinka", "fresh-edmans-sinka");
  ASSERT_EQ(granules.materials, 30);
  EXPECT_LT(granules.force.median, 0.006);
  EXPECT_LT(granules.force.p95, 0.02);
  EXPECT_LT(granules.radius.p95, 0.01);
  EXPECT_GT(granules.coverage, 0.85);
  const auto metals = beside("von-mises", "fresh-von-mises");
  ASSERT_EQ(metals.materials, 30);
  EXPECT_LT(metals.force.median, 0.0015);
  EXPECT_LT(metals.force.worst, 0.003);
  EXPECT_LT(metals.radius.worst, 0.004);
  EXPECT_LT(metals.work.p95, 0.006);
  EXPECT_GT(metals.coverage, 0.85);
  const auto hardening = beside("metals", "fresh-metals");
  ASSERT_EQ(hardening.materials, 30);
  EXPECT_LT(hardening.force.median, 0.002);
  EXPECT_LT(hardening.force.worst, 0.007);
  EXPECT_LT(hardening.radius.worst, 0.007);
  EXPECT_LT(hardening.work.p95, 0.015);
  EXPECT_GT(hardening.coverage, 0.85);
  const auto elastic = beside("elastic", "fresh-elastic");
  ASSERT_EQ(elastic.materials, 30);
  EXPECT_LT(elastic.force.worst, 0.001);
  EXPECT_LT(elastic.radius.worst, 0.004);
  EXPECT_LT(elastic.work.worst, 0.015);
}

// Drawn at random from the same box, by another seed. Each third is pressed coarsely; all of them: the slow
// test.
TEST(Surrogate, SaysFreshPowders) {
  const auto s = read_surrogate(pools / "powders/surrogate.txt");
  auto fresh = read_pool_data(pools / "fresh-powders", Take::all);
  ASSERT_EQ(fresh.runs.size(), 30U);
  const auto quick = summary_of(errors_beside(s, fresh), s.band);
  EXPECT_LE(quick.locked, 9);
  EXPECT_LT(quick.force.median, 0.03);
  EXPECT_GT(quick.coverage, 0.85);
  for (std::size_t i = 1; i < 10; ++i) fresh.runs[i] = std::move(fresh.runs[3 * i]);
  fresh.runs.erase(fresh.runs.begin() + 10, fresh.runs.end());
  const auto guided = summary_of(errors_beside(s, fresh, true), s.guide->band);
  EXPECT_LE(guided.locked, 3);
  EXPECT_LT(guided.force.median, 0.007);
  EXPECT_LT(guided.force.worst, 0.03);
  EXPECT_LT(guided.radius.p95, 0.015);
}

// Metals of E/sigma_y = 30 and 300 at nu = 0, 0.2, 0.4.
TEST(Surrogate, SaysMetalsOfOtherPoissonsRatios) {
  const auto s = read_surrogate(pools / "von-mises/surrogate.txt");
  const auto other = read_pool_data(pools / "von-mises-nu");
  const auto errors = errors_beside(s, other);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double nu = other.runs[i].description.numbers[1].value;
    EXPECT_LT(errors[i].force, 0.003) << nu;
    EXPECT_LT(errors[i].radius, 0.003) << nu;
    for (const double work : errors[i].work) EXPECT_LT(work, 0.01) << nu;
  }
}

} // namespace
} // namespace platen::surrogate
