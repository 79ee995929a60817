// What docs/laws/edmans-sinka.md says of the contact radius, asked of the presses in the catalogue.

#include "fit/contact_radius.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "study/pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace platen {
namespace {

/// Of the law's contact radius against the press, from delta_bar = 0.005 on.
struct Error {
  double largest = 0, at_three_tenths = 0, relative_l2 = 0;
};

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<long>(values.size() / 2));
  return values[values.size() / 2];
}

/// With the radius that `derive` and `fit` write into a card, or as a card without one has it.
std::vector<Error> errors(const char* pool, bool written) {
  std::vector<Error> list;
  for (const auto& rows :
       study::read_pool(std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue/pools" / pool).curves) {
    press::Curve curve;
    curve.radius_m = 1;
    for (const auto& row : rows) // branch_id, delta_bar, F_bar, a_bar
      if (row[0] == 0) {
        press::CurvePoint point;
        point.delta_bar = point.delta_m = row[1], point.F_bar = row[2], point.contact_radius_m = row[3];
        curve.points.push_back(point);
      }
    if (curve.points.empty()) continue;
    law::EdmansSinkaMaterial m;
    m.sigma_ref = 1e6, m.E = 1e8, m.k = 4, m.delta_t = 0.1, m.a = 3; // no part in the radius
    const auto fit = fit::fit_contact_radius(curve);
    if (written) {
      m.radii = static_cast<int>(fit.a_bar.size());
      std::ranges::copy(fit.delta_bar, m.radius_delta_bar);
      std::ranges::copy(fit.a_bar, m.a_bar);
    }
    const auto law = law::prepare_on_rigid_plane(m, 1);
    Error e;
    e.relative_l2 = fit.relative_l2;
    for (const auto& p : curve.points)
      if (p.delta_bar >= 0.005 && p.delta_bar <= 0.5) {
        const double error = law.loading(p.delta_bar).a / p.contact_radius_m - 1;
        e.largest = std::max(e.largest, std::abs(error));
        if (std::abs(p.delta_bar - 0.3) < 1e-9) e.at_three_tenths = error;
      }
    EXPECT_TRUE(!written || std::abs(fit.largest - e.largest) < 1e-9);
    list.push_back(e);
  }
  return list;
}

std::vector<double> each(const std::vector<Error>& errors, double Error::*what) {
  std::vector<double> values;
  for (const auto& e : errors) values.push_back(e.*what);
  return values;
}

TEST(ContactRadius, OfEdmansSinkaIsThatOfThePress) {
  for (const char* pool : {"edmans-sinka", "von-mises", "metals"}) {
    const auto errors_of_pool = errors(pool, true);
    const auto largest = each(errors_of_pool, &Error::largest),
               l2 = each(errors_of_pool, &Error::relative_l2);
    ASSERT_GE(largest.size(), 28u);
    EXPECT_LE(median(largest), 0.01) << pool;
    EXPECT_LE(*std::ranges::max_element(largest), 0.02) << pool;
    EXPECT_LE(median(l2), 0.004) << pool;
    EXPECT_LE(*std::ranges::max_element(l2), 0.009) << pool;
  }
}

TEST(ContactRadius, OfACardWithoutOneIsThatOfAMetal) {
  const auto metals = errors("metals", false), granules = errors("edmans-sinka", false);
  EXPECT_NEAR(median(each(metals, &Error::at_three_tenths)), 0.05, 0.01);
  EXPECT_NEAR(median(each(granules, &Error::at_three_tenths)), 0.12, 0.01);
}

} // namespace
} // namespace platen
