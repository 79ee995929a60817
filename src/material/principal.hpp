#pragma once
// Principal strains and stresses of an elastic material, for models that return to their surface in them.

#include <array>
#include <cmath>

namespace platen::material::principal {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// sigma_A = (lambda eps_v + 2G eps_A) e^{-eps_v}.
struct Elasticity {
  double lambda, G;
  Vector stress(const Vector& eps) const {
    const double v = eps[0] + eps[1] + eps[2], exp_v = std::exp(-v);
    Vector sigma;
    for (int A = 0; A < 3; ++A) sigma[A] = (lambda * v + 2 * G * eps[A]) * exp_v;
    return sigma;
  }
  Matrix tangent(const Vector& eps, const Vector& sigma) const {
    const double exp_v = std::exp(-eps[0] - eps[1] - eps[2]);
    Matrix D;
    for (int A = 0; A < 3; ++A)
      for (int B = 0; B < 3; ++B) D[A][B] = (lambda + (A == B) * 2 * G) * exp_v - sigma[A];
    return D;
  }
};

} // namespace platen::material::principal
