// What a law vouches for: no more force than elastic bodies carry (pressed ones 1.25 times Hertz's at x =
// 0.1), and no dent by the curve of a flattened sphere.

#include "platen/law/catalogue.hpp"
#include "random_material.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

bool in_range(const Law& law, double x) { return evaluate(law, State{}, x / law.scale.x_per_gamma).in_range; }

Law law_of(const char* name, const std::string& parameters) {
  return make_law(name, "", parameter_texts("radius_m=1e-3 nu=0.3 " + parameters));
}

TEST(Validity, HoldsNowhereMoreForceThanElasticSpheresCarry) {
  Random random;
  for (const LawInfo& info : laws()) {
    const bool fitted = info.name == "luding" || info.name == "eepa" || info.name == "pressed" ||
                        info.name == "wang" || info.name == "edmans-sinka"; // carry what they were fitted to
    if (fitted) continue;
    int vouched = 0;
    for (int i = 0; i < 300; ++i) {
      LawChoice one = random_material(info, random);
      const double E = std::stod(one.parameters.at("E_Pa"));
      for (const char* strength : {"sigma_y_Pa", "kappa_Pa", "p_y_Pa"})
        if (one.parameters.contains(strength))
          one.parameters[strength] = digits(E / random.log_between(0.5, 1000));
      one.parameters.erase("loading"); // a cell that fills carries more
      std::optional<Law> law;
      try {
        law = make_law(one, 1e-3, one, random.unit() < 0.5 ? 1e-3 : infinity);
      } catch (const BadParameter&) { continue; }
      for (double x = 1e-8; x < 0.1; x *= 1.2) {
        if (!in_range(*law, x)) continue;
        ++vouched;
        const double gamma = x / law->scale.x_per_gamma;
        const double hertz = 4.0 / 3 * law->pair.E_star * gamma * std::sqrt(gamma / law->pair.A);
        ASSERT_LE(evaluate(*law, State{}, gamma).force, 1.5 * hertz) << text_of(one) << " x " << x;
      }
    }
    EXPECT_GT(vouched, 1000) << info.name;
  }
}

TEST(Validity, OfARigidPlasticLawBeginsWhereItFallsBelowHertz) {
  // Perfectly plastic: 6 pi c^2 kappa gamma/A = 4/3 E* gamma^(3/2)/sqrt(A): x = (4.5 pi c^2 kappa/E')^2.
  const double E = 200e9, kappa = 1e9, c2 = 1.43;
  const double x = std::pow(4.5 * std::numbers::pi * c2 * kappa * (1 - 0.09) / E, 2);
  const Law law = law_of("similarity", "E_Pa=200e9 kappa_Pa=1e9 inverse_m=0");
  EXPECT_FALSE(in_range(law, 0.999 * x));
  EXPECT_TRUE(in_range(law, 1.001 * x));
  for (const char* name : {"similarity", "shahin"}) // within its range never
    EXPECT_FALSE(in_range(law_of(name, "E_Pa=5e6 kappa_Pa=4e6 inverse_m=0.2"), 0.025)) << name;
  EXPECT_TRUE(in_range(law_of("shahin", "E_Pa=1e11 kappa_Pa=1e8 inverse_m=0.3"), 0.4));
}

TEST(Validity, EdmansSinkaOfAStrengthBeyondTheModulusHasNone) {
  const std::string granule = "E_Pa=4.417e8 sigma_ref_Pa=8.61e6 delta_t=0.09 a=3.5 ";
  EXPECT_TRUE(in_range(law_of("edmans-sinka", granule + "k=4.2"), 0.3));
  EXPECT_TRUE(in_range(law_of("edmans-sinka", granule + "k=4.2"), 1e-6));
  EXPECT_FALSE(in_range(law_of("edmans-sinka", granule + "k=4200"), 0.3)); // a slip of units
  EXPECT_FALSE(in_range(law_of("edmans-sinka", granule + "k=4200"), 1e-6));
}

TEST(Validity, OfADentEndsWhileItIsSmall) {
  const auto pair = [](const char* name, const char* key, double one, double two, const char* R2) {
    const std::string more = std::string(name) == "shahin" ? "inverse_m=0.2 " : "";
    std::string second = key;
    second.insert(second.find("_Pa"), "2");
    return law_of(name, "E_Pa=2e11 " + more + key + '=' + digits(one) + ' ' + second + '=' + digits(two) +
                            " radius2_m=" + R2);
  };
  for (const auto& [name, key] :
       {std::pair{"agarwal", "sigma_y_Pa"}, std::pair{"jackson-green", "sigma_y_Pa"},
        std::pair{"mdr", "sigma_y_Pa"}, std::pair{"shahin", "kappa_Pa"}})
    for (const char* R2 : {"inf", "3e-3"}) {
      const Law dent = pair(name, key, 1e9, 2e8, R2), flattened = pair(name, key, 2e8, 1e9, R2);
      EXPECT_TRUE(in_range(dent, 0.0199)) << name;
      EXPECT_FALSE(in_range(dent, 0.021)) << name;
      EXPECT_TRUE(in_range(flattened, 0.05)) << name;
    }
}

TEST(Validity, OfKogutEtsionNeedsAMetal) { // else 110 overlaps of first yield are more than the sphere has
  for (const char* name : {"kogut-etsion", "etsion-unloading"}) {
    EXPECT_TRUE(in_range(law_of(name, "E_Pa=2e11 sigma_y_Pa=1e9"), 0.005)) << name;
    EXPECT_FALSE(in_range(law_of(name, "E_Pa=2e9 sigma_y_Pa=1e9"), 1)) << name;
  }
}

} // namespace
