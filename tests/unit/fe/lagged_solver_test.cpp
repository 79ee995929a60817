#include "fe/lagged_solver.hpp"

#include "systems.hpp"

#include <gtest/gtest.h>

using namespace platen;
using fe::LaggedSolver, fe::Outcome;

namespace {

const test::Elements mesh = test::block(16, 12, 0, 2);
const std::vector<double> b = test::random_vector(mesh.unknowns, 7);

LaggedSolver new_solver() { return {mesh.unknowns, mesh.lists, mesh.middles}; }

/// Of what was solved, over the right-hand side.
double residual(const std::vector<double>& matrices, const std::vector<double>& x) {
  return test::length(test::difference(test::times(test::dense(mesh, matrices), x), b)) / test::length(b);
}

/// Entries changed by up to a share.
std::vector<double> changed(std::vector<double> matrices, double share) {
  const auto change = test::random_vector(matrices.size(), 11);
  for (std::size_t i = 0; i < matrices.size(); ++i) matrices[i] *= 1 + share * change[i];
  return matrices;
}

} // namespace

TEST(LaggedSolver, SolvesToTheToleranceWithStaleFactors) {
  auto solver = new_solver();
  const auto first = test::matrices(mesh, true, 1, 5), next = changed(first, 0.02);
  auto x = b, y = b;
  ASSERT_EQ(solver.matrix(first), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  EXPECT_LT(residual(first, x), 1e-5);
  const double factorised = solver.factorisation_s;
  EXPECT_GT(factorised, 0);
  ASSERT_EQ(solver.matrix(next), Outcome::done);
  ASSERT_EQ(solver.solve(y, 1e-5), Outcome::done);
  EXPECT_EQ(solver.factorisation_s, factorised) << "the factors were those of the first matrix";
  EXPECT_LT(residual(next, y), 1e-5);
  EXPECT_GT(residual(first, y), 1e-4) << "another matrix";
}

TEST(LaggedSolver, FactorisesWhereTheOldFactorsAreOfNoUse) {
  auto solver = new_solver();
  const auto first = test::matrices(mesh, true, 1, 5), other = test::matrices(mesh, false, 1, 1000);
  auto x = b;
  ASSERT_EQ(solver.matrix(first), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  const double factorised = solver.factorisation_s;
  x = b;
  ASSERT_EQ(solver.matrix(other), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  EXPECT_GT(solver.factorisation_s, factorised);
  EXPECT_LT(residual(other, x), 1e-5);
}

TEST(LaggedSolver, ReachesMoreThanThePrecisionOfItsFactors) {
  auto solver = new_solver();
  const auto matrices = test::matrices(mesh, true, 1, 5);
  auto x = b;
  ASSERT_EQ(solver.matrix(matrices), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-10), Outcome::done);
  EXPECT_LT(residual(matrices, x), 1e-10);
}

TEST(LaggedSolver, ForgetsWhatItSolvedBefore) {
  auto solver = new_solver(), fresh = new_solver();
  const auto first = test::matrices(mesh, true, 1, 5), next = changed(first, 0.02);
  auto x = b, y = b;
  ASSERT_EQ(solver.matrix(first), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  x = b;
  solver.forget();
  ASSERT_EQ(solver.matrix(next), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  ASSERT_EQ(fresh.matrix(next), Outcome::done);
  ASSERT_EQ(fresh.solve(y, 1e-5), Outcome::done);
  EXPECT_EQ(x, y);
}

TEST(LaggedSolver, SaysThatAMatrixIsSingularAndGoesOnWithAnother) {
  auto solver = new_solver();
  const auto good = test::matrices(mesh, true, 1, 5);
  const std::vector<double> zeros(good.size());
  auto x = b;
  EXPECT_EQ(solver.matrix(zeros), Outcome::singular);
  ASSERT_EQ(solver.matrix(good), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  // With factors of another matrix it is seen in the solution.
  ASSERT_EQ(solver.matrix(zeros), Outcome::done);
  x = b;
  EXPECT_EQ(solver.solve(x, 1e-5), Outcome::singular);
  ASSERT_EQ(solver.matrix(good), Outcome::done);
  x = b;
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  EXPECT_LT(residual(good, x), 1e-5);
}

TEST(LaggedSolver, GivesNothingForNothing) {
  auto solver = new_solver();
  const auto matrices = test::matrices(mesh, true, 1, 5);
  std::vector<double> x(mesh.unknowns);
  ASSERT_EQ(solver.matrix(matrices), Outcome::done);
  ASSERT_EQ(solver.solve(x, 1e-5), Outcome::done);
  EXPECT_EQ(test::length(x), 0);
}
