// Known parameters come back from noisy measurements, and no broken particle is taken for a whole one.

#include "recovery.hpp"

namespace {

using namespace platen;

TEST(Recovery, OfTwentyGranules) {
  const auto tally = synthetic::repeat(synthetic::granule, 3, 1);
  EXPECT_LT(tally.worst.at("kappa_Pa"), 0.03);
  EXPECT_LT(tally.worst.at("inverse_m"), 0.03);
  EXPECT_LT(tally.worst.at("E_Pa"), 0.05);
  EXPECT_LT(tally.mean_contact, 0.002);
}

TEST(Recovery, OfTwentyElasticPlasticParticles) {
  const auto tally = synthetic::repeat(synthetic::metal, 3, 2);
  EXPECT_LT(tally.worst.at("sigma_y_Pa"), 0.05);
  EXPECT_LT(tally.worst.at("E_Pa"), 0.05);
  EXPECT_LT(tally.mean_contact, 0.002);
}

TEST(Recovery, BrokenParticlesAreFoundAndWholeOnesAreNot) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> where(0.25, 0.95), diameter(0.6e-3, 1.4e-3);
  for (int i = 0; i < 200; ++i) {
    const auto& truth = i % 2 ? synthetic::granule : synthetic::metal;
    const double d = diameter(random), at = where(random);
    const auto whole = measure::stages_of(synthetic::measured(truth, d, 20e-6, 0.2, 0, random).specimen);
    EXPECT_FALSE(whole.broke) << i;
    EXPECT_EQ(whole.loops, 2) << i;
    EXPECT_TRUE(measure::stages_of(synthetic::measured(truth, d, 20e-6, 0.2, 0, random, at).specimen).broke)
        << i << ": broken at " << at;
  }
}

} // namespace
