#include "reproduce/chart.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;
using reproduce::Chart, reproduce::Mark;

TEST(ChartCsv, KeepsEveryPointUnderTheNameOfItsSeries) {
  const Chart chart{"t",
                    "x (m)",
                    "y (N)",
                    {{"one, two", Mark::line, {1, 2}, {3, 4}}, {"b", Mark::points, {5}, {std::nan("")}}}};
  const auto csv = core::parse_csv(reproduce::csv_text(chart), "t");
  EXPECT_EQ(csv.note("x"), "x (m)");
  ASSERT_EQ(csv.rows.size(), 2u); // what is no number is no row
  EXPECT_EQ(csv.rows[1].cells[0], "one; two");
  EXPECT_EQ(csv.number(csv.rows[1], csv.column("y")), 4);
}

TEST(ChartDrawing, RefusesAChartWithoutAPoint) {
  const Chart chart{"t", "x", "y", {{"a", Mark::line, {-1}, {1}}}, true};
  EXPECT_THROW(reproduce::draw(chart, "nowhere"), core::InvalidInput);
}
