#include "core/csv.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

using namespace platen::core;

namespace {

std::string message(auto action) {
  try {
    action();
  } catch (const InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

} // namespace

TEST(Csv, HasNotesColumnsAndRows) {
  const Csv csv = parse_csv("# radius_m = 1e-3\n# a remark\n\ndelta_m, force_N\r\n0,0\n1e-5,0.25\n", "c.csv");
  EXPECT_EQ(csv.number_note("radius_m"), 1e-3);
  EXPECT_EQ(csv.rows.size(), 2u);
  EXPECT_EQ(csv.number(csv.rows[1], csv.column("force_N")), 0.25);
}

TEST(Csv, SaysWhereACellIsWrong) {
  const Csv csv = parse_csv("delta_m,force_N\n0,0\n1,1e999\n", "c.csv");
  EXPECT_EQ(message([&] { (void)csv.number(csv.rows[1], 1); }),
            "c.csv, line 3, column force_N: \"1e999\" is not a finite number");
  EXPECT_EQ(message([&] { (void)parse_csv("a,b\n1,2\n1,2,3\n", "c.csv"); }),
            "c.csv, line 3: 3 cells where the header has 2 columns");
}

TEST(Csv, NamesTheNearestColumn) {
  const Csv csv = parse_csv("delta_mm,force_N\n", "c.csv");
  EXPECT_EQ(message([&] { (void)csv.column("delta_m"); }),
            "c.csv: column delta_m is missing; the nearest one there is \"delta_mm\"");
}

TEST(Csv, WithoutAHeaderOrWithAColumnTwiceIsRefused) {
  EXPECT_EQ(message([] { (void)parse_csv("# a = 1\n", "c.csv"); }),
            "c.csv: no header line with the names of the columns");
  EXPECT_EQ(message([] { (void)parse_csv("a,a\n", "c.csv"); }),
            "c.csv, line 1: column \"a\" stands there twice");
}
