// Surfaces end on the axis q = 0, or go on without end: a return may not use what lies behind an end, and may
// go as far as the pressure takes it where there is none.

#include "random_states.hpp"

#include <gtest/gtest.h>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

/// Whether Newton accepts the root of the trial of that deviator, which is negative for the mirror image.
template <class M> bool accepted(const M& m, double eps_v, double eps_q, double phi, double s) {
  const double unit = 1 / (3 * m.moduli(phi).G),
               rounding = relative_return_tolerance * (std::abs(eps_v) + std::abs(eps_q));
  detail::Return e;
  const double dv = eps_v - detail::volumetric_strain(m.surface(phi).at(s).p, m.moduli(phi).K);
  return detail::solve_return(m, {{eps_v, eps_q}, std::exp(-eps_v)}, phi, unit, rounding, {s, dv, eps_q}, e);
}

} // namespace

TEST(Ends, TheMirrorImageBehindAnEndIsNoState) {
  // The normals of an apex in q < 0 turn by eps_q/dv: 1e-4, which was within a thousandth of the stretch.
  for (const DruckerPrager& m : rocks()) {
    const double end = m.surface(0).s_min();
    EXPECT_TRUE(accepted(m, 0.1, 1e-5, 0, 0.95 * end)) << m.psi_deg;
    EXPECT_FALSE(accepted(m, 0.1, -1e-5, 0, 0.95 * end)) << m.psi_deg;
  }
  // A tensile cap much smaller than the surface: there the stretch allowed for 2e-9/Lambda of it.
  for (const double Lambda : {1e-2, 1e-5, 1e-7}) {
    const Vmdc m{{0.7, 1, 100, 0.3, 1, Lambda, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}};
    const double end = m.surface(0).s_min();
    EXPECT_TRUE(accepted(m, 0.02, 1e-11, 0, 0.95 * end)) << Lambda;
    EXPECT_FALSE(accepted(m, 0.02, -1e-11, 0, 0.95 * end)) << Lambda;
  }
}

TEST(Ends, APointOfTheAxisIsAState) {
  for (const DruckerPrager& m : rocks()) EXPECT_EQ(update_one(m, {0.1, 0.1, 0.1}, 0).zone, Zone::tension);
  for (const Vmdc& m : corner_materials()) {
    const double strongest = m.moduli(0).K / std::exp(1.0); // the largest tension of the elastic law
    EXPECT_EQ(update_one(m, {0.3, 0.3, 0.3}, 0).zone, m.Lambda < strongest ? Zone::tension : Zone::elastic);
    EXPECT_EQ(update_one(m, {-0.1, -0.1, -0.1}, 0).zone, Zone::compaction);
  }
}

TEST(Ends, ALineGoesOnAsFarAsThePressure) {
  // A rock a million times weaker than it is stiff, at pressures of the size of its modulus.
  const DruckerPrager weak{1e10, 0.2, 5, 1e3, 2};
  const VonMises soft{1e10, 0.2, 1e3};
  for (const double eps_v : {-0.01, -0.1, -0.3, -1.0})
    for (const Model& model : {Model(weak), Model(soft)}) {
      const PointUpdate u =
          update_one(model, {eps_v * (1.0 / 3 - 0.1), eps_v / 3, eps_v * (1.0 / 3 + 0.1)}, 0);
      EXPECT_EQ(u.status, Status::plastic) << model_name(model) << " at " << eps_v;
      EXPECT_EQ(u.zone, Zone::shear);
    }
}
