// The law `pressed` of every curve of two pools, as their curves.csv has them, against that curve: what
// docs/laws/pressed.md says of all 188, and that the law is sound.

#include "fit/pressed.hpp"
#include "material/models.hpp"
#include "study/pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace platen {
namespace {

press::Curve curve_of(const study::Pool& pool, std::size_t run) {
  const auto& model = pool.study.runs[run].press_case.material.model;
  press::Curve curve;
  curve.radius_m = 1;
  curve.E_Pa = material::initial_E(model);
  curve.nu = material::initial_nu(model);
  curve.sigma_ref_Pa = material::reference_stress(model);
  for (const auto& row : pool.curves[run]) { // branch_id, delta_bar, F_bar, a_bar
    press::CurvePoint point;
    point.branch_id = static_cast<int>(row[0]);
    point.branch = point.branch_id == 0 ? press::Branch::loading : press::Branch::unloading;
    point.delta_bar = point.delta_m = row[1];
    point.F_bar = row[2];
    point.contact_radius_m = row[3];
    curve.points.push_back(point);
  }
  return curve;
}

/// Force never falls, its slope does not jump, no loop gives back more than it took, and the law holds to its
/// last knot and no farther.
void expect_sound(const law::PressedMaterial& material) {
  const law::Law law = law::tabulate(law::prepare_on_rigid_plane(material, 1));
  const double end = material.delta_bar.back();
  double last = 0;
  for (double x = 1e-5; x < 2 * end; x *= 1.01) {
    const law::Response now = law::evaluate(law, {}, x);
    ASSERT_GE(now.force, last) << x;
    ASSERT_EQ(now.in_range, x <= end * (1 + 1e-9)) << x;
    last = now.force;
    const double beside = law::evaluate(law, {}, x * (1 + 1e-9)).stiffness;
    ASSERT_NEAR(beside, now.stiffness, 1e-3 * now.stiffness) << x;
  }
  constexpr int steps = 400;
  for (const double top : {0.01 * end, 0.1 * end, 0.5 * end, end}) {
    law::State state;
    double work = 0, before = 0;
    const double largest = law::evaluate(law, {}, top).force * top;
    for (int k = 1; k <= 2 * steps; ++k) { // up, and back to nothing
      const double overlap = top * (k <= steps ? k : 2 * steps - k) / steps;
      const law::Response now = law::evaluate(law, state, overlap);
      work += (now.force + before) / 2 * (overlap - state.gamma);
      before = now.force, state = now.state;
    }
    ASSERT_GE(work, -1e-5 * largest) << top; // of an elastic one nothing but the rounding of trapezoids
  }
}

double median(std::vector<double> of) {
  std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2), of.end());
  return of[of.size() / 2];
}

TEST(PressedPools, EveryCurveIsItsLawAsTheDocumentSays) {
  std::vector<double> force, worst, radius, work;
  std::vector<law::PressedMaterial> materials;
  for (const char* name : {"edmans-sinka", "von-mises"}) {
    const auto pool = study::read_pool(std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools" / name);
    for (std::size_t run = 0; run < pool.curves.size(); ++run) {
      const auto curve = curve_of(pool, run);
      const auto fit = fit::fit_pressed(curve, fit::fit_unloading(curve));
      force.push_back(fit.errors.relative_l2);
      worst.push_back(fit.errors.worst);
      radius.push_back(fit.errors.radius);
      work.push_back(fit.errors.unload_work);
      expect_sound(fit.material);
      materials.push_back(fit.material);
      ASSERT_FALSE(::testing::Test::HasFailure()) << name << ", run " << run + 1;
    }
  }
  ASSERT_EQ(force.size(), 188u);
  const auto most = [](const std::vector<double>& v) { return *std::max_element(v.begin(), v.end()); };
  const auto within_2 = std::count_if(work.begin(), work.end(), [](double e) { return e <= 0.02; });
  std::printf(
      "median, largest: force %.2e %.2e, worst point %.2e %.2e, radius %.2e %.2e, work %.2e %.2e; work "
      "within 2 %%: %d\n",
      median(force), most(force), median(worst), most(worst), median(radius), most(radius), median(work),
      most(work), static_cast<int>(within_2));
  EXPECT_LE(most(force), 0.0011);
  EXPECT_LE(most(worst), 0.0021);
  EXPECT_LE(most(radius), 0.005);
  EXPECT_LE(most(work), 0.052);
  EXPECT_GE(within_2, 173);

  // Of 100 of these materials 4,950 tables, as a DEM code makes them for unlike bodies.
  double bytes = 0;
  constexpr std::size_t pairs = 94;
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto &one = materials[2 * i], &two = materials[(2 * i + 61) % materials.size()];
    bytes += static_cast<double>(law::tabulate(prepare(one, 1, two, 1), law::joined_table).table->bytes());
  }
  std::printf("a table of two: %.1f kB\n", bytes / pairs / 1e3);
  EXPECT_LE(bytes / pairs * 4950, 40e6);
}

} // namespace
} // namespace platen
