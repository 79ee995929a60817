#include "core/fields.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

using namespace platen::core;

namespace {

struct Sphere {
  double radius_m = 1, E_Pa = 0, sigma_y_Pa = 0;
  int elements = 10;
  bool smooth = true;
  std::string name = "none";
  std::vector<double> stops;
};

const std::vector<Field<Sphere>> fields = {
    {"radius_m", &Sphere::radius_m, "radius", positive},
    Field<Sphere>{"E_Pa", &Sphere::E_Pa, "modulus", positive}.or_ratio("E_bar", "sigma_y_Pa"),
    {"sigma_y_Pa", &Sphere::sigma_y_Pa, "yield stress", positive},
    Field<Sphere>{"elements", &Sphere::elements, "how many", closed(1, 100)}.optional(),
    Field<Sphere>{"smooth", &Sphere::smooth, "polished"}.optional(),
    Field<Sphere>{"name", &Sphere::name, "for people"}.optional(),
    Field<Sphere>{"stops", &Sphere::stops, "where to stop", left_open(0, 0.5)}.optional().growing(),
};
const std::string good = "radius_m = 1e-3\nsigma_y_Pa = 1e6\n";

Sphere read(const std::string& text) { return read_fields<Sphere>(parse_toml(text, "s.toml"), fields); }

std::string refusal(const std::string& text) {
  try {
    (void)read(text);
  } catch (const InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

} // namespace

TEST(Fields, AreReadFromTheirSection) {
  const Sphere s =
      read(good + "E_Pa = 5e7\nelements = 20\nsmooth = false\nname = \"x\"\nstops = [0.1, 0.5]\n");
  EXPECT_EQ(s.radius_m, 1e-3);
  EXPECT_EQ(s.E_Pa, 5e7);
  EXPECT_EQ(s.elements, 20);
  EXPECT_FALSE(s.smooth);
  EXPECT_EQ(s.name, "x");
  EXPECT_EQ(s.stops, (std::vector{0.1, 0.5}));
}

TEST(Fields, ThatMayBeLeftOutKeepTheirDefault) {
  const Sphere s = read(good + "E_Pa = 1e8");
  EXPECT_EQ(s.elements, 10);
  EXPECT_EQ(s.name, "none");
}

TEST(Fields, MayBeGivenAsARatio) { EXPECT_EQ(read(good + "E_bar = 50").E_Pa, 5e7); }

TEST(Fields, GivenBothWaysOrNeitherAreRefused) {
  EXPECT_EQ(refusal(good + "E_Pa = 1e8\nE_bar = 100"),
            "s.toml, line 4: E_bar: given as well as E_Pa; exactly one of the two is allowed");
  EXPECT_EQ(refusal(good), "s.toml, line 1: E_Pa (or E_bar) is missing: modulus, a number > 0");
}

TEST(Fields, InAnotherUnitAreRefusedWithTheConvertedLine) {
  EXPECT_EQ(refusal(good + "E_MPa = 100"),
            "s.toml, line 3: E_MPa = 100 is not in SI units; write E_Pa = 1e8");
  EXPECT_EQ(refusal("radius_mm = 1.1"),
            "s.toml, line 1: radius_mm = 1.1 is not in SI units; write radius_m = 0.0011");
  EXPECT_EQ(refusal("radius = 1"), "s.toml, line 1: radius = 1 is not in SI units; write radius_m, in m, or "
                                   "radius = \"1 m\" with its unit");
}

TEST(Fields, MayCarryTheirUnitUnderTheBareName) {
  EXPECT_EQ(read("radius = \"1.5 mm\"\nsigma_y_Pa = 1e6\nE = \"0.1 GPa\"").E_Pa, 1e8);
  EXPECT_EQ(read("radius = \"1.5 mm\"\nsigma_y_Pa = 1e6\nE_bar = 50").radius_m, 1.5e-3);
  EXPECT_EQ(refusal("radius = \"1.5 N\""),
            "s.toml, line 1: radius = \"1.5 N\" is a force; it must be a length, in m, in, cm, mm, um or nm");
  EXPECT_EQ(
      refusal("radius_m = \"1.5 mm\""),
      "s.toml, line 1: radius_m = \"1.5 mm\" has a unit, and the key has one too; write radius = \"1.5 mm\"");
}

TEST(Fields, UnknownOnesAreRefusedWithTheNearestKnownOne) {
  EXPECT_EQ(refusal(good + "elemnts = 3"),
            "s.toml, line 3: elemnts = 3: there is no such key; did you mean 'elements'?");
}

TEST(Fields, OutsideTheirRangeAreRefusedWithTheRange) {
  EXPECT_EQ(refusal("radius_m = -1"),
            "s.toml, line 1: radius_m = -1 is not allowed; it must be a number > 0");
  EXPECT_EQ(refusal("radius_m = nan"),
            "s.toml, line 1: radius_m = nan is not allowed; it must be a number > 0");
  EXPECT_EQ(refusal("radius_m = inf"),
            "s.toml, line 1: radius_m = inf is not allowed; it must be a number > 0");
  EXPECT_EQ(refusal(good + "E_bar = 1\nelements = 101"),
            "s.toml, line 4: elements = 101 is not allowed; it must be a whole number in [1, 100]");
  EXPECT_EQ(refusal(good + "E_bar = 1\nstops = [0.2, 0.1]"),
            "s.toml, line 4: stops = [0.2, 0.1] is not allowed; it must be a list of numbers in (0, 0.5], "
            "each greater "
            "than the one before");
  EXPECT_EQ(refusal("radius_m = 1\nsigma_y_Pa = 1e-300\nE_bar = 1e-300"),
            "s.toml, line 3: E_bar = 1e-300 makes E_Pa = 0, which must be a number > 0");
}

TEST(Fields, OfAnotherTypeAreRefused) {
  EXPECT_EQ(refusal("radius_m = \"1\""), "s.toml, line 1: radius_m = \"1\" is text; it must be a number > 0");
  EXPECT_EQ(refusal(good + "E_bar = 1\nelements = 2.5"),
            "s.toml, line 4: elements = 2.5 is a number; it must be a whole number in [1, 100]");
  EXPECT_EQ(refusal(good + "E_bar = 1\nsmooth = 1"),
            "s.toml, line 4: smooth = 1 is a whole number; it must be true or false");
  EXPECT_EQ(refusal(good + "E_bar = 1\nstops = 1"), "s.toml, line 4: stops = 1 is a whole number; it must be "
                                                    "a list of numbers in (0, 0.5], each greater than "
                                                    "the one before");
}

TEST(Fields, AreWrittenAsTheyAreRead) {
  const Sphere s = read(good + "E_bar = 51.3\nstops = [0.1, 0.3]\nname = \"a \\\"b\\\"\"");
  const Sphere again = read(card_lines(fields, s));
  EXPECT_EQ(again.E_Pa, s.E_Pa);
  EXPECT_EQ(again.stops, s.stops);
  EXPECT_EQ(again.name, s.name);
}

TEST(Toml, ThatIsMalformedIsRefusedWithItsLine) {
  const std::string message = refusal("radius_m = 1\nE_Pa = = 2\n");
  EXPECT_TRUE(message.starts_with("s.toml, line 2, column ")) << message;
  EXPECT_NE(refusal("a = 1979-05-27").find("line 1"), std::string::npos);
}
