#include "fe/hexahedral.hpp"

#include "fe/stopwatch.hpp"

#include <algorithm>
#include <cmath>

namespace platen::fe {
namespace {

constexpr double gauss = 0.57735026918962576451; // 1/sqrt(3)
constexpr std::array<std::array<double, 3>, 8> corners{
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

HexahedralSolid::HexahedralSolid(std::vector<Vector3> nodes_, std::vector<std::array<int, 8>> hexes_,
                                 material::Model model_)
    : nodes(std::move(nodes_)), hexes(std::move(hexes_)), model(std::move(model_)), committed(points()),
      force(3 * nodes.size()), tangent(24 * 24 * hexes.size()), updates(points()), volume(points()),
      shapes(points()), kinematics(points()), element_J(hexes.size()), element_volume(hexes.size()),
      eps_trial(points()), phi_n(points()) {
  for (std::size_t e = 0; e < hexes.size(); ++e)
    for (int g = 0; g < 8; ++g) {
      std::array<Vector3, 8> N_xi;
      Matrix J{}; // J[i][k] = dx_i/dxi_k
      for (int a = 0; a < 8; ++a) {
        const auto& c = corners[a];
        double f[3];
        for (int k = 0; k < 3; ++k) f[k] = 1 + gauss * corners[g][k] * c[k];
        N_xi[a] = {c[0] * f[1] * f[2] / 8, f[0] * c[1] * f[2] / 8, f[0] * f[1] * c[2] / 8};
        for (int i = 0; i < 3; ++i) J[i] = J[i] + nodes[hexes[e][a]][i] * N_xi[a];
      }
      const double det = determinant(J);
      const Matrix inverse = inverse_transposed(J, det);
      for (int a = 0; a < 8; ++a) shapes[8 * e + g][a] = inverse * N_xi[a];
      volume[8 * e + g] = det;
      element_volume[e] += det;
    }
}

Evaluation HexahedralSolid::evaluate(std::span<const double> u) {
  {
    Stopwatch watch(times.assembly_s);
    if (!deform(u)) return Evaluation::inverted_element;
  }
  {
    Stopwatch watch(times.material_s);
    const auto batch = material::update(model, eps_trial, phi_n, updates);
    counts.plastic += batch.plastic;
    counts.bracketed += batch.bracketed;
    counts.refused += batch.refused;
    if (batch.refused > 0) return Evaluation::refused_material;
  }
  Stopwatch watch(times.assembly_s);
  assemble_forces();
  return Evaluation::done;
}

void HexahedralSolid::linearise() {
  Stopwatch watch(times.assembly_s);
  for (int e = 0; e < static_cast<int>(hexes.size()); ++e) assemble_tangent(e);
}

/// Deformation gradients, mean dilatations and trial strains.
bool HexahedralSolid::deform(std::span<const double> u) {
  for (std::size_t e = 0; e < hexes.size(); ++e) {
    std::array<Vector3, 8> d;
    for (int a = 0; a < 8; ++a) {
      const std::size_t i = 3 * static_cast<std::size_t>(hexes[e][a]);
      d[a] = {u[i], u[i + 1], u[i + 2]};
    }
    double v = 0;
    for (int g = 0; g < 8; ++g) {
      Kinematics& k = kinematics[8 * e + g];
      const Gradients& N = shapes[8 * e + g];
      k.F = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i) k.F[i] = k.F[i] + d[a][i] * N[a];
      k.J = determinant(k.F);
      if (!(k.J > 0)) return false;
      const Matrix inverse = inverse_transposed(k.F, k.J);
      for (int a = 0; a < 8; ++a) k.grad[a] = inverse * N[a];
      v += volume[8 * e + g] * k.J;
    }
    element_J[e] = v / element_volume[e];
    for (int g = 0; g < 8; ++g) {
      Kinematics& k = kinematics[8 * e + g];
      const double alpha = std::cbrt(element_J[e] / k.J);
      for (auto& row : k.F) row = alpha * row;
      const State& n = committed[8 * e + g];
      k.b = spectral(transformed(k.F, n.Cp_inv));
      for (int A = 0; A < 3; ++A) eps_trial[8 * e + g][A] = std::log(k.b.value[A]) / 2;
      phi_n[8 * e + g] = n.phi;
    }
  }
  return true;
}

// dev(tau) : l + P b, with b = d(ln J_bar)/du and P the integral of tau's mean over the element.
void HexahedralSolid::assemble_forces() {
  std::fill(force.begin(), force.end(), 0.0);
  for (std::size_t e = 0; e < hexes.size(); ++e) {
    double P_over_v = 0;
    for (int g = 0; g < 8; ++g) {
      const auto& s = updates[8 * e + g].sigma;
      P_over_v += volume[8 * e + g] / element_volume[e] * (s[0] + s[1] + s[2]) / 3;
    }
    for (int g = 0; g < 8; ++g) {
      const Kinematics& k = kinematics[8 * e + g];
      const auto& s = updates[8 * e + g].sigma;
      const double w = volume[8 * e + g] * element_J[e];
      const double spherical = volume[8 * e + g] * k.J * P_over_v - w * (s[0] + s[1] + s[2]) / 3;
      const Symmetric3 t =
          compose({w * s[0] + spherical, w * s[1] + spherical, w * s[2] + spherical}, k.b.axis);
      for (int a = 0; a < 8; ++a) {
        const auto& n = k.grad[a];
        double* f = &force[3 * static_cast<std::size_t>(hexes[e][a])];
        f[0] += t[0] * n[0] + t[3] * n[1] + t[5] * n[2];
        f[1] += t[3] * n[0] + t[1] * n[1] + t[4] * n[2];
        f[2] += t[5] * n[0] + t[4] * n[1] + t[2] * n[2];
      }
    }
  }
}

// With l_AB = d(u_A)/d(x_B) of a nodal unknown in the principal axes of b_e^tr:
//   lbar_AA C_AB lbar_BB + (l_AB + l_BA)(beta_AB l_AB + beta_BA l_BA) - tau_A l_Ak l_kA + tau_m tr(l l)
//   + P [(1/v) int (tr l tr l - tr(l l)) dv - b b]
// with tau_m = tr(tau)/3, P = int tau_m dV, b = d(ln J_bar)/du, lbar_AA = l_AA + (b - tr l)/3. What is of the
// point alone is one tensor T_ijkl l_ij l_kl; the rest are products with b.
void HexahedralSolid::assemble_tangent(int element) {
  const std::size_t e = element;
  const double J_bar = element_J[e], v = J_bar * element_volume[e];
  double b[24] = {}, left[24] = {}, right[24] = {}, both = 0, P = 0;
  for (int g = 0; g < 8; ++g) {
    const Kinematics& k = kinematics[8 * e + g];
    const double dv = volume[8 * e + g] * k.J / v;
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) b[3 * a + i] += dv * k.grad[a][i];
    const auto& s = updates[8 * e + g].sigma;
    P += volume[8 * e + g] * J_bar * (s[0] + s[1] + s[2]) / 3;
  }
  double* K = &tangent[24 * 24 * e]; // by columns
  std::fill(K, K + 24 * 24, 0.0);
  for (int g = 0; g < 8; ++g) {
    const Kinematics& k = kinematics[8 * e + g];
    const material::PointUpdate& point = updates[8 * e + g];
    const double w = volume[8 * e + g];
    double tau[3], C[3][3], row[3] = {}, column[3] = {}, sum = 0;
    for (int A = 0; A < 3; ++A) {
      tau[A] = w * J_bar * point.sigma[A];
      for (int B = 0; B < 3; ++B) {
        C[A][B] = w * J_bar * point.D[A][B] + tau[A];
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
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
          half[x][3 * a + i] =
              T[x][3 * i] * k.grad[a][0] + T[x][3 * i + 1] * k.grad[a][1] + T[x][3 * i + 2] * k.grad[a][2];
    for (int a = 0; a < 8; ++a) {
      const auto& n = k.grad[a];
      left[3 * a] += L[0] * n[0] + L[3] * n[1] + L[5] * n[2];
      left[3 * a + 1] += L[3] * n[0] + L[1] * n[1] + L[4] * n[2];
      left[3 * a + 2] += L[5] * n[0] + L[4] * n[1] + L[2] * n[2];
      right[3 * a] += R[0] * n[0] + R[3] * n[1] + R[5] * n[2];
      right[3 * a + 1] += R[3] * n[0] + R[1] * n[1] + R[4] * n[2];
      right[3 * a + 2] += R[5] * n[0] + R[4] * n[1] + R[2] * n[2];
      for (int c = 0; c < 3; ++c) {
        double* into = K + 24 * (3 * a + c);
        const double *x = half[3 * c], *y = half[3 * c + 1], *z = half[3 * c + 2];
        for (int i = 0; i < 24; ++i) into[i] += n[0] * x[i] + n[1] * y[i] + n[2] * z[i];
      }
    }
  }
  for (int j = 0; j < 24; ++j)
    for (int i = 0; i < 24; ++i) K[24 * j + i] += left[i] * b[j] + b[i] * (right[j] + (both - P) * b[j]);
}

SpatialPointState HexahedralSolid::updated(int point) const {
  const Kinematics& k = kinematics[point];
  const auto& eps = updates[point].eps;
  const Symmetric3 b = compose({std::exp(2 * eps[0]), std::exp(2 * eps[1]), std::exp(2 * eps[2])}, k.b.axis);
  // C_p^{-1} = F^{-1} b_e F^{-T}
  const Matrix t = inverse_transposed(k.F, determinant(k.F));
  const Matrix inverse{
      {{t[0][0], t[1][0], t[2][0]}, {t[0][1], t[1][1], t[2][1]}, {t[0][2], t[1][2], t[2][2]}}};
  return {transformed(inverse, b), updates[point].phi};
}

Symmetric3 HexahedralSolid::cauchy(int point) const {
  return compose(updates[point].sigma, kinematics[point].b.axis);
}

} // namespace platen::fe
