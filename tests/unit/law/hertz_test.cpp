#include "platen/law/hertz.hpp"

#include "random_paths.hpp"

namespace {

using namespace platen::law;
using namespace platen::law::testing;

TEST(Hertz, TwoSpheresAndPlanes) {
  // Johnson, Contact Mechanics, (4.22)-(4.24), written out with R* and E*
  const double R1 = 2e-3, R2 = 5e-3, E1 = 70e9, E2 = 3e9, nu1 = 0.2, nu2 = 0.4, gamma = 1e-6;
  const double E_star = 1 / ((1 - nu1 * nu1) / E1 + (1 - nu2 * nu2) / E2), R_star = 1 / (1 / R1 + 1 / R2);
  const auto two = prepare_hertz(sphere(R1, E1, nu1), sphere(R2, E2, nu2));
  EXPECT_NEAR(evaluate(two, State{}, gamma).force,
              4.0 / 3 * E_star * std::sqrt(R_star) * std::pow(gamma, 1.5), 1e-14);
  EXPECT_NEAR(evaluate(two, State{}, gamma).contact_radius, std::sqrt(R_star * gamma), 1e-18);
  // a plane of the same material halves E*, it does not double the force of the rigid one
  const auto soft = prepare_hertz(sphere(R1, E1, nu1), plane(E1, nu1));
  const auto hard = prepare_hertz(sphere(R1, E1, nu1), rigid_plane());
  const double F_hard = evaluate(hard, State{}, gamma).force;
  EXPECT_NEAR(F_hard, 4.0 / 3 * E1 / (1 - nu1 * nu1) * std::sqrt(R1) * std::pow(gamma, 1.5), 1e-12 * F_hard);
  EXPECT_NEAR(evaluate(soft, State{}, gamma).force, F_hard / 2, 1e-12 * F_hard);
}

TEST(Hertz, UnloadsAlongItself) {
  const auto law = prepare_hertz(sphere(1e-3, 1e9, 0.3), rigid_plane());
  const State top = evaluate(law, State{}, 5e-6).state;
  const Response down = evaluate(law, top, 3e-6);
  EXPECT_EQ(down.force, evaluate(law, State{}, 3e-6).force);
  EXPECT_EQ(down.dissipated_work, 0);
  EXPECT_EQ(down.branch, Branch::unloading);
}

TEST(Hertz, RandomPathsCreateNothing) {
  for_random_cases(paths_per_law, [] {
    const Body one = sphere(log_between(1e-6, 0.1), log_between(1e6, 1e12), between(0, 0.499));
    const Body two = unit() < 0.3 ? rigid_plane()
                     : unit() < 0.5
                         ? plane(log_between(1e6, 1e12), between(0, 0.499))
                         : sphere(log_between(1e-6, 0.1), log_between(1e6, 1e12), between(0, 0.499));
    const auto law = prepare_hertz(one, two);
    holds_on_path(law, prepare_hertz(two, one), random_path(1 / law.pair.x_per_gamma));
  });
}

} // namespace
