#include "reproduce/row.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;
using reproduce::Comparison, reproduce::Measure, reproduce::Row, reproduce::Verdict;

namespace {

Row with(std::vector<Comparison> comparisons, std::string because = "") {
  Row row;
  row.id = "t-1";
  row.because = std::move(because);
  row.comparisons = std::move(comparisons);
  return row;
}

} // namespace

TEST(Verdict, IsReproducedOnlyWhereEveryNumberIsWithinItsTolerance) {
  const Comparison inside{"force", 10, 10.9, 0.1}, outside{"radius", 10, 8.9, 0.1};
  EXPECT_EQ(reproduce::verdict(with({inside})), Verdict::reproduced);
  EXPECT_EQ(reproduce::verdict(with({inside, outside})), Verdict::differs);
  EXPECT_EQ(reproduce::verdict(with({outside, inside})), Verdict::differs);
}

TEST(Verdict, NeedsAReasonWhereThereIsNoNumber) {
  EXPECT_EQ(reproduce::verdict(with({}, "it is a map")), Verdict::not_comparable);
  EXPECT_EQ(reproduce::sentence(with({}, "it is a map")), "cannot be compared, because it is a map");
  EXPECT_THROW(reproduce::verdict(with({})), core::InvalidInput);
}

TEST(Verdict, IsNeverReproducedByAReasonAlone) {
  EXPECT_EQ(reproduce::verdict(with({{"force", 10, 20, 0.1}}, "theirs is misprinted")), Verdict::differs);
}

TEST(Verdict, DiffersWhereANumberIsMissing) {
  EXPECT_EQ(reproduce::verdict(with({{"force", 10, std::nan(""), 0.1}})), Verdict::differs);
  EXPECT_EQ(reproduce::verdict(with({{"force", std::nan(""), 10, 0.1}})), Verdict::differs);
  EXPECT_EQ(reproduce::verdict(with({{"force", 0, 1e-9, 0.1}})),
            Verdict::differs); // no relative difference from nothing
}

TEST(Difference, IsRelativeToTheSizeOfThePapersNumberOrInItsUnit) {
  EXPECT_DOUBLE_EQ(reproduce::difference({"", -4, -5, 0.1}), -0.25);
  EXPECT_DOUBLE_EQ(reproduce::difference({"", 0.3, 0.25, 0.1, Measure::absolute}), -0.05);
  EXPECT_TRUE(reproduce::agrees({"", 0.3, 0.25, 0.06, Measure::absolute}));
  EXPECT_FALSE(reproduce::agrees({"", 0.3, 0.25, 0.04, Measure::absolute}));
}

TEST(Sentence, NamesTheComparisonFurthestOutsideItsTolerance) {
  const Row row = with({{"force", 10, 11.5, 0.1}, {"radius", 10, 11, 0.02}}); // 1.5 and 5 tolerances
  EXPECT_EQ(reproduce::sentence(row), "differs by +10 %: radius");
}

TEST(Overlay, IsTheComparisonWhereTheCurvesAreFurthestApart) {
  const auto c = reproduce::overlay("F", "x", {1, 2, 3}, {10, 20, 30}, {10.5, 26, 31}, 0.1, 0);
  EXPECT_DOUBLE_EQ(c.theirs, 20);
  EXPECT_DOUBLE_EQ(c.ours, 26);
  EXPECT_FALSE(reproduce::agrees(c));
  EXPECT_NE(c.what.find("x = 2"), std::string::npos);
}

TEST(Overlay, DoesNotHideAPointThatIsNoNumber) {
  const auto c = reproduce::overlay("F", "x", {1, 2, 3}, {10, 20, 30}, {10, std::nan(""), 60}, 5, 0);
  EXPECT_FALSE(reproduce::agrees(c));
}

TEST(Overlay, RefusesCurvesThatDoNotBelongTogether) {
  EXPECT_THROW(reproduce::overlay("F", "x", {1, 2}, {1}, {1, 2}, 0.1, 0), core::InvalidInput);
  EXPECT_THROW(reproduce::overlay("F", "x", {}, {}, {}, 0.1, 0), core::InvalidInput);
}
