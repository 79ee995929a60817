#include "core/error.hpp"
#include "measure/machine.hpp"
#include "measure/specimen.hpp"
#include "measure/stages.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace platen;
using measure::Measurement, measure::ReadOptions;

Measurement read(const std::string& text, const ReadOptions& options = {}) {
  return read_measurement(measure::Text{"f", text, "ASCII"}, options);
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    (void)read(text, options);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "";
}

/// `header`, then rows of travel and force, 0 to n - 1.
std::string rows(const std::string& header, const std::function<std::string(int)>& row, int n = 20) {
  std::string text = header;
  for (int i = 0; i < n; ++i) text += row(i) + "\n";
  return text;
}
std::string plain(int i) { return fmt::format("{},{}", 0.001 * i, 0.1 * i); }

TEST(Specimen, DialectsGiveTheSameNumbers) {
  const auto a =
      read(rows("Weg in mm;Kraft in N\n", [](int i) { return fmt::format("0,{:03};{},5", i, i); }));
  const auto b =
      read(rows("Travel (mm)\tForce (N)\n", [](int i) { return fmt::format("0.{:03}\t{}.5", i, i); }));
  const auto c = read(rows("\"Travel\",\"Load\"\n\"(mm)\",\"(N)\"\n",
                           [](int i) { return fmt::format("\"0.{:03}\",\"{}.5\"", i, i); }));
  EXPECT_EQ(a.specimens.front().travel_m, b.specimens.front().travel_m);
  EXPECT_EQ(a.specimens.front().force_N, c.specimens.front().force_N);
  EXPECT_NEAR(a.specimens.front().travel_m[7], 7e-6, 1e-18);
}

TEST(Specimen, ThousandsSignsAreNoDecimals) {
  const auto m =
      read(rows("Weg in um;Kraft in N\n", [](int i) { return fmt::format("1.{:03},5;{},0", i, i); }));
  EXPECT_NEAR(m.specimens.front().travel_m[1], 1001.5e-6, 1e-12);
}

TEST(Specimen, SignsAreTurnedAndSaid) {
  const auto m = read(
      rows("travel_mm,force_N\n", [](int i) { return fmt::format("{},{}", 3.2 - 0.001 * i, -0.1 * i); }));
  const auto& s = m.specimens.front();
  EXPECT_GT(s.force_N.back(), 0);
  EXPECT_GT(s.travel_m.back(), s.travel_m.front());
  EXPECT_EQ(s.on_scale_of_file(s.travel_m.front()), "3.2 mm");
}

TEST(Specimen, OurOwnDeltaIsThatOfOnePlaten) {
  EXPECT_DOUBLE_EQ(read(rows("delta_m,force_N\n", plain)).specimens.front().per_travel(), 1);
  EXPECT_DOUBLE_EQ(read(rows("travel_m,force_N\n", plain)).specimens.front().per_travel(), 0.5);
  ReadOptions options;
  options.displacement_is = "contact";
  EXPECT_DOUBLE_EQ(read(rows("travel_m,force_N\n", plain), options).specimens.front().per_travel(), 1);
}

TEST(Specimen, ColumnsAndUnitsComeFromTheCommandLineWhereTheFileDoesNotSayThem) {
  ReadOptions options;
  options.force = "A:mN", options.displacement = "B:um";
  const auto m = read(rows("B,A\n", plain), options);
  EXPECT_DOUBLE_EQ(m.specimens.front().force_N[1], 0.1e-3);
  EXPECT_DOUBLE_EQ(m.specimens.front().travel_m[1], 1e-9);
  options.force = "C:N";
  EXPECT_EQ(refusal(rows("B,A\n", plain), options),
            "f, line 1: --force \"C\" is no column; there are \"B\", \"A\"");
}

TEST(Specimen, TextInPlaceOfANumberIsNamedByLineAndColumn) {
  const auto text = rows("travel_mm,force_N\n", [](int i) { return i == 5 ? "0.005,oops" : plain(i); });
  EXPECT_EQ(refusal(text), "f, line 7, column \"force_N\": \"oops\" is not a number");
}

TEST(Specimen, AnotherParticleBeginsAlsoWhereItsFirstRowHasNoReading) {
  std::string text = "particle,diameter_mm,travel_mm,force_N\n";
  for (const auto* name : {"A,1.0", "B,1.2"})
    for (int i = 0; i < 20; ++i)
      text += fmt::format("{},{},{}\n", name, 0.001 * i, i == 0 ? "OVER" : fmt::format("{}", 0.1 * i));
  const auto m = read(text);
  ASSERT_EQ(m.specimens.size(), 2u);
  EXPECT_EQ(m.specimens[1].name, "B");
  EXPECT_DOUBLE_EQ(m.specimens[1].diameter_m.value_or(0), 1.2e-3);
  EXPECT_EQ(m.specimens[0].force_N.size(), 19u);
}

TEST(Specimen, ALongerRowIsRefused) {
  const auto text = rows("travel_mm,force_N\n", [](int i) { return i == 5 ? "0.005,1,7" : plain(i); });
  EXPECT_EQ(refusal(text), "f, line 7: cell 3 is \"7\", but the header in line 1 has 2 columns");
}

TEST(Specimen, AFileCutInsideItsLastNumber) {
  auto text = rows("travel_mm,force_N\n", [](int i) { return fmt::format("0.{:03},{}.250", i, i); });
  text += "0.020,20.2";
  const auto m = read(text);
  EXPECT_EQ(m.specimens.front().force_N.size(), 20u);
  EXPECT_NE(m.said.front().find("line 22, the last, is cut"), std::string::npos);
}

TEST(Specimen, NumbersWithoutAHeaderAreRefused) {
  EXPECT_NE(refusal(rows("", plain)).find("line 1: numbers without a line above them"), std::string::npos);
}

TEST(Specimen, AUnitThatIsNotKnownIsAskedFor) {
  const auto why = refusal(rows("travel (mm),force (furlong)\n", plain));
  EXPECT_NE(why.find("no column is known as a force"), std::string::npos) << why;
}

TEST(Specimen, TwoDiametersAreRefused) {
  ReadOptions options;
  options.diameter_m = 2e-3;
  EXPECT_NE(refusal("diameter 1.0 mm\n" + rows("travel_mm,force_N\n", plain), options).find("leave one out"),
            std::string::npos);
}

/// Force over travel of a power law with gap and zero.
measure::Specimen particle(double gap, double zero) {
  measure::Specimen s;
  s.diameter_m = 1e-3;
  for (int i = 0; i < 200; ++i) {
    const double x = 1e-6 * i;
    s.travel_m.push_back(x);
    s.force_N.push_back(zero + 1e6 * std::pow(std::max(x - gap, 0.0), 1.2));
    s.line.push_back(i + 2);
  }
  return s;
}

TEST(Stages, ContactPointAndZeroOfTheLoadCellAreFoundTogether) {
  const auto stages = stages_of(particle(37.3e-6, 0.5));
  EXPECT_NEAR(stages.contact_travel_m, 37.3e-6, 0.2e-6);
  EXPECT_NEAR(stages.baseline_N, 0.5, 0.01);
  EXPECT_EQ(stages.of_row[10], measure::Stage::approach);
  EXPECT_EQ(stages.of_row[100], measure::Stage::loading);
}

TEST(Stages, AHoldAnUnloadingAndALoopAreTold) {
  auto s = particle(0, 0);
  const auto add = [&](double x, double F) {
    s.travel_m.push_back(x), s.force_N.push_back(F), s.line.push_back(0);
  };
  const double x = s.travel_m.back(), F = s.force_N.back();
  for (int i = 0; i < 30; ++i) add(x, F);
  for (int i = 1; i < 20; ++i) add(x - 0.5e-6 * i, F * (1 - 0.05 * i));
  for (int i = 18; i > 0; --i) add(x - 0.5e-6 * i, F * (1 - 0.05 * i));
  for (int i = 0; i < 20; ++i) add(x + 1e-6 * i, F + 1e-2 * i);
  for (int i = 1; i < 20; ++i) add(x + 19e-6 - 0.5e-6 * i, F * (1 - 0.05 * i));
  const auto stages = stages_of(s);
  EXPECT_EQ(stages.holds, 1);
  EXPECT_EQ(stages.unloadings, 2);
  EXPECT_EQ(stages.loops, 1);
  EXPECT_FALSE(stages.broke);
}

TEST(Machine, ABentLineIsTakenByPoints) {
  Measurement m{"f", "", "", {}, {}};
  measure::Specimen s;
  for (int i = 0; i < 400; ++i) {
    const double F = 0.2 * i;
    s.force_N.push_back(F);
    s.travel_m.push_back(0.3e-6 * F + 4e-6 * (1 - std::exp(-F / 10))); // a toe, then 0.3 um/N
  }
  m.specimens.push_back(s);
  const auto machine = measure::empty_machine(m);
  EXPECT_FALSE(machine.force_N.empty());
  for (double F : {20.0, 40.0, 70.0})
    EXPECT_NEAR(machine.travel(F) - machine.travel(10),
                0.3e-6 * (F - 10) + 4e-6 * (std::exp(-1) - std::exp(-F / 10)), 0.15e-6);
}

} // namespace
