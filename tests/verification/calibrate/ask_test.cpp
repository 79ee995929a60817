// What a driver is told is the likelihood that standard errors and profiles are of.

#include "calibrate/ask.hpp"
#include "core/file.hpp"
#include "recovery.hpp"

#include <filesystem>

namespace {

using namespace platen;

measure::Measurement granules(int count) {
  std::mt19937_64 random(11);
  measure::Measurement m{"synthetic", "", "", {}, {}};
  for (int p = 0; p < count; ++p) {
    auto made = synthetic::measured(synthetic::granule, (0.8 + 0.1 * p) * 1e-3, 20e-6, 0.2, 0, random);
    made.specimen.name = std::to_string(p);
    m.specimens.push_back(std::move(made.specimen));
  }
  return m;
}

calibrate::Settings settings() {
  calibrate::Settings s;
  s.law = "shahin";
  s.given = {{"nu", "0.3"}, {"E_Pa", "0.4e9"}};
  s.machine = {synthetic::granule.compliance_m_per_N, {}, {}, "given"};
  return s;
}

TEST(Ask, ToldIsZeroAtTheBestAndThatOfTheProfileAtItsEnds) {
  const auto m = granules(3);
  auto s = settings();
  s.all_profiles = true;
  const auto c = calibrate::calibrate({m}, s);
  // Held at the end of one interval, the other follows; so the least deviance over the other is that of 95 %.
  s.asked = {c.values};
  for (int i = -40; i <= 40; ++i)
    s.asked.push_back({c.profiles[0]->high, c.values[1] + c.errors[1] * (2 + 0.05 * i)});
  const auto told = calibrate::calibrate({m}, s).told;
  EXPECT_NEAR(told.front().deviance, 0, 0.01);
  double least = told[1].deviance;
  for (std::size_t i = 1; i < told.size(); ++i) least = std::min(least, told[i].deviance);
  EXPECT_NEAR(least, calibrate::deviance_95, 0.15);
}

TEST(Ask, ASetThatIsNoMaterialHasNoLikelihood) {
  auto s = settings();
  s.asked = {{5e6, 1.5}, {-1, 0.5}};
  for (const auto& told : calibrate::calibrate({granules(1)}, s).told) {
    EXPECT_EQ(told.deviance, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(told.force_N.empty());
  }
}

TEST(Ask, ColumnsMayStandInAnyOrder) {
  const auto file = std::filesystem::temp_directory_path() / "platen-asked.csv";
  core::write_file(file, "note,inverse_m,kappa_Pa\n1,0.5,4e6\n");
  const auto asked = calibrate::read_asked(file.string(), calibrate::free_parameters(settings()));
  std::filesystem::remove(file);
  EXPECT_EQ(asked, (std::vector<std::vector<double>>{{4e6, 0.5}}));
}

} // namespace
