#include "fe/axisymmetric.hpp"

#include "fe/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::fe {
namespace {

constexpr double gauss = 0.57735026918962576451; // 1/sqrt(3)
constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

} // namespace

AxisymmetricSolid::AxisymmetricSolid(AxisymmetricMesh mesh_, material::Model model_)
    : mesh(std::move(mesh_)), model(std::move(model_)), committed(points()), force(unknowns()),
      tangent(64 * mesh.quads.size()), updates(points()), volume(points()), shapes(points()),
      kinematics(points()), element_J(mesh.quads.size()), element_volume(mesh.quads.size()),
      eps_trial(points()), phi_n(points()) {
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const auto& quad = mesh.quads[e];
    for (int g = 0; g < 4; ++g) {
      const double xi = gauss * corners[g][0], eta = gauss * corners[g][1];
      std::array<double, 4> N, N_xi, N_eta;
      double J[2][2] = {{0, 0}, {0, 0}}, R = 0;
      for (int a = 0; a < 4; ++a) {
        const auto [xa, ya] = corners[a];
        N[a] = (1 + xi * xa) * (1 + eta * ya) / 4;
        N_xi[a] = xa * (1 + eta * ya) / 4;
        N_eta[a] = (1 + xi * xa) * ya / 4;
        const auto [r, z] = mesh.nodes[quad[a]];
        J[0][0] += r * N_xi[a], J[0][1] += r * N_eta[a];
        J[1][0] += z * N_xi[a], J[1][1] += z * N_eta[a];
        R += r * N[a];
      }
      const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
      Shape& shape = shapes[4 * e + g];
      for (int a = 0; a < 4; ++a) {
        shape.N_R[a] = (N_xi[a] * J[1][1] - N_eta[a] * J[1][0]) / det;
        shape.N_Z[a] = (N_eta[a] * J[0][0] - N_xi[a] * J[0][1]) / det;
        shape.N_over_R[a] = N[a] / R;
      }
      volume[4 * e + g] = 2 * std::numbers::pi * R * det;
      element_volume[e] += volume[4 * e + g];
    }
  }
}

std::array<int, 8> AxisymmetricSolid::unknowns_of(int element) const {
  std::array<int, 8> u;
  for (int a = 0; a < 4; ++a) {
    u[2 * a] = 2 * mesh.quads[element][a];
    u[2 * a + 1] = u[2 * a] + 1;
  }
  return u;
}

Evaluation AxisymmetricSolid::evaluate(std::span<const double> u) {
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

void AxisymmetricSolid::linearise(double added) {
  Stopwatch watch(times.assembly_s);
  const double two_G_added = added * material::initial_E(model) / (1 + material::initial_nu(model));
  for (int e = 0; e < static_cast<int>(mesh.quads.size()); ++e) assemble_tangent(e, two_G_added);
}

/// Deformation gradients, mean dilatations and trial strains.
bool AxisymmetricSolid::deform(std::span<const double> u) {
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const auto& quad = mesh.quads[e];
    double v = 0;
    for (int g = 0; g < 4; ++g) {
      const Shape& s = shapes[4 * e + g];
      Kinematics& k = kinematics[4 * e + g];
      double rr = 1, rz = 0, zr = 0, zz = 1, tt = 1;
      for (int a = 0; a < 4; ++a) {
        const double ur = u[2 * quad[a]], uz = u[2 * quad[a] + 1];
        rr += ur * s.N_R[a], rz += ur * s.N_Z[a];
        zr += uz * s.N_R[a], zz += uz * s.N_Z[a];
        tt += ur * s.N_over_R[a];
      }
      const double det = rr * zz - rz * zr;
      k.J = det * tt;
      if (!(det > 0 && tt > 0)) return false;
      for (int a = 0; a < 4; ++a) {
        k.N_r[a] = (s.N_R[a] * zz - s.N_Z[a] * zr) / det;
        k.N_z[a] = (s.N_Z[a] * rr - s.N_R[a] * rz) / det;
        k.N_over_r[a] = s.N_over_R[a] / tt;
      }
      k.F = {rr, rz, zr, zz, tt};
      v += volume[4 * e + g] * k.J;
    }
    element_J[e] = v / element_volume[e];
    for (int g = 0; g < 4; ++g) {
      Kinematics& k = kinematics[4 * e + g];
      const double alpha = std::cbrt(element_J[e] / k.J);
      for (double& f : k.F) f *= alpha;
      const auto& [rr, rz, zr, zz, tt] = k.F;
      const PointState& n = committed[4 * e + g];
      const auto& [c_rr, c_zz, c_rz, c_tt] = n.Cp_inv;
      // b = F C F^T in the section.
      const double b_rr = rr * (rr * c_rr + rz * c_rz) + rz * (rr * c_rz + rz * c_zz);
      const double b_rz = zr * (rr * c_rr + rz * c_rz) + zz * (rr * c_rz + rz * c_zz);
      const double b_zz = zr * (zr * c_rr + zz * c_rz) + zz * (zr * c_rz + zz * c_zz);
      k.b = plane_spectral(b_rr, b_zz, b_rz);
      eps_trial[4 * e + g] = {std::log(k.b.value_1) / 2, std::log(k.b.value_2) / 2,
                              std::log(tt * tt * c_tt) / 2};
      phi_n[4 * e + g] = n.phi;
    }
  }
  return true;
}

// dev(tau) : l + P b, with b = d(ln J_bar)/du and P the integral of tau's mean over the element.
void AxisymmetricSolid::assemble_forces() {
  std::fill(force.begin(), force.end(), 0.0);
  for (int e = 0; e < static_cast<int>(mesh.quads.size()); ++e) {
    const auto& quad = mesh.quads[e];
    double P_over_v = 0;
    for (int g = 0; g < 4; ++g) {
      const auto& s = updates[4 * e + g].sigma;
      P_over_v += volume[4 * e + g] / element_volume[e] * (s[0] + s[1] + s[2]) / 3;
    }
    for (int g = 0; g < 4; ++g) {
      const Kinematics& k = kinematics[4 * e + g];
      const auto& s = updates[4 * e + g].sigma;
      const double w = volume[4 * e + g] * element_J[e];
      const double spherical = volume[4 * e + g] * k.J * P_over_v - w * (s[0] + s[1] + s[2]) / 3;
      const auto [rr, zz, rz] = compose(w * s[0] + spherical, w * s[1] + spherical, k.b);
      const double tt = w * s[2] + spherical;
      for (int a = 0; a < 4; ++a) {
        force[2 * quad[a]] += rr * k.N_r[a] + rz * k.N_z[a] + tt * k.N_over_r[a];
        force[2 * quad[a] + 1] += rz * k.N_r[a] + zz * k.N_z[a];
      }
    }
  }
}

// Written in the principal axes of b_e^tr, where l_AB = d(u_A)/d(x_B) of a nodal unknown:
//   lbar_AA C_AB lbar_BB + (l_12 + l_21)(beta_1 l_12 + beta_2 l_21) - tau_A l_Ak l_kA + tau_m tr(l l)
//   + P [(1/v) int (tr l tr l - tr(l l)) dv - b b]
// with tau_m = tr(tau)/3, P = int tau_m dV, b = d(ln J_bar)/du, lbar_AA = l_AA + (b - tr l)/3. Where material
// flows, two_G_added times the deviatoric projection is added to D.
void AxisymmetricSolid::assemble_tangent(int e, double two_G_added) {
  const double J_bar = element_J[e], v = J_bar * element_volume[e];
  double tr[4][8], b[8] = {}, P = 0;
  // The matrix is a sum of products of a vector with a transposed vector: nine a Gauss point, and the mean
  // dilatation's own.
  constexpr int terms = 9 * 4 + 1;
  double left[terms][8], right[terms][8];
  for (int g = 0; g < 4; ++g) {
    const Kinematics& k = kinematics[4 * e + g];
    const double dv = volume[4 * e + g] * k.J / v;
    for (int a = 0; a < 4; ++a) {
      tr[g][2 * a] = k.N_r[a] + k.N_over_r[a];
      tr[g][2 * a + 1] = k.N_z[a];
      b[2 * a] += dv * tr[g][2 * a];
      b[2 * a + 1] += dv * tr[g][2 * a + 1];
    }
    const auto& s = updates[4 * e + g].sigma;
    P += volume[4 * e + g] * J_bar * (s[0] + s[1] + s[2]) / 3;
  }
  for (int g = 0; g < 4; ++g) {
    const Kinematics& k = kinematics[4 * e + g];
    const material::PointUpdate& point = updates[4 * e + g];
    const double w = volume[4 * e + g];
    double l11[8], l12[8], l21[8], l22[8], ltt[8];
    for (int a = 0; a < 4; ++a) {
      const double g1 = k.b.cos * k.N_r[a] + k.b.sin * k.N_z[a], g2 = k.b.cos * k.N_z[a] - k.b.sin * k.N_r[a];
      l11[2 * a] = k.b.cos * g1, l12[2 * a] = k.b.cos * g2, l21[2 * a] = -k.b.sin * g1,
              l22[2 * a] = -k.b.sin * g2;
      l11[2 * a + 1] = k.b.sin * g1, l12[2 * a + 1] = k.b.sin * g2;
      l21[2 * a + 1] = k.b.cos * g1, l22[2 * a + 1] = k.b.cos * g2;
      ltt[2 * a] = k.N_over_r[a], ltt[2 * a + 1] = 0;
    }
    double tau[3], C[3][3];
    const double stiffer = point.zone == material::Zone::elastic ? 0 : two_G_added;
    for (int A = 0; A < 3; ++A) {
      tau[A] = w * J_bar * point.sigma[A];
      for (int B = 0; B < 3; ++B)
        C[A][B] = w * J_bar * (point.D[A][B] + stiffer * ((A == B) - 1.0 / 3)) + tau[A];
    }
    const double tau_m = (tau[0] + tau[1] + tau[2]) / 3;
    // (tau_1 - tau_2)/(b_1 - b_2), or its limit for equal stretches.
    const double spread = k.b.value_1 - k.b.value_2;
    const double slope = spread > 1e-7 * k.b.value_1
                             ? (tau[0] - tau[1]) / spread
                             : (C[0][0] - C[0][1] - C[1][0] + C[1][1]) / (4 * k.b.value_1);
    const double beta_1 = slope * k.b.value_2, beta_2 = slope * k.b.value_1;
    const double dv = w * k.J / v * P; // weight of the second derivative of ln J_bar
    const double m = tau_m - dv;       // tr(l l) of the mean stress, less that of the second derivative
    auto *const L = &left[9 * g], *const R = &right[9 * g];
    for (int i = 0; i < 8; ++i) {
      const double third = (b[i] - tr[g][i]) / 3;
      const double bar[3] = {l11[i] + third, l22[i] + third, ltt[i] + third}, shear = l12[i] + l21[i];
      for (int B = 0; B < 3; ++B) {
        L[B][i] = bar[0] * C[0][B] + bar[1] * C[1][B] + bar[2] * C[2][B];
        R[B][i] = bar[B];
      }
      L[3][i] = (m - tau[0]) * l11[i], R[3][i] = l11[i];
      L[4][i] = (m - tau[1]) * l22[i], R[4][i] = l22[i];
      L[5][i] = (m - tau[2]) * ltt[i], R[5][i] = ltt[i];
      L[6][i] = shear * beta_1 + (m - tau[1]) * l21[i], R[6][i] = l12[i];
      L[7][i] = shear * beta_2 + (m - tau[0]) * l12[i], R[7][i] = l21[i];
      L[8][i] = dv * tr[g][i], R[8][i] = tr[g][i];
    }
  }
  for (int i = 0; i < 8; ++i) {
    left[terms - 1][i] = -P * b[i];
    right[terms - 1][i] = b[i];
  }
  for (int j = 0; j < 8; ++j) {
    double column[8] = {};
    for (int t = 0; t < terms; ++t)
      for (int i = 0; i < 8; ++i) column[i] += right[t][j] * left[t][i];
    std::copy(column, column + 8, &tangent[64 * e + 8 * j]);
  }
}

PointState AxisymmetricSolid::updated(int point) const {
  const Kinematics& k = kinematics[point];
  const auto& eps = updates[point].eps;
  const double b_1 = std::exp(2 * eps[0]), b_2 = std::exp(2 * eps[1]), b_t = std::exp(2 * eps[2]);
  const auto [rr, zz, rz] = compose(b_1, b_2, k.b);
  // C_p^{-1} = F^{-1} b_e F^{-T}
  const auto& [F_rr, F_rz, F_zr, F_zz, F_tt] = k.F;
  const double det = F_rr * F_zz - F_rz * F_zr;
  const double i_rr = F_zz / det, i_rz = -F_rz / det, i_zr = -F_zr / det, i_zz = F_rr / det;
  PointState state;
  state.Cp_inv = {i_rr * (i_rr * rr + i_rz * rz) + i_rz * (i_rr * rz + i_rz * zz),
                  i_zr * (i_zr * rr + i_zz * rz) + i_zz * (i_zr * rz + i_zz * zz),
                  i_zr * (i_rr * rr + i_rz * rz) + i_zz * (i_rr * rz + i_rz * zz), b_t / (F_tt * F_tt)};
  state.phi = updates[point].phi;
  return state;
}

void AxisymmetricSolid::commit() {
  for (int i = 0; i < points(); ++i) committed[i] = updated(i);
}

std::array<double, 4> AxisymmetricSolid::cauchy(int point) const {
  const Kinematics& k = kinematics[point];
  const auto& s = updates[point].sigma;
  const auto [rr, zz, rz] = compose(s[0], s[1], k.b);
  return {rr, zz, rz, s[2]};
}

} // namespace platen::fe
