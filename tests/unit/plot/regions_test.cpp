#include "plot/regions.hpp"

#include "section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace platen {
namespace {

double area_of_colour(const std::vector<plot::Region>& regions, int colour) {
  double sum = 0;
  for (const auto& region : regions)
    if (region.colour == colour) sum += region.area;
  return sum;
}

TEST(Regions, OneColourIsOneRingWithTheAreaOfTheDisc) {
  const auto snapshot = test::quarter_disc(64, 0, [](double, double) { return press::Zone::elastic; });
  const auto regions = plot::regions(plot::full_section(snapshot, [](auto, auto) { return 2; }));
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].colour, 2);
  EXPECT_NEAR(regions[0].area, std::numbers::pi, 1e-3); // a polygon of 512 sides: pi (1 - (2 pi/512)^2/6)
  EXPECT_EQ(regions[0].ring.size(), 1024u);             // corners and the middles between them
}

TEST(Regions, APatchOnTheAxisAndOneOffItAreMirroredToOneAndFourRings) {
  const auto snapshot = test::quarter_disc(20, 0, [](double r, double z) {
    return std::hypot(r, z) < 0.2 || std::hypot(r - 0.5, z - 0.5) < 0.1 ? press::Zone::shear
                                                                        : press::Zone::elastic;
  });
  const auto regions = plot::regions(plot::full_section(snapshot, [&](auto element, auto corner) {
    return static_cast<int>(snapshot.zones[element][corner]);
  }));
  EXPECT_EQ(std::count_if(regions.begin(), regions.end(), [](const auto& r) { return r.colour == 1; }), 5);
  EXPECT_EQ(regions.front().colour, 0); // what surrounds comes first, what it surrounds is painted over it
}

TEST(Regions, CellsThatTouchInACornerKeepTheirOwnRings) {
  const auto snapshot = test::quarter_disc(4, 0, [](double r, double z) {
    return (static_cast<int>(8 * r) + static_cast<int>(8 * z)) % 2 ? press::Zone::shear
                                                                   : press::Zone::tension;
  });
  const auto regions = plot::regions(plot::full_section(snapshot, [&](auto element, auto corner) {
    return static_cast<int>(snapshot.zones[element][corner]);
  }));
  const auto whole = plot::regions(plot::full_section(snapshot, [](auto, auto) { return 0; }));
  EXPECT_NEAR(area_of_colour(regions, 1) + area_of_colour(regions, 3), whole.at(0).area, 1e-12);
  for (const auto& region : regions) EXPECT_GE(region.ring.size(), 4u);
}

TEST(Simplified, DropsVerticesOnStraightLinesAndKeepsCorners) {
  const std::vector<plot::Point> ring = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  const auto result = plot::simplified(ring, 1e-9);
  ASSERT_EQ(result.size(), 4u);
  EXPECT_EQ(result[1].x, 2);
  EXPECT_EQ(result[1].y, 0);
}

TEST(Simplified, StaysWithinItsTolerance) {
  std::vector<plot::Point> ring;
  for (int i = 0; i < 360; ++i)
    ring.push_back({100 * std::cos(i * std::numbers::pi / 180), 100 * std::sin(i * std::numbers::pi / 180)});
  const auto result = plot::simplified(ring, 0.1);
  EXPECT_LT(result.size(), 120u);
  for (std::size_t i = 0; i < result.size(); ++i) { // the sagitta of each chord
    const auto &a = result[i], &b = result[(i + 1) % result.size()];
    EXPECT_GE(std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2), 100 - 0.11);
  }
}

} // namespace
} // namespace platen
