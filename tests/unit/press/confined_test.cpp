// The confined presses on small meshes: what must hold whatever the mesh.

#include "press/press.hpp"

#include "core/error.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/curve_csv.hpp"
#include "press/fields_vtu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace platen;

namespace {

template <class X> press::Case small_case(X e) {
  e.elements = 200;
  return {{"steel", material::VonMises{200, 0.3, 1}, {}}, 1, e};
}
template <class X> press::Case small_case(double delta_bar_max) {
  X e;
  e.delta_bar_max = delta_bar_max;
  return small_case(e);
}

std::string message_of(const char* card) {
  try {
    (void)press::read_case(core::parse_toml(card, "case.toml"));
  } catch (const core::InvalidInput& problem) { return problem.what(); }
  return "";
}

} // namespace

TEST(Confined, WorkIsStoredOrDissipated) {
  for (const auto& c : {small_case<press::Simple>(0.06), small_case<press::Die>(0.06),
                        small_case<press::Hydrostatic>(0.06)}) {
    const bool simple = std::holds_alternative<press::Simple>(c.experiment);
    const auto result = simple ? press::press_in_space(c) : press::press(c);
    EXPECT_FALSE(result.failure) << *result.failure;
    const auto& end = result.curve.points.back();
    EXPECT_NEAR((end.stored_J + end.dissipated_J) / end.work_J, 1, 0.01) << name_of(c.experiment);
    EXPECT_GT(end.dissipated_J, 0.3 * end.work_J);
  }
}

TEST(Confined, MorePlanesPushBackHarder) {
  const double simple = press::press_in_space(small_case<press::Simple>(0.16)).curve.points.back().force_N;
  const auto die = press::press(small_case<press::Die>(0.16)).curve.points.back();
  const auto hydrostatic = press::press(small_case<press::Hydrostatic>(0.16)).curve.points.back();
  EXPECT_GT(die.force_N, simple);
  EXPECT_GT(hydrostatic.force_N, die.force_N);
  EXPECT_GT(die.side[0].force_N, 0);
  EXPECT_EQ(die.side[0].force_N, die.side[1].force_N);
  EXPECT_EQ(hydrostatic.force_N, hydrostatic.side[0].force_N);
  EXPECT_LT(die.side[0].force_N, die.force_N);
}

TEST(Confined, TriaxialContainsTheOthers) {
  // The octant is another mesh than the wedges: equal up to discretisation.
  const auto hydrostatic = press::press(small_case<press::Hydrostatic>(0.1)).curve.points.back();
  press::Triaxial e;
  e.delta_bar_z = e.delta_bar_x = e.delta_bar_y = {0.1};
  const auto same = press::press(small_case(e)).curve.points.back();
  EXPECT_NEAR(same.force_N / hydrostatic.force_N, 1, 1e-9); // the same wedge
  e.delta_bar_y = {0.1 * (1 - 1e-9)};
  const auto octant = press::press(small_case(e)).curve.points.back();
  EXPECT_NEAR(octant.force_N / hydrostatic.force_N, 1, 0.08);
  EXPECT_NEAR(octant.side[0].force_N / octant.force_N, 1, 0.02);
  EXPECT_NEAR(octant.side[1].force_N / octant.force_N, 1, 0.02);
}

TEST(Confined, HistoriesTurnAndPlanesMayBeAbsent) {
  press::Triaxial e;
  e.delta_bar_z = {0.05, 0.05, 0.045};
  e.delta_bar_x = {0, 0.04, 0.04};
  EXPECT_NEAR(press::path_length(e), 0.05 + 0.04 + 0.005, 1e-15);
  const auto result = press::press(small_case(e));
  ASSERT_FALSE(result.failure) << *result.failure;
  double first_x = 0;
  for (const auto& p : result.curve.points) {
    EXPECT_EQ(p.side[1].force_N, 0); // no planes along y
    EXPECT_EQ(p.cell_filling, 0);
    if (p.side[0].delta_m == 0 && p.branch == press::Branch::loading) first_x = p.side[0].force_N;
  }
  const auto& end = result.curve.points.back();
  EXPECT_GT(end.side[0].force_N, 5 * first_x);
  EXPECT_EQ(end.branch, press::Branch::unloading);
  double most = 0;
  for (const auto& p : result.curve.points) most = std::max(most, p.force_N);
  EXPECT_LT(end.force_N, 0.5 * most);
}

TEST(Confined, UnloadsToNothingAndLoadsAgain) {
  press::Die e;
  e.delta_bar_max = 0.1;
  e.unload_from = {0.1};
  e.reload = true;
  const auto result = press::press(small_case(e));
  ASSERT_FALSE(result.failure);
  double top = 0, least = 1e9, again = 0, work = 0;
  for (const auto& p : result.curve.points) {
    if (p.branch == press::Branch::loading) top = p.force_N;
    if (p.branch == press::Branch::unloading) least = std::min(least, p.force_N);
    if (p.branch == press::Branch::reloading) again = p.force_N, work = p.work_J;
  }
  EXPECT_LT(least, 0.01 * top);
  EXPECT_NEAR(again / top, 1, 0.02);
  EXPECT_GT(work, 0);
}

TEST(Confined, CurveAndFieldsAreWhole) {
  press::Die e;
  e.delta_bar_max = 0.05;
  e.fields_at = {0.05};
  const auto result = press::press(small_case(e));
  const auto back = press::parse_curve(press::curve_csv(result.curve), "curve.csv", {});
  ASSERT_EQ(back.points.size(), result.curve.points.size());
  EXPECT_EQ(back.points.back().side[0].force_N, result.curve.points.back().side[0].force_N);
  EXPECT_EQ(back.points.back().cell_filling, result.curve.points.back().cell_filling);
  ASSERT_EQ(result.spatial.size(), 1u);
  const std::string vtu = press::fields_vtu(result.spatial[0], 1);
  EXPECT_NE(vtu.find("</VTKFile>"), std::string::npos);
  // The force is the pressure over the faces, eight wedges to a plane.
  const auto& s = result.spatial[0];
  EXPECT_EQ(s.copies.size(), 16u);
  EXPECT_NEAR(s.plane[2], 0.95, 1e-15);
}

TEST(Confined, CellAndItsEnds) {
  EXPECT_NEAR(press::die_zero_porosity, 0.4764012, 1e-7);
  EXPECT_NEAR(press::hydrostatic_zero_porosity(), 0.1940040, 1e-7);
  EXPECT_NEAR(press::cell_volume({0, 0, press::die_zero_porosity}), 1, 1e-12);
  const double d = press::hydrostatic_zero_porosity();
  EXPECT_NEAR(press::cell_volume({d, d, d}), 1, 1e-12);
}

TEST(Confined, CardsSayWhatIsWrong) {
  const std::string head = "platen = 1\nradius_m = 1e-3\nmaterial = \"von-mises-100\"\n";
  const auto message = [&](const std::string& rest) { return message_of((head + rest).c_str()); };
  EXPECT_EQ(message("experiment = \"die\""), "");
  EXPECT_EQ(message("experiment = \"triaxial\"\n[path]\ndelta_bar = [0.1, 0.05]\n"), "");
  EXPECT_NE(message("experiment = \"die\"\n[path]\ndelta_bar_max = 0.6").find("0.764 of the volume"),
            std::string::npos);
  EXPECT_NE(message("experiment = \"hydrostatic\"\n[path]\ndelta_bar_max = 0.3").find("goes down to 0.9"),
            std::string::npos);
  EXPECT_NE(message("experiment = \"triaxial\"").find("needs [path] delta_bar"), std::string::npos);
  EXPECT_NE(message("experiment = \"triaxial\"\n[path]\ndelta_bar = [0.1, 0.1]\n").find("waypoint 2 nothing"),
            std::string::npos);
  EXPECT_NE(message("experiment = \"triaxial\"\n[path]\ndelta_bar = [0.1]\ndelta_bar_x = [0.1, 0.2]\n")
                .find("give as many"),
            std::string::npos);
  EXPECT_NE(message("experiment = \"triaxial\"\n[path]\ndelta_bar = [-0.1]\n"), "");
  EXPECT_NE(
      message("experiment = \"triaxial\"\n[path]\ndelta_bar = [0.4]\ndelta_bar_x = [0.4]\ndelta_bar_y = "
              "[0.4]\n"),
      "");
  EXPECT_NE(message("experiment = \"diel\"").find("die"), std::string::npos);
}
