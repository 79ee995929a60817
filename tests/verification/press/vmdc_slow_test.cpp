// Compressible particles in the simple press: they run with the defaults, balance energy, and do not depend
// on the size of steps and elements.

#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

namespace {

const material::Material base_case{
    // ES Table 6
    "base case", material::Vmdc{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}};
const material::Material mcc_ph_200{
    // ES Table 4, rho_r0 = 0.4
    "MCC PH-200", material::Vmdc{0.4, 8.61e6, 51.3 * 8.61e6, 0.1472, 1.351 * 8.61e6, 0.0995 * 8.61e6, 0.147,
                                 6.11, 5.25, 5.43, 6.28, 0.443, 2.007}};
const material::Material metal{"von Mises", material::VonMises{100e6, 0.3, 1e6}};

press::Result pressed(const material::Material& material, int elements = press::Simple{}.elements,
                      double step_max = 0.005) {
  press::Simple e;
  e.elements = elements;
  e.step_max = step_max;
  e.fields_at = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5};
  press::Result result = press::press({material, 1e-3, e});
  EXPECT_FALSE(result.failure) << *result.failure;
  return result;
}

double F_bar(const press::Result& result, double delta_bar) {
  for (const auto& row : result.curve.points)
    if (row.branch_id == 0 && std::abs(row.delta_bar - delta_bar) < 1e-12) return row.F_bar;
  ADD_FAILURE() << "no row at " << delta_bar;
  return NAN;
}

void expect_energy_balance(const press::Result& result) {
  double worst = 0;
  for (const auto& row : result.curve.points)
    if (row.delta_bar >= 0.02)
      worst = std::max(worst, std::abs(row.work_J - row.stored_J - row.dissipated_J) / row.work_J);
  std::printf("%s: work less stored less dissipated within %.2f %%\n", result.curve.material.c_str(),
              100 * worst);
  EXPECT_LT(worst, 0.003);
}

} // namespace

TEST(SimplePress, RunsCompressibleMaterialsWithOneSetOfDefaults) {
  for (const auto& material : {base_case, mcc_ph_200}) {
    const press::Result result = pressed(material);
    ASSERT_FALSE(result.curve.points.empty());
    EXPECT_EQ(result.curve.points.back().delta_bar, 0.5);
    EXPECT_LT(result.statistics.local_continuations,
              1e-3 * result.statistics.iterations * result.statistics.elements);
    expect_energy_balance(result);
  }
}

TEST(SimplePress, BalancesEnergyOfAMetal) { expect_energy_balance(pressed(metal)); }

TEST(SimplePress, DependsOnTheStepByLessThanHalfAPercent) {
  // 200 against 465 steps for a metal, 160 against 465 for a softening granule: the flow is of second order
  // in the step. (Of first order, as before, the granule was 1.2 % too soft at 0.5.)
  for (const auto& [material, step_max] : {std::pair{metal, 0.005}, {base_case, 0.02}}) {
    const auto coarse = pressed(material, 2500, step_max), fine = pressed(material, 2500, 0.00125);
    double worst = 0;
    for (const double delta_bar : {0.1, 0.2, 0.3, 0.4, 0.5})
      worst = std::max(worst, std::abs(F_bar(coarse, delta_bar) / F_bar(fine, delta_bar) - 1));
    std::printf("%s: %d against %d steps: force within %.2f %%\n", material.name.c_str(),
                coarse.statistics.steps, fine.statistics.steps, 100 * worst);
    EXPECT_LT(worst, 0.005) << material.name;
  }
}

TEST(SimplePress, ConvergesForASofteningCompressibleSphere) {
  // Half the volume dilates and softens around delta_bar = 0.1: refinement must not localise it.
  const auto coarse = pressed(base_case, 2500), middle = pressed(base_case, 5000),
             fine = pressed(base_case, 10000);
  for (const double delta_bar : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const double f = F_bar(fine, delta_bar);
    std::printf("delta_bar %.2f: F_bar %.4f, 2,500 elements %+.2f %%, 5,000 elements %+.2f %%\n", delta_bar,
                f, 100 * (F_bar(coarse, delta_bar) / f - 1), 100 * (F_bar(middle, delta_bar) / f - 1));
    EXPECT_NEAR(F_bar(middle, delta_bar) / f, 1, 0.02) << delta_bar;
  }
}
