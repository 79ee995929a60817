#include "fe/sparse.hpp"

#include <gtest/gtest.h>

using namespace platen::fe;

TEST(DirectSolver, SolvesAgainAfterNewValues) {
  const std::vector<std::vector<int>> elements{{0, 1}, {1, 2}};
  DirectSolver solver(3, elements, Symmetry::unsymmetric);
  for (const double shift : {0.0, 1.0}) {
    // [4+s 1 0; 2 5 1; 0 3 6] x = row sums, so x = (1, 1, 1). Each element matrix by columns.
    const std::vector<double> a{4 + shift, 2, 1, 3, 2, 3, 1, 6};
    std::vector<double> x{5 + shift, 8, 9};
    ASSERT_TRUE(solver.factorise(a));
    solver.solve(x);
    for (const double v : x) EXPECT_NEAR(v, 1, 1e-14);
  }
}

TEST(DirectSolver, TakesWholeMatricesAlsoWhereTheyAreSymmetric) {
  const std::vector<std::vector<int>> elements{{0, 1}, {1, 2}};
  DirectSolver solver(3, elements, Symmetry::general_symmetric);
  // [4 1 0; 1 5 -3; 0 -3 1] is indefinite.
  const std::vector<double> a{4, 1, 1, 3, 2, -3, -3, 1};
  std::vector<double> x{5, 3, -2};
  ASSERT_TRUE(solver.factorise(a));
  solver.solve(x);
  for (const double v : x) EXPECT_NEAR(v, 1, 1e-14);
}

TEST(DirectSolver, SaysThatAMatrixIsSingular) {
  const std::vector<std::vector<int>> elements{{0, 1}};
  DirectSolver solver(2, elements, Symmetry::unsymmetric);
  EXPECT_FALSE(solver.factorise(std::vector<double>{0, 0, 0, 0}));
}
