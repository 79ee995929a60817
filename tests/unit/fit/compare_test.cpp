#include "fit/compare.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace platen;

const char* const metal = "radius_m=1e-3 E_Pa=1e9 nu=0.3 p_y_Pa=2e7 against=plane";

law::Law thornton_ning() { return law::make_law("thornton-ning", "", law::parameter_texts(metal)); }

/// What a press would write if the law were true: loading, and unloading from `tops` (delta/R).
press::Curve curve_of(const law::Law& law, double R, double scale, std::initializer_list<double> tops) {
  press::Curve curve;
  curve.radius_m = R * scale;
  const auto add = [&](press::Branch branch, int id, double delta, const law::Response& r) {
    press::CurvePoint p;
    p.branch = branch;
    p.branch_id = id;
    p.delta_m = delta * scale;
    p.force_N = r.force * scale * scale;
    p.contact_radius_m = r.contact_radius * scale;
    curve.points.push_back(p);
  };
  for (int i = 1; i <= 2000; ++i) {
    const double delta = 0.1 * R * i / 2000;
    add(press::Branch::loading, 0, delta, law::evaluate(law, {}, delta));
  }
  int id = 0;
  for (double top : tops) {
    const law::State state = law::evaluate(law, {}, top * R).state;
    ++id;
    for (int i = 1; i <= 4000; ++i) {
      const double delta = top * R * (1 - i / 4000.0);
      const law::Response r = law::evaluate(law, state, delta);
      add(press::Branch::unloading, id, delta, r);
      if (r.force == 0) break;
    }
  }
  return curve;
}

TEST(Compare, ALawThatIsTheCurveDeviatesByNothing) {
  const auto law = thornton_ning();
  const auto reference = fit::reference_of(curve_of(law, 1e-3, 1, {0.02, 0.1}), "press");
  ASSERT_EQ(reference.turning.size(), 2u);
  const auto d = fit::deviations(reference, {fit::trace_of(law, reference, "law")}, 0, 0.1).front();
  EXPECT_LT(d.force, 1e-9);
  EXPECT_LT(d.radius, 1e-9);
  EXPECT_LT(d.stiffness, 1e-9);
  EXPECT_LT(d.lost_work, 1e-3); // the curve is integrated by trapezoids
  EXPECT_EQ(d.rank, 1);
}

TEST(Compare, WorkLostIsNoShareOfALoadingThatTookNone) {
  auto curve = curve_of(thornton_ning(), 1e-3, 1, {0.1});
  for (auto& p : curve.points)
    if (p.branch == press::Branch::loading && p.delta_m < 0.0999e-3) p.force_N *= -1;
  EXPECT_TRUE(fit::reference_of(curve, "press").turning.empty());
}

TEST(Compare, ADeviationOfTenPerCentIsTenPerCentAndRanksBehind) {
  const auto law = thornton_ning();
  auto near = curve_of(law, 1e-3, 1, {0.05}), far = near;
  for (auto& p : near.points) p.force_N *= 1.1;
  for (auto& p : far.points) p.force_N *= 0.7;
  const auto reference = fit::reference_of(curve_of(law, 1e-3, 1, {0.05}), "press");
  const auto d = fit::deviations(
      reference, {fit::trace_of(far, reference, "far"), fit::trace_of(near, reference, "near")}, 0.01, 0.1);
  EXPECT_NEAR(d[0].force, 0.3, 1e-9);
  EXPECT_NEAR(d[1].force, 0.1, 1e-9);
  EXPECT_NEAR(d[1].stiffness, 0.1, 1e-9);
  EXPECT_NEAR(d[1].lost_work, 0.1 * reference.trace.lost_work[0] / reference.spent[0], 1e-9);
  EXPECT_EQ(d[0].rank, 2);
  EXPECT_EQ(d[1].rank, 1);
}

TEST(Compare, ACurveOfAnotherRadiusIsComparedInItsOwnRadius) {
  const auto law = thornton_ning();
  const auto reference = fit::reference_of(curve_of(law, 1e-3, 1, {0.05}), "press");
  const auto d =
      fit::deviations(reference, {fit::trace_of(curve_of(law, 1e-3, 7, {0.05}), reference, "seven times")}, 0,
                      0.1)
          .front();
  EXPECT_LT(d.force, 1e-9);
  EXPECT_LT(d.lost_work, 1e-9);
}

TEST(Compare, SaysNothingWhereThereIsNothing) {
  const auto law = thornton_ning();
  auto part = curve_of(law, 1e-3, 1, {});
  part.points.resize(500); // to delta/R = 0.025
  const auto reference = fit::reference_of(curve_of(law, 1e-3, 1, {}), "press");
  const auto trace = fit::trace_of(part, reference, "half");
  const auto d = fit::deviations(reference, {trace, fit::trace_of(law, reference, "law")}, 0.05, 0.1);
  EXPECT_TRUE(std::isnan(d[0].force));
  EXPECT_EQ(d[0].rank, 0);
  EXPECT_EQ(d[1].rank, 1);
  EXPECT_TRUE(std::isnan(d[1].lost_work));
  EXPECT_EQ(d[1].in_range, 0); // the law holds to 0.01
  part.points.resize(5);
  EXPECT_THROW(fit::reference_of(part, "press"), core::InvalidInput);
}

} // namespace
