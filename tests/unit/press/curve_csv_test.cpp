#include "press/curve_csv.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <numbers>

using namespace platen;
using press::Branch, press::Curve, press::parse_curve;

namespace {

Curve curve() {
  Curve c{1e-3, 1e6, 1e8, 0.3, "simple", "steel, soft", "0.1.0", 1, {}};
  for (int i = 0; i < 3; ++i) {
    press::CurvePoint p;
    p.branch_id = i / 2;
    p.branch = i == 2 ? Branch::unloading : Branch::loading;
    p.delta_bar = 0.1 * i / 3;
    p.delta_m = p.delta_bar * c.radius_m;
    p.force_N = 0.7 * i;
    p.F_bar = p.force_N / (std::numbers::pi * 1e-6 * 1e6);
    p.rho_r_min = 0.6 + 1e-17 * i;
    p.iterations = i;
    c.points.push_back(p);
  }
  return c;
}

std::string refusal(const std::string& text) {
  try {
    (void)parse_curve(text, "c.csv");
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

} // namespace

TEST(CurveCsv, HasTheAgreedColumns) {
  const std::string text = press::curve_csv(curve());
  EXPECT_NE(
      text.find(
          "\nbranch_id,branch,delta_m,delta_bar,force_N,F_bar,contact_radius_m,mean_pressure_Pa,"
          "peak_pressure_Pa,zone_elastic,zone_shear,zone_compaction,zone_tension,work_J,stored_J,"
          "dissipated_J,rho_r_mean,rho_r_min,rho_r_max,sigma_1_max_Pa,equator_displacement_m,iterations,"
          "hertz_delta_m,mises_max_Pa\n"),
      std::string::npos);
  EXPECT_TRUE(text.starts_with("# radius_m = 0.001\n# sigma_ref_Pa = 1e6\n"));
}

TEST(CurveCsv, IsReadAsItWasWritten) {
  const Curve before = curve(), after = parse_curve(press::curve_csv(before), "c.csv");
  EXPECT_EQ(after.radius_m, before.radius_m);
  EXPECT_EQ(after.sigma_ref_Pa, before.sigma_ref_Pa);
  EXPECT_EQ(after.E_Pa, before.E_Pa);
  EXPECT_EQ(after.nu, before.nu);
  EXPECT_EQ(after.material, before.material);
  EXPECT_EQ(after.version, before.version);
  EXPECT_EQ(after.engine, before.engine);
  EXPECT_EQ(press::curve_csv(after), press::curve_csv(before));
}

TEST(CurveCsv, MeasuredWithTwoColumnsNeedsARadius) {
  const std::string measured = "delta_m,force_N\n0,0\n1e-5,0.25\n";
  const Curve c = parse_curve(measured, "c.csv", 1e-3);
  EXPECT_DOUBLE_EQ(c.points[1].delta_bar, 0.01);
  EXPECT_EQ(c.points[1].force_N, 0.25);
  EXPECT_NE(refusal(measured).find("give it with --radius_m"), std::string::npos);
  EXPECT_NO_THROW((void)parse_curve("# radius_m = 1e-3\n" + measured, "c.csv", 1e-3));
  EXPECT_THROW((void)parse_curve("# radius_m = 1e-3\n" + measured, "c.csv", 2e-3), core::InvalidInput);
  EXPECT_NE(refusal("# radius_m = -1\n" + measured).find("must be > 0"), std::string::npos);
}

TEST(CurveCsv, SaysWhereItIsWrong) {
  EXPECT_EQ(refusal("# radius_m = 1e-3\ndelta_m,force_N\n0,0\n1e-5,oops\n"),
            "c.csv, line 4, column force_N: \"oops\" is not a finite number");
  EXPECT_EQ(refusal("# radius_m = 1e-3\ndelta_m,force\n0,0\n"),
            "c.csv: column force_N is missing; the nearest one there is \"force\"");
  EXPECT_EQ(refusal("# radius_m = 1e-3\nbranch,delta_m,force_N\nup,0,0\n"),
            "c.csv, line 3, column branch: 'up' is not loading, unloading or reloading");
  EXPECT_EQ(refusal("# radius_m = 1e-3\ndelta_m,force_N\n0,0\n"), "c.csv: 1 rows; a curve has at least 2");
}
