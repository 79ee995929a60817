#include "fe/dissection.hpp"

#include "systems.hpp"

#include <gtest/gtest.h>

using namespace platen;
using fe::Dissection;

namespace {

const std::vector<std::vector<int>> chain{{0, 1}, {1, 2}};
const std::vector<fe::Vector3> middles{{0, 0, 0}, {1, 0, 0}};
constexpr double single = 1e-6; // factors are in single precision

/// Of the solution of a random system, against Gauss' elimination in double precision.
double relative_error(const test::Elements& e, bool positive, double diagonal) {
  const auto K = test::matrices(e, positive, diagonal, 5);
  const auto b = test::random_vector(e.unknowns, 7);
  Dissection solver(e.unknowns, e.lists, e.middles);
  auto x = b;
  EXPECT_TRUE(solver.factorise(K));
  solver.solve(x);
  const auto exact = test::solve_dense(test::dense(e, K), b);
  return test::length(test::difference(x, exact)) / test::length(exact);
}

} // namespace

TEST(Dissection, SolvesAgainAfterNewValues) {
  Dissection solver(3, chain, middles);
  for (const double shift : {0.0, 1.0}) {
    // [4+s 1 0; 2 5 1; 0 3 6] x = row sums, so x = (1, 1, 1). Each element matrix by columns.
    const std::vector<double> a{4 + shift, 2, 1, 3, 2, 3, 1, 6};
    std::vector<double> x{5 + shift, 8, 9};
    ASSERT_TRUE(solver.factorise(a));
    solver.solve(x);
    for (const double v : x) EXPECT_NEAR(v, 1, single);
  }
}

TEST(Dissection, TakesIndefiniteMatrices) {
  Dissection solver(3, chain, middles);
  // [4 1 0; 1 5 -3; 0 -3 1] is indefinite.
  const std::vector<double> a{4, 1, 1, 3, 2, -3, -3, 1};
  std::vector<double> x{5, 3, -2};
  ASSERT_TRUE(solver.factorise(a));
  solver.solve(x);
  for (const double v : x) EXPECT_NEAR(v, 1, single);
}

TEST(Dissection, ExchangesRowsWhereAPivotIsZero) {
  Dissection solver(2, {{0, 1}}, std::vector<fe::Vector3>{{}});
  std::vector<double> x{2, 3}; // [0 1; 1 0]
  ASSERT_TRUE(solver.factorise(std::vector<double>{0, 1, 1, 0}));
  solver.solve(x);
  EXPECT_NEAR(x[0], 3, single);
  EXPECT_NEAR(x[1], 2, single);
}

TEST(Dissection, SaysThatAMatrixIsSingular) {
  Dissection solver(2, {{0, 1}}, std::vector<fe::Vector3>{{}});
  EXPECT_FALSE(solver.factorise(std::vector<double>{0, 0, 0, 0}));
  EXPECT_FALSE(solver.factorise(std::vector<double>{1, 2, 2, 4}));
  EXPECT_TRUE(solver.factorise(std::vector<double>{1, 2, 2, 5}));
  const auto e = test::block(6, 6, 6, 3);
  Dissection large(e.unknowns, e.lists, e.middles);
  EXPECT_FALSE(large.factorise(std::vector<double>(e.lists.size() * 24 * 24, 0.0)));
}

TEST(Dissection, AgreesWithGaussOnRandomMeshes) {
  // Condition numbers of some hundreds cost as many units of the last place, 6e-8.
  for (const auto& e : {test::block(1, 1, 0, 2), test::block(9, 5, 0, 2), test::block(6, 6, 6, 3)}) {
    EXPECT_LT(relative_error(e, true, 1), 3e-5) << e.unknowns << ", positive definite";
    EXPECT_LT(relative_error(e, false, 6), 3e-5) << e.unknowns << ", unsymmetric";
  }
}

TEST(Dissection, SolvesForRightHandSidesOfAnySize) {
  const auto e = test::block(9, 5, 0, 2);
  Dissection solver(e.unknowns, e.lists, e.middles);
  ASSERT_TRUE(solver.factorise(test::matrices(e, true, 1, 5)));
  auto one = test::random_vector(e.unknowns, 7), tiny = one, huge = one;
  for (double& v : tiny) v *= 0x1p-400; // powers of two leave all digits
  for (double& v : huge) v *= 0x1p400;
  std::vector<double> none(e.unknowns);
  for (auto* b : {&one, &tiny, &huge, &none}) solver.solve(*b);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(tiny[i], one[i] * 0x1p-400);
    EXPECT_EQ(huge[i], one[i] * 0x1p400);
    EXPECT_EQ(none[i], 0);
  }
}

TEST(Dissection, OfADenseMatrixCostsAsLUDoes) {
  // 2/3 n^3 additions and multiplications against a solution's n^2 entries, at 24 an entry; and two and a
  // half times its entries.
  for (const int per_node : {1, 3}) {
    const auto e = test::block(1, 1, 1, per_node);
    EXPECT_NEAR(Dissection(e.unknowns, e.lists, e.middles).factorisation_cost(),
                2.0 / 3 * e.unknowns / 24 + 2.5, 1e-12);
  }
}

TEST(Dissection, CostsLessThanABandMatrixWould) {
  // George (1973): of n x n squares n^3 for the factors over n^2 log n for a solution; of a band n^4 over
  // n^3, twice as many solutions for twice as many squares a side.
  const auto cost = [](int n) {
    const auto e = test::block(n, n, 0, 2);
    return Dissection(e.unknowns, e.lists, e.middles).factorisation_cost();
  };
  EXPECT_GT(cost(64), cost(32));
  EXPECT_LT(cost(64), 1.9 * cost(32));
}
