#include "fe/quarter_disc.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

TEST(QuarterDisc, HasElementsOfGoodShape) {
  for (const int elements : {40, 200, 600, 2500}) {
    const auto mesh = fe::quarter_disc(elements);
    const auto q = fe::quality(mesh, std::vector<double>(2 * mesh.nodes.size()));
    EXPECT_GT(q.least, 0.06) << elements; // three columns on one: a corner is nearly straight
    EXPECT_GT(q.mean, 0.8) << elements;
  }
}

TEST(QuarterDisc, QualityIsTheSineOfTheWorstCorner) {
  fe::SectionMesh square;
  square.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.elements = {{0, 1, 2, 3}};
  std::vector<double> u(8);
  EXPECT_DOUBLE_EQ(fe::quality(square, u).least, 1);
  u[4] = -0.25, u[5] = -0.25; // still convex
  EXPECT_NEAR(fe::quality(square, u).least, 0.8, 1e-12);
  u[4] = -0.75, u[5] = -0.75; // the third corner behind the diagonal: folded there
  EXPECT_NEAR(fe::quality(square, u).least, -0.8, 1e-12);
}
