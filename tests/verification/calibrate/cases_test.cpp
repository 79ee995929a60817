// Files as instruments write them, with known truth (tests/data/measured/README.md). Tolerances: what an
// independent least-squares fit of law parameters and contact point together reaches with room to spare.

#include "calibrate/calibration.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace platen;
using calibrate::Calibration;

std::string path(const std::string& name) { return PLATEN_MEASURED + name; }

struct Asked {
  std::string file, law;
  law::ParameterTexts given;
  measure::ReadOptions read = {};
  measure::Machine machine = {};
};

Calibration calibrated(const Asked& asked) {
  calibrate::Settings settings;
  settings.law = asked.law;
  settings.given = asked.given;
  settings.machine = asked.machine;
  return calibrate::calibrate({measure::read_measurement(path(asked.file), asked.read)}, settings);
}

double value(const Calibration& c, std::string_view key) {
  for (std::size_t k = 0; k < c.free.size(); ++k)
    if (c.free[k].key == key) return c.values[k];
  ADD_FAILURE() << "no parameter " << key;
  return 0;
}

std::string refusal(const Asked& asked) {
  try {
    (void)calibrated(asked);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "";
}

void expect_within(double found, double truth, double share) { EXPECT_NEAR(found, truth, share * truth); }

bool says(const std::vector<std::string>& said, std::string_view part) {
  for (const auto& sentence : said)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

measure::ReadOptions radius(double R) {
  measure::ReadOptions options;
  options.diameter_m = 2 * R;
  return options;
}

measure::Machine frame(double compliance_m_per_N) { return {compliance_m_per_N, {}, {}, "given"}; }

TEST(Cases, ANameValueUnitHeaderInLatin1WithPreload) {
  const auto c = calibrated({"s01_zwick_de.csv", "shahin", {{"nu", "0.3"}}});
  ASSERT_EQ(c.particles.size(), 1u);
  const auto& p = c.particles.front();
  EXPECT_DOUBLE_EQ(p.diameter_m, 1e-3);
  EXPECT_EQ(p.stages.holds, 1);
  EXPECT_EQ(p.stages.unloadings, 1);
  expect_within(value(c, "kappa_Pa"), 6.03e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.66, 0.02);
  expect_within(value(c, "E_Pa"), 0.40e9, 0.05);
  EXPECT_NEAR(p.contact_m, -11.7e-6, 1.5e-6);
}

TEST(Cases, SignsThatAreTurnedAndAMachineThatGivesWay) {
  const auto c = calibrated({"s02_bluehill.csv", "agarwal", {{"nu", "0.3"}}, radius(1e-3), frame(0.8e-6)});
  expect_within(value(c, "E_Pa"), 2.0e9, 0.05);
  expect_within(value(c, "sigma_y_Pa"), 12.0e6, 0.03);
  EXPECT_NEAR(c.particles.front().contact_m, 60e-6, 2e-6);
}

TEST(Cases, WithoutTheComplianceTheModulusIsWrongAndTheCardSaysThatNoneWasUsed) {
  const auto c = calibrated({"s02_bluehill.csv", "agarwal", {{"nu", "0.3"}}, radius(1e-3)});
  expect_within(value(c, "E_Pa"), 0.80e9, 0.03);
  const auto machine = fit::value_of(c.card.provenance, "machine");
  EXPECT_NE(std::get<std::string>(machine).find("no compliance"), std::string::npos);
}

TEST(Cases, SpecimensSideBySideInGramsOneOfThemBroken) {
  const auto c = calibrated({"s03_texture_columns.csv", "shahin", {{"nu", "0.3"}, {"E_Pa", "0.3e9"}}});
  ASSERT_EQ(c.particles.size(), 3u);
  ASSERT_EQ(c.broken.size(), 1u);
  EXPECT_NE(c.broken.front().find("granule 3"), std::string::npos);
  expect_within(value(c, "kappa_Pa"), 2.5e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.50, 0.02);
  const double diameters[] = {1.20e-3, 1.05e-3, 0.98e-3}, contacts[] = {-24.2e-6, -27.5e-6, -29.4e-6};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(c.particles[i].diameter_m, diameters[i]);
    EXPECT_NEAR(c.particles[i].contact_m, contacts[i], 2e-6);
  }
}

TEST(Cases, BlocksWithADiameterEach) {
  const auto c = calibrated({"s04_micro_blocks.txt", "agarwal", {{"nu", "0.3"}}});
  ASSERT_EQ(c.particles.size(), 3u);
  EXPECT_TRUE(says(c.broken, "Test No. 3"));
  const double diameters[] = {52.4e-6, 47.1e-6, 44.9e-6};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = c.particles[i];
    EXPECT_NEAR(p.diameter_m, diameters[i], 1e-12);
    for (std::size_t k = 0; k < c.free.size(); ++k)
      expect_within(p.values[k], c.free[k].key == "E_Pa" ? 5.0e9 : 20.0e6,
                    c.free[k].key == "E_Pa" ? 0.05 : 0.03);
    EXPECT_NEAR(p.contact_m, 0, 0.05e-6);
  }
}

TEST(Cases, SectionsJoinedInTimeWithLoops) {
  const auto c = calibrated({"s05_mts_de.dat", "agarwal", {{"nu", "0.33"}}});
  ASSERT_EQ(c.particles.size(), 1u);
  const auto& p = c.particles.front();
  EXPECT_DOUBLE_EQ(p.diameter_m, 10e-3);
  EXPECT_EQ(p.stages.loops, 2);
  EXPECT_EQ(p.stages.unloadings, 3);
  expect_within(value(c, "E_Pa"), 70e9, 0.05);
  expect_within(value(c, "sigma_y_Pa"), 120e6, 0.03);
  EXPECT_NEAR(p.contact_m, -3.200e-3, 0.005e-3); // the position falls: turned
  EXPECT_EQ(p.contact.substr(0, 6), "3.2 mm");
}

TEST(Cases, OfTwoDisplacementsOneIsAskedForAndDeadChannelsAreNotTaken) {
  const auto why = refusal({"s06_logger_two_ways.asc", "shahin", {{"nu", "0.25"}}, radius(1.5e-3)});
  EXPECT_NE(why.find("Wegaufnehmer Platten"), std::string::npos) << why;
  EXPECT_NE(why.find("Traverse abs."), std::string::npos) << why;
  auto read = radius(1.5e-3);
  read.displacement = "Wegaufnehmer Platten";
  const auto c = calibrated({"s06_logger_two_ways.asc", "shahin", {{"nu", "0.25"}}, read});
  expect_within(value(c, "kappa_Pa"), 14.0e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.40, 0.02);
  expect_within(value(c, "E_Pa"), 1.2e9, 0.05);
  EXPECT_NEAR(c.particles.front().contact_m, 47.1e-6, 2e-6);
  read.displacement = "Traverse abs.";
  expect_within(value(calibrated({"s06_logger_two_ways.asc", "shahin", {{"nu", "0.25"}}, read}), "E_Pa"),
                0.39e9, 0.05);
}

TEST(Cases, ALongTableOfABatchTwoOfTwelveBroken) {
  const auto c = calibrated({"s07_batch_long.csv", "shahin", {{"nu", "0.3"}, {"E_Pa", "0.3e9"}}});
  EXPECT_EQ(c.particles.size(), 10u);
  ASSERT_EQ(c.broken.size(), 2u);
  EXPECT_TRUE(says(c.broken, "particle 4 "));
  EXPECT_TRUE(says(c.broken, "particle 9 "));
  expect_within(value(c, "kappa_Pa"), 4.2e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.55, 0.02);
}

TEST(Cases, AGlassBeadInAMachineThatWasMeasuredEmpty) {
  const auto machine = measure::empty_machine(measure::read_measurement(path("s08_empty_machine.csv")));
  expect_within(machine.compliance_m_per_N, 0.35e-6, 0.02);
  EXPECT_TRUE(machine.force_N.empty()) << "straight";
  const auto c = calibrated({"s08_glass_bead.csv", "hertz", {{"nu", "0.22"}}, radius(1e-3), machine});
  expect_within(value(c, "E_Pa"), 63e9, 0.04);
  EXPECT_NEAR(c.particles.front().contact_m, 8.0e-6, 0.3e-6);
  const auto without = calibrated({"s08_glass_bead.csv", "hertz", {{"nu", "0.22"}}, radius(1e-3)});
  expect_within(value(without, "E_Pa"), 16e9, 0.03);
}

TEST(Cases, AnEmptyMachineIsNoParticle) {
  const auto c = calibrated({"s08_empty_machine.csv", "hertz", {{"nu", "0.22"}}, radius(1e-3)});
  ASSERT_FALSE(c.doubts.empty());
  EXPECT_THROW((void)fit::pass(c.doubts, false), core::InvalidInput);
}

TEST(Cases, UnitsThatStandNowhereAreAskedForWithAReadingThatMakesSense) {
  const law::ParameterTexts given = {{"nu", "0.3"}, {"E_Pa", "0.3e9"}};
  const auto why = refusal({"s09_no_units.csv", "shahin", given, radius(0.6e-3)});
  for (const auto part : {"--force \"F\":N", "--displacement \"s\":mm",
                          "taken as mm, delta/R would end at 0.2", "taken as m, delta/R would end at 200"})
    EXPECT_NE(why.find(part), std::string::npos) << why;
  auto read = radius(0.6e-3);
  read.force = "F:N", read.displacement = "s:mm";
  const auto c = calibrated({"s09_no_units.csv", "shahin", given, read});
  expect_within(value(c, "kappa_Pa"), 5.0e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.60, 0.02);
  read.displacement = "s:m"; // delta/R would be 200
  EXPECT_THROW((void)fit::pass(calibrated({"s09_no_units.csv", "shahin", given, read}).doubts, false),
               core::InvalidInput);
}

TEST(Cases, RowsWithoutAReadingAndTheCutOneAreLeftOutAndSaid) {
  const law::ParameterTexts given = {{"nu", "0.3"}, {"E_Pa", "0.3e9"}};
  const auto c = calibrated({"s10_overload_cut.csv", "shahin", given, radius(0.6e-3)});
  expect_within(value(c, "kappa_Pa"), 5.0e6, 0.03);
  EXPECT_NEAR(value(c, "inverse_m"), 0.60, 0.02);
  const auto found = std::get<std::string>(fit::value_of(c.card.provenance, "found"));
  EXPECT_NE(found.find("line 162, the last, is cut"), std::string::npos) << found;
  EXPECT_NE(found.find("lines 79, 80 (\"-----\" in column \"Kraft in N\")"), std::string::npos) << found;
  EXPECT_EQ(std::get<int>(fit::value_of(c.card.provenance, "rows")), 158);
}

} // namespace
