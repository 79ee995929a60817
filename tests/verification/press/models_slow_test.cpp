// Every model under the press: the corners of Edmans & Sinka's parameter space (section 3.5) on each of the
// paper's surfaces, and the other papers' materials. What cannot carry its load must say so.

#include "material/card.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cstdio>

using namespace platen;

namespace {

press::Case case_of(const std::string& name, const material::Model& model) {
  press::Simple e;
  e.elements = 1000;
  return {{name, model}, 1e-3, e};
}

/// The balance of work, energy and dissipation of a press that ended as it should.
void expect_balance(const press::Result& result, const std::string& name) {
  const auto& last = result.curve.points.back();
  EXPECT_NEAR(last.stored_J + last.dissipated_J, last.work_J, 0.003 * last.work_J) << name;
}

} // namespace

TEST(EveryModel, OfTheCornerMaterialsRunsOrComesToALimitLoadThatItNames) {
  int limits_published = 0, limits_default = 0;
  for (const double E_bar : {3.0, 500.0})
    for (const double Gamma_bar : {0.25, 1.0})
      for (const double Lambda_bar : {0.01, 1.0}) {
        const material::Vmdc corner{
            0.7, 1e6, E_bar * 1e6, 0.3, Gamma_bar * 1e6, Lambda_bar * 1e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5};
        for (const char* surface : {"vmdc", "von-mises", "dpc", "dpc-published"}) {
          char name[100];
          std::snprintf(name, sizeof name, "%s E %g Gamma %g Lambda %g", surface, E_bar, Gamma_bar,
                        Lambda_bar);
          const auto result = press::press(case_of(name, material::run_as(corner, surface)));
          if (!result.failure) {
            expect_balance(result, name);
            continue;
          }
          std::printf("%s: %s\n", name, result.failure->c_str());
          const bool published = std::string(surface) == "dpc-published";
          ASSERT_TRUE(published || std::string(surface) == "dpc") << name << ": " << *result.failure;
          EXPECT_LT(Lambda_bar, 1) << name << " has the strength to go on";
          EXPECT_TRUE(result.failure->find("limit load") != std::string::npos ||
                      result.failure->find("failure line of dpc") != std::string::npos)
              << *result.failure;
          ++(published ? limits_published : limits_default);
        }
      }
  EXPECT_LT(limits_default, limits_published)
      << "the paper's potential fails where a dissipative one does not";
}

TEST(EveryModel, OfTheOtherPapersRunsToHalfTheRadius) {
  for (const char* card : {"lead-ludwik", "lead-hollomon", "sandstone-wang-3-3", "sandstone-wang-3-4",
                           "sandstone-wang-3-4-von-mises", "sandstone-wang-3-4-mohr-coulomb", "wang-type-1",
                           "wang-type-2", "mcc-ph-102-at-half", "starch-1500-at-half"}) {
    const auto result = press::press(case_of(card, material::read_card(card).material.model));
    ASSERT_FALSE(result.failure) << card << ": " << *result.failure;
    EXPECT_NEAR(result.curve.points.back().delta_bar, 0.5, 1e-12);
    expect_balance(result, card);
  }
}
