// One table for all radii of nearly the same ratio: how far that is from the law of the radii themselves.

#include "dem/contacts.hpp"
#include "platen/law/catalogue.hpp"

#include "../law/random_material.hpp"

#include <gtest/gtest.h>

namespace platen::dem {
namespace {

using namespace law;
using namespace law::testing;
using fit::LawCard;

TEST(Contacts, OfAnyRadiiAreWithin0_3PerCentOfTheLawOfThoseRadii) {
  Random random;
  double worst = 0;
  for (const char* name : {"hertz", "pressed", "agarwal", "edmans-sinka"})
    for (int i = 0; i < 20; ++i) {
      LawChoice one = random_material(find_law(name), random), two = random_material(find_law(name), random);
      two.variant = one.variant;
      for (const char* word : {"loading", "unloading"})
        if (one.parameters.contains(word)) two.parameters[word] = one.parameters[word];
      Laws laws({LawCard{"one.toml", name, one.variant, one.parameters, {}, {}, {}},
                 LawCard{"two.toml", name, two.variant, two.parameters, {}, {}, {}}},
                0, {});
      for (int k = 0; k < 5; ++k) {
        const double R1 = 1e-3, R2 = k == 0 ? 1.02e-3 : random.log_between(5e-5, 2e-2);
        const Law exact = make_law(one, R1, two, R2);
        for (const double x : {1e-4, 1e-3, 1e-2, 0.1, 0.3}) {
          const double overlap = x / exact.scale.x_per_gamma;
          const double F = evaluate(exact, State{}, overlap).force;
          const double off = respond(laws.at(R1, R2), 0, overlap).force / F - 1;
          EXPECT_NEAR(off, 0, 3e-3) << text_of(one) << '\n' << text_of(two) << '\n' << R2 << ' ' << x;
          worst = std::max(worst, std::abs(off));
        }
      }
    }
  EXPECT_GT(worst, 1e-4); // else the tables were not shared
}

TEST(Contacts, OfAHundredMaterialsTake40MB) { // 4,950 pairs, of spheres of one size or each of its own
  Random random;
  constexpr int pairs = 100;
  double sum = 0, most = 0, own = 0;
  for (int i = 0; i < pairs; ++i) {
    const LawChoice one = random_material(find_law("pressed"), random),
                    two = random_material(find_law("pressed"), random);
    Laws laws({LawCard{"one.toml", "pressed", one.variant, one.parameters, {}, {}, {}},
               LawCard{"two.toml", "pressed", two.variant, two.parameters, {}, {}, {}}},
              0, {});
    sum += static_cast<double>(laws.bytes()), most = std::max(most, static_cast<double>(laws.bytes()));
    (void)laws.at(1e-3, random.log_between(0.5e-3, 2e-3));
    own += static_cast<double>(laws.bytes());
  }
  std::printf("a pair takes %.1f kB, at most %.1f; of radii of their own %.1f\n", sum / pairs / 1e3,
              most / 1e3, own / pairs / 1e3);
  EXPECT_LE(sum / pairs * 4950, 40e6);
  EXPECT_LE(own / pairs * 4950, 40e6);
}

TEST(Contacts, OfUnlikeRadiiTakeLessMemoryThanOfLikeOnes) {
  Random random;
  double like = 0, unlike = 0;
  for (int i = 0; i < 10; ++i) {
    const LawChoice one = random_material(find_law("pressed"), random);
    Laws laws({LawCard{"one.toml", "pressed", one.variant, one.parameters, {}, {}, {}},
               LawCard{"one.toml", "pressed", one.variant, one.parameters, {}, {}, {}}},
              0, {});
    const auto before = static_cast<double>(laws.bytes());
    for (const double R2 : {1.1e-3, 2e-3}) (void)laws.at(1e-3, R2);
    like += before, unlike += (static_cast<double>(laws.bytes()) - before) / 2;
  }
  EXPECT_LT(unlike, like);
}

} // namespace
} // namespace platen::dem
