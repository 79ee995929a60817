#include "press/case_card.hpp"

#include "core/error.hpp"
#include "material/card.hpp"

#include <gtest/gtest.h>

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

} // namespace

TEST(CaseCard, ReadsAnExperiment) {
  const Case c = read(head + "[path]\ndelta_bar_max = 0.4\nunload_from = [0.1, 0.3]\nreload = true\n"
                             "[mesh]\nelements = 1000\n[output]\nfields_at = [0.1, 0.4]\n");
  EXPECT_EQ(c.experiment, "simple");
  EXPECT_EQ(c.material.name, "Base case");
  EXPECT_EQ(c.radius_m, 1e-3);
  EXPECT_EQ(c.delta_bar_max, 0.4);
  EXPECT_EQ(c.unload_from, (std::vector{0.1, 0.3}));
  EXPECT_TRUE(c.reload);
  EXPECT_EQ(c.elements, 1000);
  EXPECT_EQ(c.fields_at, (std::vector{0.1, 0.4}));
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
  EXPECT_EQ(refusal(head + "[path]\ndelta_bar_max = 0.1\n[output]\nfields_at = [0.2]"),
            "c.toml, line 8: [output] fields_at goes to 0.2, beyond delta_bar_max = 0.1");
}

TEST(CaseCard, RefusesWhatIsNotThereYet) {
  EXPECT_EQ(refusal("platen = 1\nexperiment = \"die\"\nmaterial = \"base-case\"\nradius_m = 1"),
            "c.toml, line 2: experiment = \"die\" is not available yet; available are: simple, local");
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
  EXPECT_EQ(again.elements, 77);
}

TEST(CaseCard, ThatWasNeverACardIsCheckedTheSame) {
  Case c = read(head);
  EXPECT_NO_THROW(press::validate(c));
  c.delta_bar_max = 0.6;
  EXPECT_THROW(press::validate(c), core::InvalidInput);
}
