#include "press/case_card.hpp"

#include "core/error.hpp"
#include "material/card.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace platen;
using press::Case;

namespace {

const std::string head = "platen = 1\nexperiment = \"simple\"\nmaterial = \"base-case\"\nradius_m = 1e-3\n";

Case read(const std::string& text) { return press::read_case(core::parse_toml(text, "c.toml")); }

std::string refusal(const std::string& text) {
  try {
    (void)read(text);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

/// Of a case that was never a card.
std::string refusal(const press::Experiment& e, double radius_m = 1e-3) {
  try {
    press::validate({{"e", material::Elastic{1e9, 0.3}}, radius_m, e});
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();

#define EXPECT_REFUSED(message, words) EXPECT_NE((message).find(words), std::string::npos) << (message)

} // namespace

TEST(CaseCard, ReadsAnExperiment) {
  const Case c = read(head + "[path]\ndelta_bar_max = 0.4\nunload_from = [0.1, 0.3]\nreload = true\n"
                             "[mesh]\nelements = 1000\n[output]\nfields_at = [0.1, 0.4]\n");
  EXPECT_EQ(c.material.name, "Base case");
  EXPECT_EQ(c.radius_m, 1e-3);
  const auto& simple = std::get<press::Simple>(c.experiment);
  EXPECT_EQ(simple.delta_bar_max, 0.4);
  EXPECT_EQ(simple.unload_from, (std::vector{0.1, 0.3}));
  EXPECT_TRUE(simple.reload);
  EXPECT_EQ(simple.elements, 1000);
  EXPECT_EQ(simple.fields_at, (std::vector{0.1, 0.4}));
}

TEST(CaseCard, TakesTheMaterialAsATable) {
  const Case c =
      read("platen = 1\nexperiment = \"simple\"\nradius_m = 1\n[material]\nplaten = 1\nname = \"e\"\n"
           "model = \"elastic\"\n[material.parameters]\nE_Pa = 1e9\nnu = 0.2\n");
  EXPECT_EQ(std::get<material::Elastic>(c.material.model).nu, 0.2);
}

TEST(CaseCard, RefusesAPathThatCannotBePressed) {
  EXPECT_EQ(refusal(head + "[path]\ndelta_bar_max = 0.51"),
            "c.toml, line 6: [path] delta_bar_max = 0.51 is not allowed; it must be a number in (0, 0.5]");
  EXPECT_EQ(refusal(head + "[path]\ndelta_bar_max = 0"),
            "c.toml, line 6: [path] delta_bar_max = 0 is not allowed; it must be a number in (0, 0.5]");
  EXPECT_EQ(
      refusal(head + "[path]\ndelta_bar_max = 1e-6"),
      "c.toml, line 6: [path] delta_bar_max = 1e-6 is a contact smaller than this mesh resolves, 1e-4 at "
      "least; experiment = \"local\" presses it");
  EXPECT_EQ(refusal(head + "[path]\ndelta_bar_max = 0.1\n[output]\nfields_at = [0.2]"),
            "c.toml, line 8: [output] fields_at goes to 0.2, beyond delta_bar_max = 0.1");
}

TEST(CaseCard, RefusesAParticleWhoseForcesAreNoNumbers) {
  for (const char* R : {"1e300", "1e-300", "1e-120"})
    EXPECT_NE(refusal("platen = 1\nexperiment = \"simple\"\nmaterial = \"base-case\"\nradius_m = " +
                      std::string(R) + "\n")
                  .find("are no numbers"),
              std::string::npos)
        << R;
}

TEST(CaseCard, RefusesAForceInASimplePress) {
  EXPECT_NE(refusal(head + "[path]\nforce_max_N = 1").find("is for experiment = \"local\""),
            std::string::npos);
}

TEST(CaseCard, OfALocalPressGoesByForce) {
  const std::string local = "platen = 1\nexperiment = \"local\"\nmaterial = \"elastic\"\nradius_m = 0.1\n";
  EXPECT_EQ(refusal(local + "[path]\nforce_max_N = 5\nunload_from_N = [6]"),
            "c.toml, line 7: [path] unload_from_N goes to 6, beyond force_max_N = 5");
  EXPECT_EQ(refusal(local + "[path]\ndelta_bar_max = 0.001\n[output]\nfields_at = [0.002]"),
            "c.toml, line 8: [output] fields_at goes to 0.002, beyond delta_bar_max = 0.001");
  EXPECT_NE(refusal(local + "[mesh]\nedges = 4").find("[8, 100]"), std::string::npos);
}

TEST(CaseCard, NamesWhatWasMeant) {
  EXPECT_NE(refusal(head + "[path]\nradius_mm = 1").find("there is no such key"), std::string::npos);
  EXPECT_EQ(refusal("platen = 1\nexperiment = \"simple\"\nmaterial = \"base-case\"\nradius_mm = 1"),
            "c.toml, line 4: radius_mm = 1 is not in SI units; write radius_m = 0.001");
  EXPECT_EQ(refusal("platen = 1\nexperiment = \"simple\"\nmaterial = \"base-cas\"\nradius_m = 1"),
            "c.toml, line 3: material: 'base-cas' is neither a file nor a card in materials of the "
            "catalogue; did you "
            "mean 'base-case'?");
  EXPECT_EQ(refusal("platen = 1\nexperiment = \"simple\"\nmaterial = 3\nradius_m = 1"),
            "c.toml, line 3: material = 3 is a whole number; it must be a name in the catalogue, a path, or "
            "a table");
  EXPECT_NE(
      refusal("platen = 1\nexperiment = \"simple\"\nmaterial = \"base-case\"\n").find("radius_m is missing"),
      std::string::npos);
}

TEST(CaseCard, IsWrittenAsItIsRead) {
  const Case c = read(head + "[path]\nunload_from = [0.1, 0.5]\n[mesh]\nelements = 77\n");
  const Case again = read(press::case_text(c));
  EXPECT_EQ(press::case_text(again), press::case_text(c));
  EXPECT_EQ(std::get<press::Simple>(again.experiment).elements, 77);
}

TEST(CaseCard, ThatWasNeverACardIsCheckedTheSame) {
  Case c = read(head);
  EXPECT_NO_THROW(press::validate(c));
  by_overlap(c.experiment)->delta_bar_max = 0.6;
  EXPECT_THROW(press::validate(c), core::InvalidInput);
}

TEST(CaseCard, ThatWasNeverACardIsRefusedForWhatIsNoNumber) {
  EXPECT_EQ(refusal(press::Simple{}), "nothing was refused");
  EXPECT_REFUSED(refusal(press::Simple{}, no_number), "radius_m");
  EXPECT_REFUSED(refusal(press::Simple{}, infinite), "radius_m");
  press::Simple e;
  e.delta_bar_max = no_number;
  EXPECT_REFUSED(refusal(e), "delta_bar_max");
  e = {};
  e.step_max = no_number;
  EXPECT_REFUSED(refusal(e), "step_max");
  e = {};
  e.fields_at = {0.1, no_number};
  EXPECT_REFUSED(refusal(e), "fields_at");
  press::Local local;
  local.force_max_N = no_number;
  EXPECT_REFUSED(refusal(local), "force_max_N");
  local.force_max_N = infinite; // a force without limit is one that may be asked for
  EXPECT_EQ(refusal(local), "nothing was refused");
  local.first_contact_bar = infinite;
  EXPECT_REFUSED(refusal(local), "first_contact_bar");
}

TEST(CaseCard, ThatWasNeverACardIsRefusedOutsideItsRange) {
  EXPECT_REFUSED(refusal(press::Simple{}, 0), "radius_m");
  EXPECT_REFUSED(refusal(press::Simple{}, -1), "radius_m");
  press::Simple e;
  e.elements = 31;
  EXPECT_REFUSED(refusal(e), "elements");
  e = {};
  e.step_max = 0;
  EXPECT_REFUSED(refusal(e), "step_max");
  e = {};
  e.delta_bar_max = 0.1;
  e.unload_from = {0.2};
  EXPECT_REFUSED(refusal(e), "unload_from goes to 0.2, beyond delta_bar_max = 0.1");
  press::Die die;
  die.delta_bar_max = 0.6;
  EXPECT_REFUSED(refusal(die), "delta_bar_max");
  press::Triaxial triaxial;
  EXPECT_REFUSED(refusal(triaxial), "needs a waypoint");
  triaxial.delta_bar_z = {0.1};
  triaxial.delta_bar_x = {1};
  EXPECT_REFUSED(refusal(triaxial), "delta_bar_x");
  press::Local local;
  local.edges = 4;
  EXPECT_REFUSED(refusal(local), "edges");
}

TEST(CaseCard, HasListsThatAscend) {
  EXPECT_REFUSED(refusal(head + "[path]\nunload_from = [0.3, 0.1]\n"), "unload_from");
  press::Simple e;
  e.unload_from = {0.3, 0.1};
  EXPECT_REFUSED(refusal(e), "unload_from");
  e.unload_from = {0.1, 0.1};
  EXPECT_REFUSED(refusal(e), "unload_from");
  e.unload_from = {0.1, 0.3};
  EXPECT_EQ(refusal(e), "nothing was refused");
  press::Triaxial turning; // but waypoints may turn
  turning.delta_bar_z = {0.1, 0.05};
  EXPECT_EQ(refusal(turning), "nothing was refused");
}

TEST(CaseCard, HasTheLargestStep) {
  const Case c = read(head + "[mesh]\nstep_max = 0.0025\n");
  EXPECT_EQ(std::get<press::Simple>(c.experiment).step_max, 0.0025);
  EXPECT_NE(press::case_text(c).find("\nstep_max = 0.0025\n"), std::string::npos);
  EXPECT_NE(press::case_identity(c).find("\nstep_max = 0.0025\n"), std::string::npos);
  EXPECT_NE(press::case_identity(c), press::case_identity(read(head)));
}

TEST(CaseIdentity, LeavesOutWhatIsAsItIsByDefault) {
  // So a new optional key, which earlier cases have as it is by default, would not name them anew.
  const std::string plain = press::case_identity(read(head));
  for (const char* key : {"delta_bar_max", "unload_from", "reload", "elements", "step_max", "fields_at"}) {
    EXPECT_EQ(plain.find(key), std::string::npos) << key;
    EXPECT_NE(press::case_text(read(head)).find(key), std::string::npos) << key;
  }
  EXPECT_EQ(press::case_identity(read(head + "[path]\ndelta_bar_max = 0.5\n[mesh]\nelements = 2500\n")),
            plain);
}

TEST(CaseIdentity, IsOfTheMaterialTheRadiusAndTheExperiment) {
  const std::string plain = press::case_identity(read(head));
  Case c = read(head);
  c.radius_m = 2e-3;
  EXPECT_NE(press::case_identity(c), plain);
  c = read(head);
  c.material.model = material::Elastic{1e9, 0.3};
  EXPECT_NE(press::case_identity(c), plain);
  c = read(head);
  c.experiment = press::Die{};
  EXPECT_NE(press::case_identity(c), plain);
  c.experiment = press::Simple{};
  by_overlap(c.experiment)->reload = true;
  EXPECT_NE(press::case_identity(c), plain);
}

TEST(CaseIdentity, TellsAForceWithoutLimitFromTheUsualOne) {
  press::Local limited, unlimited;
  unlimited.force_max_N = infinite;
  const material::Material elastic{"e", material::Elastic{1e9, 0.3}};
  EXPECT_NE(press::case_identity({elastic, 0.1, limited}), press::case_identity({elastic, 0.1, unlimited}));
  const Case again = read(press::case_text({elastic, 0.1, unlimited}));
  EXPECT_EQ(std::get<press::Local>(again.experiment).force_max_N, infinite);
}
