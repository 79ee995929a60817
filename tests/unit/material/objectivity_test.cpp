// A superposed rotation turns the stress and changes nothing else, at finite strain and after plastic flow.

#include "random_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Matrix transposed(const Matrix& a) {
  Matrix c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] = a[j][i];
  return c;
}
Matrix inverse(const Matrix& a) {
  const detail::Inverse3 solver(a);
  Matrix c;
  for (int j = 0; j < 3; ++j) {
    std::array<double, 3> unit{};
    unit[j] = 1;
    const auto column = solver.solve(unit);
    for (int i = 0; i < 3; ++i) c[i][j] = column[i];
  }
  return c;
}
double distance(const Matrix& a, const Matrix& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  return largest;
}

/// Rotation about the axis k by an angle.
Matrix turn(int k, double angle) {
  Matrix q{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  q[i][i] = q[j][j] = std::cos(angle);
  q[i][j] = -std::sin(angle);
  q[j][i] = std::sin(angle);
  return q;
}

/// Eigenvalues of a symmetric matrix, eigenvectors in the columns of `v`, by Jacobi's rotations.
std::array<double, 3> eigen(Matrix a, Matrix& v) {
  v = turn(0, 0);
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if (a[i][j] == 0) continue;
      const double apart = a[i][i] - a[j][j];
      const Matrix q =
          turn(k, 0.5 * std::atan2(std::copysign(2 * a[i][j], a[i][j] * apart), std::abs(apart)));
      a = times(transposed(q), times(a, q));
      v = times(v, q);
    }
  return {a[0][0], a[1][1], a[2][2]};
}

struct Point {
  Matrix Cp_inv = turn(0, 0), sigma{};
  double phi = 0;
};

Point moved(const Model& model, const Point& from, const Matrix& F) {
  Matrix v;
  const auto b = eigen(times(F, times(from.Cp_inv, transposed(F))), v);
  const PointUpdate u =
      update_one(model, {std::log(b[0]) / 2, std::log(b[1]) / 2, std::log(b[2]) / 2}, from.phi);
  EXPECT_FALSE(is_refused(u.status));
  Point to;
  Matrix b_e{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int A = 0; A < 3; ++A) {
        to.sigma[i][j] += u.sigma[A] * v[i][A] * v[j][A];
        b_e[i][j] += std::exp(2 * u.eps[A]) * v[i][A] * v[j][A];
      }
  const Matrix F_inv = inverse(F);
  to.Cp_inv = times(F_inv, times(b_e, transposed(F_inv)));
  to.phi = u.phi;
  return to;
}

} // namespace

TEST(Objectivity, ARotationTurnsTheStressAndNothingElse) {
  const std::vector<Model> models = {Elastic{100, 0.3},
                                     metals()[0],
                                     metals()[5],
                                     corner_materials()[4],
                                     rocks()[1],
                                     caps()[4],
                                     MohrCoulomb{3125, 0.38, 27.8, 1, 5, 0.3125}};
  const Matrix F_1{{{0.9, 0.1, 0.02}, {-0.05, 1.05, 0.1}, {0.03, -0.08, 0.97}}};
  const Matrix F_2{{{0.85, 0.2, 0.05}, {0.1, 1.0, 0.15}, {-0.05, -0.1, 0.9}}};
  const Matrix Q = times(turn(0, 0.7), times(turn(1, -1.9), turn(2, 2.4)));
  for (const Model& model : models) {
    const Point first = moved(model, Point{}, F_1);
    const Point straight = moved(model, first, F_2), turned = moved(model, first, times(Q, F_2));
    const double size = distance(straight.sigma, Matrix{});
    EXPECT_GT(size, 0);
    EXPECT_LT(distance(turned.sigma, times(Q, times(straight.sigma, transposed(Q)))), 1e-9 * size)
        << model_name(model);
    EXPECT_LT(distance(turned.Cp_inv, straight.Cp_inv), 1e-10) << model_name(model);
    EXPECT_NEAR(turned.phi, straight.phi, 1e-12) << model_name(model);
    // A rotation alone leaves a relaxed body relaxed.
    EXPECT_LT(distance(moved(model, Point{}, Q).sigma, Matrix{}), 1e-11 * initial_E(model))
        << model_name(model);
  }
}
