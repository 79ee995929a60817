// What docs/explanation/dissimilar-spheres.md derives, and where springs in series would go wrong.
#include "platen/law/agarwal.hpp"
#include "platen/law/hertz.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/wang.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen::law;

TEST(Pair, OfSizesThatNoNumberHoldsIsRefused) {
  for (const double R : {1e-110, 1e120, 0.0}) {
    EXPECT_THROW((void)make_pair(sphere(R, 1e9, 0.3), sphere(R, 1e9, 0.3)), BadParameter) << R;
    EXPECT_THROW((void)make_pair(sphere(R, 1e9, 0.3), rigid_plane()), BadParameter) << R;
  }
  EXPECT_NO_THROW((void)make_pair(sphere(1e-30, 1e9, 0.3), rigid_plane()));
}

TEST(DissimilarBodies, EqualSpheresAndPlaneHaveTheSphereItself) {
  const double R = 3e-3;
  const Pair equal = make_pair(sphere(R, 1e9, 0.3), sphere(R, 1e9, 0.3)),
             wall = make_pair(sphere(R, 1e9, 0.3), rigid_plane());
  EXPECT_NEAR(equal.R_e, R, 1e-17);
  EXPECT_NEAR(wall.R_e, R, 1e-17);
  EXPECT_NEAR(equal.x_per_gamma, 1 / (2 * R), 1e-12);
  EXPECT_NEAR(wall.x_per_gamma, 1 / R, 1e-12);
  EXPECT_NEAR(equal.sharing(), 2, 1e-14);
  EXPECT_NEAR(wall.sharing(), 1, 1e-14);
}

TEST(DissimilarBodies, PlaneOfTheSameMaterialTakesHalfTheForceOfARigidOneWhileElastic) {
  const AgarwalMaterial metal{500e6, 0.3, 1e6};
  const WangMaterial rock{10e9, 0.15, 25, 15e6, WangVariant::generic, 1, 1.5};
  const double R = 1e-3;
  const auto soft = prepare(metal, R, metal, infinity), hard = prepare_on_rigid_plane(metal, R);
  const double gamma = 0.5 * hard.gamma_elastic;
  EXPECT_NEAR(soft.loading(gamma).F / hard.loading(gamma).F, 0.5, 1e-12);
  const auto soft_rock = prepare(rock, R, rock, infinity), hard_rock = prepare_on_rigid_plane(rock, R);
  const double g = 0.5 * hard_rock.gamma_y;
  EXPECT_NEAR(soft_rock.loading(g).F / hard_rock.loading(g).F, 0.5, 1e-10);
}

TEST(DissimilarBodies, ShahinSharesStrengthAsTheSimilaritySolution) {
  // At small overlap the two laws differ by constants of x alone, so their ratio is that of the equal pair.
  const double inverse_m = 0.4, R1 = 1e-3, R2 = 5e-3;
  const ShahinMaterial a{200e9, 0.3, 50e6, inverse_m}, b{200e9, 0.3, 80e6, inverse_m};
  const SimilarityMaterial c{200e9, 0.3, 50e6, inverse_m}, d{200e9, 0.3, 80e6, inverse_m};
  const auto shahin = prepare(a, R1, b, R2), shahin_equal = prepare(a, R1);
  const auto similarity = prepare(c, R1, d, R2), similarity_equal = prepare(c, R1);
  const double x = 1e-5;
  const auto ratio = [x](const auto& one, const auto& two) {
    return one.loading(x / one.pair.x_per_gamma).F / two.loading(x / two.pair.x_per_gamma).F;
  };
  EXPECT_NEAR(ratio(shahin, similarity) / ratio(shahin_equal, similarity_equal), 1, 1e-9);
}

TEST(DissimilarBodies, UnloadingAddsTheCompliancesOfBothSides) {
  const Body small = sphere(1e-3, 1e9, 0.3), big = sphere(4e-3, 3e9, 0.2);
  const double a = 2e-4;
  const double S1 = make_pair(small, rigid_plane()).unloading_slope(a),
               S2 = make_pair(big, rigid_plane()).unloading_slope(a);
  EXPECT_NEAR(make_pair(small, big).unloading_slope(a), 1 / (1 / S1 + 1 / S2), 1e-9 * S1);
}

} // namespace
