#include "fe/hexahedron.hpp"

#include "core/vector_clones.hpp"

#include <algorithm>
#include <cmath>

namespace platen::fe {
namespace {

constexpr double gauss = 0.57735026918962576451; // 1/sqrt(3)
constexpr std::array<std::array<double, 3>, 8> corner_of{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

using Matrix = std::array<Vector3, 3>; // rows

double determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

/// The transposed inverse, rows.
Matrix inverse_transposed(const Matrix& m, double det) {
  return {1 / det * cross(m[1], m[2]), 1 / det * cross(m[2], m[0]), 1 / det * cross(m[0], m[1])};
}

Vector3 operator*(const Matrix& m, const Vector3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

/// m s m^T
Symmetric3 transformed(const Matrix& m, const Symmetric3& s) {
  const Matrix full{{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
  const Vector3 x = full * m[0], y = full * m[1], z = full * m[2];
  return {dot(m[0], x), dot(m[1], y), dot(m[2], z), dot(m[0], y), dot(m[1], z), dot(m[2], x)};
}

} // namespace

static_assert(Element<Hexahedron>);

Hexahedron::Shape Hexahedron::shape(const std::array<Vector3, 8>& nodes) {
  Shape s{};
  for (int g = 0; g < points; ++g) {
    std::array<Vector3, 8> N_xi;
    Matrix J{}; // J[i][k] = dx_i/dxi_k
    for (int a = 0; a < 8; ++a) {
      const auto& c = corner_of[a];
      double f[3];
      for (int k = 0; k < 3; ++k) f[k] = 1 + gauss * corner_of[g][k] * c[k];
      N_xi[a] = {c[0] * f[1] * f[2] / 8, f[0] * c[1] * f[2] / 8, f[0] * f[1] * c[2] / 8};
      for (int i = 0; i < 3; ++i) J[i] = J[i] + nodes[a][i] * N_xi[a];
    }
    const double det = determinant(J);
    const Matrix inverse = inverse_transposed(J, det);
    for (int a = 0; a < 8; ++a) s.N[g][a] = inverse * N_xi[a];
    s.volume[g] = det;
    s.whole_volume += det;
  }
  return s;
}

PLATEN_VECTOR_CLONES
bool Hexahedron::deform(const Shape& s, const double* u, Kinematics& moved) {
  double v = 0;
  for (int g = 0; g < points; ++g) {
    Kinematics::Point& k = moved.point[g];
    const Gradients& N = s.N[g];
    k.F = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) k.F[i][j] += u[3 * a + i] * N[a][j];
    k.J = determinant(k.F);
    if (!(k.J > 0)) return false;
    const Matrix inverse = inverse_transposed(k.F, k.J);
    for (int a = 0; a < 8; ++a) k.grad[a] = inverse * N[a];
    v += s.volume[g] * k.J;
  }
  moved.J_bar = v / s.whole_volume;
  for (Kinematics::Point& k : moved.point) {
    const double alpha = std::cbrt(moved.J_bar / k.J);
    for (auto& row : k.F) row = alpha * row;
  }
  return true;
}

void Hexahedron::strains(Kinematics& moved, const State* from, PrincipalStrains* trial) {
  for (int g = 0; g < points; ++g) {
    Kinematics::Point& k = moved.point[g];
    k.b = spectral(transformed(k.F, from[g].Cp_inv));
    trial[g] = {std::log(k.b.value[0]) / 2, std::log(k.b.value[1]) / 2, std::log(k.b.value[2]) / 2};
  }
}

// dev(tau) : l + P b, with b = d(ln J_bar)/du and P the integral of tau's mean over the element.
PLATEN_VECTOR_CLONES
void Hexahedron::forces(const Shape& s, const Kinematics& moved, const material::PointUpdate* updates,
                        double* force) {
  std::fill(force, force + unknowns, 0.0);
  double P_over_v = 0;
  for (int g = 0; g < points; ++g) {
    const auto& sigma = updates[g].sigma;
    P_over_v += s.volume[g] / s.whole_volume * (sigma[0] + sigma[1] + sigma[2]) / 3;
  }
  for (int g = 0; g < points; ++g) {
    const Kinematics::Point& k = moved.point[g];
    const auto& sigma = updates[g].sigma;
    const double w = s.volume[g] * moved.J_bar;
    const double spherical = s.volume[g] * k.J * P_over_v - w * (sigma[0] + sigma[1] + sigma[2]) / 3;
    const Symmetric3 t =
        compose({w * sigma[0] + spherical, w * sigma[1] + spherical, w * sigma[2] + spherical}, k.b.axis);
    for (int a = 0; a < 8; ++a) {
      const auto& n = k.grad[a];
      force[3 * a] += t[0] * n[0] + t[3] * n[1] + t[5] * n[2];
      force[3 * a + 1] += t[3] * n[0] + t[1] * n[1] + t[4] * n[2];
      force[3 * a + 2] += t[5] * n[0] + t[4] * n[1] + t[2] * n[2];
    }
  }
}

// With l_AB = d(u_A)/d(x_B) of a nodal unknown in the principal axes of b_e^tr:
//   lbar_AA C_AB lbar_BB + (l_AB + l_BA)(beta_AB l_AB + beta_BA l_BA) - tau_A l_Ak l_kA + tau_m tr(l l)
//   + P [(1/v) int (tr l tr l - tr(l l)) dv - b b]
// with tau_m = tr(tau)/3, P = int tau_m dV, b = d(ln J_bar)/du, lbar_AA = l_AA + (b - tr l)/3. What is of the
// point alone is one tensor T_ijkl l_ij l_kl; the rest are products with b. Where material flows, two_G_added
// times the deviatoric projection is added to D.
PLATEN_VECTOR_CLONES
void Hexahedron::tangent(const Shape& s, const Kinematics& moved, const material::PointUpdate* updates,
                         double two_G_added, double* K) {
  const double J_bar = moved.J_bar, v = J_bar * s.whole_volume;
  // Unknowns component by component, so that the nodes lie side by side; sorted by nodes at the end.
  double by_component[24][24] = {}, b[24] = {}, left[24] = {}, right[24] = {}, both = 0, P = 0;
  for (int g = 0; g < 8; ++g) {
    const Kinematics::Point& k = moved.point[g];
    const double dv = s.volume[g] * k.J / v;
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) b[8 * i + a] += dv * k.grad[a][i];
    const auto& sigma = updates[g].sigma;
    P += s.volume[g] * J_bar * (sigma[0] + sigma[1] + sigma[2]) / 3;
  }
  for (int g = 0; g < 8; ++g) {
    const Kinematics::Point& k = moved.point[g];
    const material::PointUpdate& point = updates[g];
    const double w = s.volume[g];
    double along[3][8]; // the gradients
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) along[i][a] = k.grad[a][i];
    double tau[3], C[3][3], row[3] = {}, column[3] = {}, sum = 0;
    const double stiffer = point.zone == material::Zone::elastic ? 0 : two_G_added;
    for (int A = 0; A < 3; ++A) {
      tau[A] = w * J_bar * point.sigma[A];
      for (int B = 0; B < 3; ++B) {
        C[A][B] = w * J_bar * (point.D[A][B] + stiffer * ((A == B) - 1.0 / 3)) + tau[A];
        row[A] += C[A][B] / 3;
        column[B] += C[A][B] / 3;
        sum += C[A][B] / 9;
      }
    }
    both += sum;
    const double tau_m = (tau[0] + tau[1] + tau[2]) / 3;
    const double dv = w * k.J / v * P; // weight of the second derivative of ln J_bar
    const double m = tau_m - dv;       // tr(l l) of the mean stress, less that of the second derivative

    double dyad[3][3][9]; // e_A e_B
    for (int A = 0; A < 3; ++A)
      for (int B = 0; B < 3; ++B)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) dyad[A][B][3 * i + j] = k.b.axis[A][i] * k.b.axis[B][j];
    double T[9][9] = {}; // T[kl][ij]: the second l first, since matrices go by columns
    for (int A = 0; A < 3; ++A) {
      double mixed[9] = {};
      for (int B = 0; B < 3; ++B) {
        const double c = C[A][B] - row[A] - column[B] + sum + dv + (A == B ? m - tau[A] : 0);
        for (int x = 0; x < 9; ++x) mixed[x] += c * dyad[B][B][x];
      }
      for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 9; ++y) T[x][y] += mixed[x] * dyad[A][A][y];
    }
    for (int A = 0; A < 3; ++A)
      for (int B = A + 1; B < 3; ++B) {
        const double b_A = k.b.value[A], b_B = k.b.value[B], spread = b_A - b_B;
        // (tau_A - tau_B)/(b_A - b_B), or its limit for equal stretches.
        const double slope = std::abs(spread) > 1e-7 * b_A
                                 ? (tau[A] - tau[B]) / spread
                                 : (C[A][A] - C[A][B] - C[B][A] + C[B][B]) / (4 * b_A);
        const auto &AB = dyad[A][B], &BA = dyad[B][A];
        double with_AB[9], with_BA[9];
        for (int x = 0; x < 9; ++x) {
          const double shear = slope * (b_B * AB[x] + b_A * BA[x]);
          with_AB[x] = shear + (m - tau[A]) * BA[x];
          with_BA[x] = shear + (m - tau[B]) * AB[x];
        }
        for (int x = 0; x < 9; ++x)
          for (int y = 0; y < 9; ++y) T[x][y] += with_AB[x] * AB[y] + with_BA[x] * BA[y];
      }
    const Symmetric3 L = compose({row[0] - sum, row[1] - sum, row[2] - sum}, k.b.axis),
                     R = compose({column[0] - sum, column[1] - sum, column[2] - sum}, k.b.axis);
    double half[9][24]; // T with the first l put in
    for (int x = 0; x < 9; ++x)
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 8; ++a)
          half[x][8 * i + a] =
              T[x][3 * i] * along[0][a] + T[x][3 * i + 1] * along[1][a] + T[x][3 * i + 2] * along[2][a];
    constexpr int of[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}; // components of a symmetric tensor
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int a = 0; a < 8; ++a) {
          left[8 * i + a] += L[of[i][j]] * along[j][a];
          right[8 * i + a] += R[of[i][j]] * along[j][a];
        }
    for (int c = 0; c < 3; ++c)
      for (int a = 0; a < 8; ++a) {
        const double n0 = along[0][a], n1 = along[1][a], n2 = along[2][a];
        for (int i = 0; i < 24; ++i)
          by_component[8 * c + a][i] +=
              n0 * half[3 * c][i] + n1 * half[3 * c + 1][i] + n2 * half[3 * c + 2][i];
      }
  }
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 24; ++i) by_component[j][i] += left[i] * b[j] + b[i] * (right[j] + (both - P) * b[j]);
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 8; ++c)
      for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 8; ++a) K[24 * (3 * c + d) + 3 * a + i] = by_component[8 * d + c][8 * i + a];
}

Hexahedron::State Hexahedron::updated(const Kinematics& moved, int g, const material::PointUpdate& update) {
  const Kinematics::Point& k = moved.point[g];
  const auto& eps = update.eps;
  const Symmetric3 b = compose({std::exp(2 * eps[0]), std::exp(2 * eps[1]), std::exp(2 * eps[2])}, k.b.axis);
  // C_p^{-1} = F^{-1} b_e F^{-T}
  const Matrix t = inverse_transposed(k.F, determinant(k.F));
  const Matrix inverse{
      {{t[0][0], t[1][0], t[2][0]}, {t[0][1], t[1][1], t[2][1]}, {t[0][2], t[1][2], t[2][2]}}};
  return {transformed(inverse, b), update.phi};
}

Hexahedron::Stress Hexahedron::cauchy(const Kinematics& moved, int g, const material::PointUpdate& update) {
  return compose(update.sigma, moved.point[g].b.axis);
}

// Along the geodesic of symmetric positive matrices, A (A^-1 B)^factor: with A = L L^T and M = L^-1 B L^-T it
// is L M^factor L^T. phi in proportion.
Hexahedron::State Hexahedron::continued(const State& a, const State& b, double factor) {
  const auto& [xx, yy, zz, xy, yz, zx] = a.Cp_inv;
  const double l00 = std::sqrt(xx), l10 = xy / l00, l20 = zx / l00, l11 = std::sqrt(yy - l10 * l10),
               l21 = (yz - l20 * l10) / l11, l22 = std::sqrt(zz - l20 * l20 - l21 * l21);
  // Columns of L^-1 B, then rows of that times L^-T.
  const auto forward = [&](double x, double y, double z) {
    const double p = x / l00, q = (y - l10 * p) / l11;
    return Vector3{p, q, (z - l20 * p - l21 * q) / l22};
  };
  const auto& B = b.Cp_inv;
  const Vector3 c0 = forward(B[0], B[3], B[5]), c1 = forward(B[3], B[1], B[4]),
                c2 = forward(B[5], B[4], B[2]);
  const Vector3 r0 = forward(c0[0], c1[0], c2[0]), r1 = forward(c0[1], c1[1], c2[1]),
                r2 = forward(c0[2], c1[2], c2[2]);
  Spectral m = spectral({r0[0], r1[1], r2[2], r0[1], r1[2], r2[0]});
  for (int k = 0; k < 3; ++k) {
    m.value[k] = std::pow(m.value[k], factor);
    const auto& [x, y, z] = m.axis[k];
    m.axis[k] = {l00 * x, l10 * x + l11 * y, l20 * x + l21 * y + l22 * z};
  }
  return {compose(m.value, m.axis), a.phi + factor * (b.phi - a.phi)};
}

Hexahedron::Stress Hexahedron::turned(const Stress& stress, const Gradient& from, const Gradient& to) {
  const Matrix inverse = inverse_transposed(from, determinant(from));
  Matrix f{}; // to from^-1 = V R
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) f[i][j] = dot(to[i], inverse[j]);
  Spectral V = spectral(transformed(f, {1, 1, 1, 0, 0, 0})); // squared
  for (double& stretch : V.value) stretch = 1 / std::sqrt(stretch);
  const Symmetric3 v = compose(V.value, V.axis);
  const Matrix back{{{v[0], v[3], v[5]}, {v[3], v[1], v[4]}, {v[5], v[4], v[2]}}};
  Matrix R{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) R[i] = R[i] + back[i][k] * f[k];
  return transformed(R, stress);
}

double Hexahedron::contraction(const Stress& a, const Stress& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

PrincipalStrains Hexahedron::plastic_strain(const State& point) {
  const auto value = spectral(point.Cp_inv).value;
  return {-std::log(value[0]) / 2, -std::log(value[1]) / 2, -std::log(value[2]) / 2};
}

} // namespace platen::fe
