// Ways to predict the granules of Edmans & Sinka's design, side by side: the table of
// docs/explanation/surrogate.md, which `platen study methods` prints.

#include "surrogate/methods.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path pools = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools";

Method named(const std::vector<Method>& methods, const std::string& name) {
  for (const auto& m : methods)
    if (m.name == name) return m;
  ADD_FAILURE() << name;
  return {};
}

TEST(Methods, OfEdmansAndSinkaSideBySide) {
  auto data = read_pool_data(pools / "edmans-sinka");
  append(data, read_pool_data(pools / "edmans-sinka-between"));
  const auto m = methods_side_by_side(read_surrogate(pools / "edmans-sinka/surrogate.txt"), data);
  const auto force = [&](const char* name) { return named(m.loading, name).force; };
  EXPECT_GT(force("(A.1) to (A.3) as printed").median, 0.6);
  EXPECT_NEAR(force("(A.1) to (A.3), two misprints mended").median, 0.106, 0.01);
  EXPECT_NEAR(force("(A.1) to (A.3), refitted").median, 0.102, 0.01);
  EXPECT_NEAR(force("k, delta_t, a by stepwise regression").median, 0.060, 0.006);
  EXPECT_NEAR(force("the form (6), fitted to each curve").median, 0.0194, 0.002);
  EXPECT_NEAR(force("natural neighbours of the curve").median, 0.0169, 0.002);
  EXPECT_LT(force("natural neighbours of the curve").p95, 0.07);
  EXPECT_LT(force("surrogate").median, 0.004);
  EXPECT_LT(force("surrogate").p95, 0.011);
  EXPECT_LT(force("surrogate").worst, 0.03);
  const auto work = [&](const char* name) { return named(m.unloading, name).work; };
  EXPECT_NEAR(work("closed form over delta_bar, E_bar/Gamma_bar").median, 0.035, 0.004);
  EXPECT_LT(work("closed form over delta_bar, E_bar/Gamma_bar").p95, 0.16);
  EXPECT_LT(work("the form (13), fitted to each branch").p95, 0.007);
  EXPECT_LT(work("natural neighbours of work and alpha").p95, 0.03);
  EXPECT_LT(work("surrogate").median, 0.003);
  EXPECT_LT(work("surrogate").p95, 0.012);
  ASSERT_EQ(m.forms.size(), 2U);
  for (const auto& form : m.forms) EXPECT_EQ(form.terms.size(), form.coefficients.size());
}

TEST(Methods, RefuseMetals) {
  const auto data = read_pool_data(pools / "von-mises");
  EXPECT_THROW(methods_side_by_side(read_surrogate(pools / "von-mises/surrogate.txt"), data),
               core::InvalidInput);
}

} // namespace
} // namespace platen::surrogate
