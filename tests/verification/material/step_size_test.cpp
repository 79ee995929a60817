// Edmans & Sinka's claim that moduli solved for with the step converge better than moduli updated after it.
// The reference is their scheme in 10,000 steps; the table and the figure are in
// docs/explanation/step-size.md.

#include "material/card.hpp"
#include "material/point.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen::material;

namespace {

/// Compaction by `compacted` of volume in n steps, then n steps of `step` each.
MaterialPoint walk(const Model& model, double compacted, const std::array<double, 3>& strain, int n,
                   ModuliScheme scheme) {
  MaterialPoint point;
  const double third = -compacted / 3 / n;
  if (compacted > 0)
    for (int i = 0; i < n; ++i) point = strained(model, point, {third, third, third}, scheme);
  for (int i = 0; i < n; ++i)
    point = strained(model, point, {strain[0] / n, strain[1] / n, strain[2] / n}, scheme);
  return point;
}

/// Distance of the principal stresses over the size of the reference.
double error(const MaterialPoint& point, const MaterialPoint& reference) {
  double gap = 0, size = 0;
  for (int A = 0; A < 3; ++A) {
    gap += std::pow(point.last.sigma[A] - reference.last.sigma[A], 2);
    size += std::pow(reference.last.sigma[A], 2);
  }
  return std::sqrt(gap / size);
}

struct Study {
  double order_implicit, order_after; ///< between 20 and 160 steps
  double ratio;                       ///< of the errors at 20 steps
};

Study study(const char* card, double compacted, const std::array<double, 3>& strain) {
  const Model model = read_card(card).material.model;
  const auto reference = walk(model, compacted, strain, 10000, ModuliScheme::implicit);
  const auto at = [&](int n, ModuliScheme scheme) {
    return error(walk(model, compacted, strain, n, scheme), reference);
  };
  const double i20 = at(20, ModuliScheme::implicit), i160 = at(160, ModuliScheme::implicit);
  const double a20 = at(20, ModuliScheme::after_step), a160 = at(160, ModuliScheme::after_step);
  return {std::log2(i20 / i160) / 3, std::log2(a20 / a160) / 3, a20 / i20};
}

} // namespace

TEST(StepSize, BothSchemesAreOfFirstOrderInUniaxialStrainAndTheImplicitOneIsFarCloser) {
  for (const char* card : {"base-case", "mcc-ph-200", "lactose-dt"}) {
    const Study s = study(card, 0, {-0.3, 0, 0});
    EXPECT_NEAR(s.order_implicit, 1, 0.05) << card;
    EXPECT_NEAR(s.order_after, 1, 0.05) << card;
    EXPECT_GT(s.ratio, 15) << card;
  }
}

TEST(StepSize, ShearAfterCompactionGainsLittle) {
  // Shear brings the density, and with it the moduli, to rest: what is late then matters less.
  const Study s = study("base-case", 0.15, {0.02, -0.02, 0});
  std::printf("shear after compaction: orders %.2f and %.2f, ratio of errors at 20 steps %.2f\n",
              s.order_implicit, s.order_after, s.ratio);
  EXPECT_GT(s.ratio, 1);
}
