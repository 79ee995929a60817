// Intervals of 95 % hold the truth in 90 to 99 % of 200 repetitions.

#include "material_recovery.hpp"

namespace {

using namespace platen;

void expect_honest(const synthetic::Tally& tally, double worst) {
  for (const auto& [key, covered] : tally.covered) {
    const double share = static_cast<double>(covered) / tally.repetitions;
    EXPECT_GE(share, 0.90) << key;
    EXPECT_LE(share, 0.99) << key;
    EXPECT_LT(tally.worst.at(key), worst) << key;
  }
}

TEST(Coverage, OfGranules) { expect_honest(synthetic::repeat(synthetic::granule, 200, 4), 0.03); }
TEST(Coverage, OfElasticPlasticParticles) {
  expect_honest(synthetic::repeat(synthetic::metal, 200, 5), 0.05);
}

/// Of E and the yield stress of metals, and of a powder that twelve numbers describe.
TEST(Coverage, OfMaterials) {
  const calibrate::FreeMaterial metal("von-mises", {{"nu", "0.3"}}, {});
  expect_honest(synthetic::repeat_material(metal, synthetic::bead, 200, 6), 0.05);
}

} // namespace
