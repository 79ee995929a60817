#include "fe/sparse.hpp"

#include <gtest/gtest.h>

using namespace platen::fe;

TEST(DirectSolver, SolvesAgainAfterNewValues) {
  const std::vector<std::vector<int>> elements{{0, 1}, {1, 2}};
  const Pattern pattern = pattern_of(3, elements);
  ASSERT_EQ(pattern.column.size(), 7u);
  DirectSolver solver(pattern, Symmetry::unsymmetric, Ordering::amf);
  for (const double shift : {0.0, 1.0}) {
    // [4+s 1 0; 2 5 1; 0 3 6] x = row sums, so x = (1, 1, 1).
    const std::vector<double> a{4 + shift, 1, 2, 5, 1, 3, 6};
    std::vector<double> x{5 + shift, 8, 9};
    ASSERT_TRUE(solver.factorise(a));
    solver.solve(x);
    for (const double v : x) EXPECT_NEAR(v, 1, 1e-14);
  }
}

TEST(DirectSolver, SaysThatAMatrixIsSingular) {
  const std::vector<std::vector<int>> elements{{0, 1}};
  const Pattern pattern = pattern_of(2, elements);
  DirectSolver solver(pattern, Symmetry::unsymmetric, Ordering::amf);
  EXPECT_FALSE(solver.factorise(std::vector<double>{0, 0, 0, 0}));
}
