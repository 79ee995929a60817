#include "reproduce/numbers.hpp"
#include "reproduce/page.hpp"

#include "core/file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

using namespace platen;
using reproduce::Comparison, reproduce::Measure, reproduce::Paper, reproduce::Row;

namespace {

Paper paper(double ours, double error, Measure measure = Measure::relative) {
  Row row{"t-1",
          "Fig. 1",
          "force, a test",
          "",
          "",
          "",
          {{"force, N", 10, ours, measure == Measure::relative ? 0.1 : 1, measure, error}}};
  Row map{"t-2", "Fig. 2", "map", "", "", "there is no number", {}};
  return {"test", "A test: of pages", "", "", {row, map}};
}

reproduce::Earlier kept(const Paper& p) {
  const auto file =
      std::filesystem::temp_directory_path() / ("platen-numbers-" + std::to_string(::getpid()) + ".csv");
  core::write_file(file, reproduce::numbers_csv({p}));
  auto earlier = reproduce::read_numbers(file);
  std::filesystem::remove(file);
  return earlier;
}

} // namespace

TEST(Numbers, OfTheSamePageAreUnchanged) {
  const Paper p = paper(10.123456789, 1e-9);
  EXPECT_TRUE(reproduce::changes({p}, kept(p)).empty());
}

TEST(Numbers, MarkWhatMovedByMoreThanItsErrorAlone) {
  const auto earlier = kept(paper(10.0, 0.015));
  EXPECT_TRUE(reproduce::changes({paper(10.14, 0.015)}, earlier).empty());
  const auto moved = reproduce::changes({paper(10.16, 0.015)}, earlier);
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].row, "t-1");
  EXPECT_NEAR(moved[0].now - moved[0].before, 0.016, 1e-6);
}

TEST(Numbers, OfAbsoluteMeasureMoveInTheirUnit) {
  const auto earlier = kept(paper(10.0, 0.015, Measure::absolute));
  EXPECT_TRUE(reproduce::changes({paper(10.14, 0.015, Measure::absolute)}, earlier).empty());
  EXPECT_EQ(reproduce::changes({paper(10.16, 0.015, Measure::absolute)}, earlier).size(), 1u);
}

TEST(Numbers, MarkAVerdictThatTurned) {
  const auto earlier = kept(paper(10.99, 0.05)); // reproduced, 9.9 %
  const auto turned = reproduce::changes({paper(11.02, 0.05)}, earlier);
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_EQ(turned[0].verdict_before, "reproduced");
  EXPECT_EQ(turned[0].verdict_now, "differs");
}

TEST(Tally, CountsRowsWithANumberApart) {
  const auto t = reproduce::tally(paper(10, 0.1).rows);
  EXPECT_EQ(t.rows, 2u);
  EXPECT_EQ(t.reproduced, 1u);
  EXPECT_EQ(t.not_comparable, 1u);
  EXPECT_EQ(t.with_number, 1u);
}
