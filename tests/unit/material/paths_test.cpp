// Random paths through every plastic material: work, dissipation, rotation.

#include "random_states.hpp"

#include "material/point.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

struct Shares {
  double least_power = 0;       ///< of one increment, tau:d_p over |p dv| + |q dw|
  double least_dissipation = 0; ///< of one increment, over its plastic power
  double least_total = 1;       ///< dissipation of a whole path over its plastic work
  long refused = 0;
};

/// 40 random increments a path, from the undeformed state.
Shares walk(const Model& model, int paths, double size, std::mt19937& generator) {
  std::uniform_real_distribution<double> sign(-1, 1);
  Shares shares;
  for (int path = 0; path < paths; ++path) {
    MaterialPoint point;
    std::array<double, 3> drift;
    for (double& d : drift) d = size * sign(generator);
    double work = 0, dissipated = 0;
    for (int i = 0; i < 40; ++i) {
      std::array<double, 3> step = drift;
      for (double& d : step) d = d / 4 + size * sign(generator);
      const MaterialPoint next = strained(model, point, step);
      if (is_refused(next.last.status)) {
        ++shares.refused;
        break;
      }
      const PointUpdate& u = next.last;
      if (u.zone != Zone::elastic) {
        const double power = u.p * u.dv + u.q * u.dw;
        shares.least_power =
            std::min(shares.least_power, power / (std::abs(u.p * u.dv) + std::abs(u.q * u.dw) + 1e-300));
        // Per volume of the undeformed material: plastic work less what the moduli store at the new strain.
        const TrialInvariants elastic = invariants(u.eps);
        const double J_p = plastic_volume_ratio(model, u.phi);
        const double locked =
            J_p * stored_energy(model, elastic, u.phi) -
            plastic_volume_ratio(model, point.phi) * stored_energy(model, elastic, point.phi);
        const double loss = J_p * u.plastic_work - locked;
        work += J_p * u.plastic_work;
        dissipated += loss;
        if (u.plastic_work > 0)
          shares.least_dissipation = std::min(shares.least_dissipation, loss / (J_p * u.plastic_work));
      }
      point = next;
    }
    if (work > 0) shares.least_total = std::min(shares.least_total, dissipated / work);
  }
  return shares;
}

} // namespace

TEST(RandomPaths, PlasticPowerIsNotNegative) {
  // tau:d_p >= 0 on 10,000 paths of each kind of model.
  std::mt19937 generator(31);
  const auto check = [&](const auto& materials, double strain) {
    const int each = 10000 / static_cast<int>(materials.size()) + 1;
    for (const auto& m : materials) {
      const Shares s = walk(m, each, strain, generator);
      EXPECT_GE(s.least_power, -1e-9) << "E " << m.E;
      EXPECT_EQ(s.refused, 0) << "E " << m.E;
    }
  };
  check(metals(), 0.02);
  check(rocks(), 0.005);
  check(corner_materials(), 0.02);
  check(caps(), 0.02);
  check(std::vector<MohrCoulomb>{{1e4 / 3.2, 0.38, 27.8, 1, 27.8, 1 / 3.2},
                                 {1e4 / 3.2, 0.38, 27.8, 1, 5, 1 / 3.2}},
        0.005);
}

TEST(RandomPaths, DissipationIsPlasticPowerWhereTheModuliStayWhatTheyAre) {
  std::mt19937 generator(32);
  for (const auto& m : metals()) EXPECT_GE(walk(m, 300, 0.02, generator).least_dissipation, -1e-9);
  for (auto m : corner_materials()) {
    m.xi = m.xi_1 = 0;
    // The unloaded volume shrinks with what it stores: per volume of it, energy is locked at the rate -psi
    // dv.
    const Shares s = walk(m, 100, 0.02, generator);
    EXPECT_GE(s.least_power, -1e-9);
  }
}

TEST(RandomPaths, DensityDependentModuliCanTakeMoreThanThePlasticPower) {
  // docs/explanation/press.md, energies: the dissipation is tau:d_p less what densification adds to the
  // stored energy at constant strain, and can be negative for soft materials. The least share met is
  // reported.
  std::mt19937 generator(33);
  double soft = 1, stiff = 1;
  for (const auto& m : corner_materials()) {
    const double least = walk(m, 200, 0.02, generator).least_dissipation;
    (m.E < 10 ? soft : stiff) = std::min(m.E < 10 ? soft : stiff, least);
  }
  RecordProperty("least_dissipation_share_soft", std::to_string(soft));
  RecordProperty("least_dissipation_share_stiff", std::to_string(stiff));
  std::printf("least dissipation over plastic power of one increment: E_bar = 3: %.3f, E_bar >= 100: %.3f\n",
              soft, stiff);
  EXPECT_GT(stiff, -1) << "a stiff material stores little";
}

TEST(RandomPaths, ThePublishedFlowOfDpcGivesWorkBack) {
  // Edmans & Sinka's Table 2 for DPC: from the peak to the apex it dilates, also against pressure. This is
  // why it is not the default. The least share met is reported.
  std::mt19937 generator(34);
  double least = 0;
  for (const auto& m : caps(true)) least = std::min(least, walk(m, 200, 0.01, generator).least_power);
  std::printf("least plastic power of the published Drucker-Prager Cap over |p dv| + |q dw|: %.3f\n", least);
  EXPECT_LT(least, -0.5);
}
