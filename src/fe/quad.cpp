#include "fe/quad.hpp"

#include "core/vector_clones.hpp"
#include "platen/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::fe {
namespace {

constexpr double gauss = 0.57735026918962576451; // 1/sqrt(3)
constexpr std::array<std::array<double, 2>, 4> corner_of{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

} // namespace

static_assert(Element<Quad>);

Quad::Shape Quad::shape(const std::array<Vector<2>, 4>& corners) {
  Shape s{};
  for (int g = 0; g < points; ++g) {
    const double xi = gauss * corner_of[g][0], eta = gauss * corner_of[g][1];
    std::array<double, 4> N, N_xi, N_eta;
    double J[2][2] = {{0, 0}, {0, 0}}, R = 0;
    for (int a = 0; a < 4; ++a) {
      const auto [xa, ya] = corner_of[a];
      N[a] = (1 + xi * xa) * (1 + eta * ya) / 4;
      N_xi[a] = xa * (1 + eta * ya) / 4;
      N_eta[a] = (1 + xi * xa) * ya / 4;
      const auto [r, z] = corners[a];
      J[0][0] += r * N_xi[a], J[0][1] += r * N_eta[a];
      J[1][0] += z * N_xi[a], J[1][1] += z * N_eta[a];
      R += r * N[a];
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    for (int a = 0; a < 4; ++a) {
      s.N_R[a][g] = (N_xi[a] * J[1][1] - N_eta[a] * J[1][0]) / det;
      s.N_Z[a][g] = (N_eta[a] * J[0][0] - N_xi[a] * J[0][1]) / det;
      s.N_over_R[a][g] = N[a] / R;
    }
    s.volume[g] = 2 * std::numbers::pi * R * det;
    s.whole_volume += s.volume[g];
  }
  return s;
}

PLATEN_VECTOR_CLONES [[gnu::flatten]] bool Quad::deform(const Shape& s, const double* u, Kinematics& k) {
  Points rr{1, 1, 1, 1}, rz{}, zr{}, zz{1, 1, 1, 1}, tt{1, 1, 1, 1}, det;
  for (int a = 0; a < 4; ++a) {
    const double u_r = u[2 * a], u_z = u[2 * a + 1];
    for (int g = 0; g < points; ++g) {
      rr[g] += u_r * s.N_R[a][g], rz[g] += u_r * s.N_Z[a][g];
      zr[g] += u_z * s.N_R[a][g], zz[g] += u_z * s.N_Z[a][g];
      tt[g] += u_r * s.N_over_R[a][g];
    }
  }
  double v = 0;
  bool right_way_round = true;
  for (int g = 0; g < points; ++g) {
    det[g] = rr[g] * zz[g] - rz[g] * zr[g];
    k.J[g] = det[g] * tt[g];
    right_way_round = right_way_round && det[g] > 0 && tt[g] > 0;
    v += s.volume[g] * k.J[g];
  }
  if (!right_way_round) return false;
  Points per_det, per_tt;
  for (int g = 0; g < points; ++g) per_det[g] = 1 / det[g], per_tt[g] = 1 / tt[g];
  for (int a = 0; a < 4; ++a)
    for (int g = 0; g < points; ++g) {
      k.N_r[a][g] = (s.N_R[a][g] * zz[g] - s.N_Z[a][g] * zr[g]) * per_det[g];
      k.N_z[a][g] = (s.N_Z[a][g] * rr[g] - s.N_R[a][g] * rz[g]) * per_det[g];
      k.N_over_r[a][g] = s.N_over_R[a][g] * per_tt[g];
    }
  k.J_bar = v / s.whole_volume;
  const Points alpha = core::apart(core::exp(core::log(k.J_bar / core::side_by_side<core::Four>(k.J)) / 3));
  for (int g = 0; g < points; ++g) {
    k.rr[g] = alpha[g] * rr[g], k.rz[g] = alpha[g] * rz[g];
    k.zr[g] = alpha[g] * zr[g], k.zz[g] = alpha[g] * zz[g];
    k.tt[g] = alpha[g] * tt[g];
  }
  return true;
}

PLATEN_VECTOR_CLONES [[gnu::flatten]] void Quad::strains(Kinematics& k, const State* from,
                                                         PrincipalStrains* trial) {
  using T = core::Four;
  const auto of = [](const Points& x) -> T { return core::side_by_side<T>(x); };
  const T rr = of(k.rr), rz = of(k.rz), zr = of(k.zr), zz = of(k.zz), tt = of(k.tt);
  T c_rr, c_zz, c_rz, c_tt;
  for (int g = 0; g < points; ++g) {
    const auto& C = from[g].Cp_inv;
    c_rr[g] = C[0], c_zz[g] = C[1], c_rz[g] = C[2], c_tt[g] = C[3];
  }
  // b = F C F^T in the section.
  const T b_rr = rr * (rr * c_rr + rz * c_rz) + rz * (rr * c_rz + rz * c_zz);
  const T b_rz = zr * (rr * c_rr + rz * c_rz) + zz * (rr * c_rz + rz * c_zz);
  const T b_zz = zr * (zr * c_rr + zz * c_rz) + zz * (zr * c_rz + zz * c_zz);
  const auto b = plane_spectral(b_rr, b_zz, b_rz);
  k.b = {core::apart(b.value_1), core::apart(b.value_2), core::apart(b.cos), core::apart(b.sin)};
  const T first = core::log(b.value_1) / 2, second = core::log(b.value_2) / 2,
          third = core::log(tt * tt * c_tt) / 2;
  for (int g = 0; g < points; ++g) trial[g] = {first[g], second[g], third[g]};
}

// dev(tau) : l + P b, with b = d(ln J_bar)/du and P the integral of tau's mean over the element.
PLATEN_VECTOR_CLONES
void Quad::forces(const Shape& s, const Kinematics& k, const material::PointUpdate* updates, double* force) {
  double P_over_v = 0;
  for (int g = 0; g < points; ++g) {
    const auto& sigma = updates[g].sigma;
    P_over_v += s.volume[g] / s.whole_volume * (sigma[0] + sigma[1] + sigma[2]) / 3;
  }
  Points rr, zz, rz, tt;
  for (int g = 0; g < points; ++g) {
    const auto& sigma = updates[g].sigma;
    const double w = s.volume[g] * k.J_bar;
    const double spherical = s.volume[g] * k.J[g] * P_over_v - w * (sigma[0] + sigma[1] + sigma[2]) / 3;
    const auto t = compose(w * sigma[0] + spherical, w * sigma[1] + spherical, k.axes(g));
    rr[g] = t[0], zz[g] = t[1], rz[g] = t[2];
    tt[g] = w * sigma[2] + spherical;
  }
  for (int a = 0; a < 4; ++a) {
    double f_r = 0, f_z = 0;
    for (int g = 0; g < points; ++g) {
      f_r += rr[g] * k.N_r[a][g] + rz[g] * k.N_z[a][g] + tt[g] * k.N_over_r[a][g];
      f_z += rz[g] * k.N_r[a][g] + zz[g] * k.N_z[a][g];
    }
    force[2 * a] = f_r;
    force[2 * a + 1] = f_z;
  }
}

// Written in the principal axes of b_e^tr, where l_AB = d(u_A)/d(x_B) of a nodal unknown:
//   lbar_AA C_AB lbar_BB + (l_12 + l_21)(beta_1 l_12 + beta_2 l_21) - tau_A l_Ak l_kA + tau_m tr(l l)
//   + P [(1/v) int (tr l tr l - tr(l l)) dv - b b]
// with tau_m = tr(tau)/3, P = int tau_m dV, b = d(ln J_bar)/du, lbar_AA = l_AA + (b - tr l)/3. Where material
// flows, two_G_added times the deviatoric projection is added to D.
PLATEN_VECTOR_CLONES
void Quad::tangent(const Shape& s, const Kinematics& k, const material::PointUpdate* updates,
                   double two_G_added, double* K) {
  const double v = k.J_bar * s.whole_volume;
  double tr[points][8], b[8] = {}, P = 0;
  // The matrix is a sum of products of a vector with a transposed vector: one a component of l at a Gauss
  // point (tr l is l_11 + l_22 + l_tt), and one with b.
  constexpr int terms = 5 * points + 1;
  double left[terms][8], right[terms][8], with_b[8] = {};
  for (int g = 0; g < points; ++g) {
    const double dv = s.volume[g] * k.J[g] / v;
    for (int a = 0; a < 4; ++a) {
      tr[g][2 * a] = k.N_r[a][g] + k.N_over_r[a][g];
      tr[g][2 * a + 1] = k.N_z[a][g];
    }
    for (int i = 0; i < 8; ++i) b[i] += dv * tr[g][i];
    const auto& sigma = updates[g].sigma;
    P += s.volume[g] * k.J_bar * (sigma[0] + sigma[1] + sigma[2]) / 3;
  }
  for (int g = 0; g < points; ++g) {
    const material::PointUpdate& point = updates[g];
    const PlaneSpectral axes = k.axes(g);
    const double w = s.volume[g];
    double l11[8], l12[8], l21[8], l22[8], ltt[8];
    for (int a = 0; a < 4; ++a) {
      const double g1 = axes.cos * k.N_r[a][g] + axes.sin * k.N_z[a][g],
                   g2 = axes.cos * k.N_z[a][g] - axes.sin * k.N_r[a][g];
      l11[2 * a] = axes.cos * g1, l12[2 * a] = axes.cos * g2, l21[2 * a] = -axes.sin * g1,
              l22[2 * a] = -axes.sin * g2;
      l11[2 * a + 1] = axes.sin * g1, l12[2 * a + 1] = axes.sin * g2;
      l21[2 * a + 1] = axes.cos * g1, l22[2 * a + 1] = axes.cos * g2;
      ltt[2 * a] = k.N_over_r[a][g], ltt[2 * a + 1] = 0;
    }
    double tau[3], C[3][3];
    const double stiffer = point.zone == material::Zone::elastic ? 0 : two_G_added;
    for (int A = 0; A < 3; ++A) {
      tau[A] = w * k.J_bar * point.sigma[A];
      for (int B = 0; B < 3; ++B)
        C[A][B] = w * k.J_bar * (point.D[A][B] + stiffer * ((A == B) - 1.0 / 3)) + tau[A];
    }
    const double tau_m = (tau[0] + tau[1] + tau[2]) / 3;
    // (tau_1 - tau_2)/(b_1 - b_2), or its limit for equal stretches.
    const double spread = axes.value_1 - axes.value_2;
    const double slope = spread > 1e-7 * axes.value_1
                             ? (tau[0] - tau[1]) / spread
                             : (C[0][0] - C[0][1] - C[1][0] + C[1][1]) / (4 * axes.value_1);
    const double beta_1 = slope * axes.value_2, beta_2 = slope * axes.value_1;
    const double dv = w * k.J[g] / v * P; // weight of the second derivative of ln J_bar
    const double m = tau_m - dv;          // tr(l l) of the mean stress, less that of the second derivative
    auto *const L = &left[5 * g], *const R = &right[5 * g];
    for (int i = 0; i < 8; ++i) {
      const double third = (b[i] - tr[g][i]) / 3;
      const double bar[3] = {l11[i] + third, l22[i] + third, ltt[i] + third}, shear = l12[i] + l21[i];
      double C_bar[3];
      for (int B = 0; B < 3; ++B) C_bar[B] = bar[0] * C[0][B] + bar[1] * C[1][B] + bar[2] * C[2][B];
      const double mean = (C_bar[0] + C_bar[1] + C_bar[2]) / 3, dilating = dv * tr[g][i] - mean;
      L[0][i] = C_bar[0] + dilating + (m - tau[0]) * l11[i], R[0][i] = l11[i];
      L[1][i] = C_bar[1] + dilating + (m - tau[1]) * l22[i], R[1][i] = l22[i];
      L[2][i] = C_bar[2] + dilating + (m - tau[2]) * ltt[i], R[2][i] = ltt[i];
      L[3][i] = shear * beta_1 + (m - tau[1]) * l21[i], R[3][i] = l12[i];
      L[4][i] = shear * beta_2 + (m - tau[0]) * l12[i], R[4][i] = l21[i];
      with_b[i] += mean;
    }
  }
  for (int i = 0; i < 8; ++i) {
    left[terms - 1][i] = with_b[i] - P * b[i];
    right[terms - 1][i] = b[i];
  }
  // Four columns at once: each sum waits for its last addition, so that several must be under way.
  for (int j = 0; j < 8; j += 4) {
    double columns[4][8] = {};
    for (int t = 0; t < terms; ++t)
      for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 8; ++i) columns[c][i] += right[t][j + c] * left[t][i];
    std::copy(&columns[0][0], &columns[0][0] + 32, K + 8 * j);
  }
}

Quad::State Quad::updated(const Kinematics& k, int g, const material::PointUpdate& update) {
  const auto& eps = update.eps;
  const double b_1 = std::exp(2 * eps[0]), b_2 = std::exp(2 * eps[1]), b_t = std::exp(2 * eps[2]);
  const auto [rr, zz, rz] = compose(b_1, b_2, k.axes(g));
  // C_p^{-1} = F^{-1} b_e F^{-T}
  const double det = k.rr[g] * k.zz[g] - k.rz[g] * k.zr[g];
  const double i_rr = k.zz[g] / det, i_rz = -k.rz[g] / det, i_zr = -k.zr[g] / det, i_zz = k.rr[g] / det;
  State state;
  state.Cp_inv = {i_rr * (i_rr * rr + i_rz * rz) + i_rz * (i_rr * rz + i_rz * zz),
                  i_zr * (i_zr * rr + i_zz * rz) + i_zz * (i_zr * rz + i_zz * zz),
                  i_zr * (i_rr * rr + i_rz * rz) + i_zz * (i_rr * rz + i_rz * zz), b_t / (k.tt[g] * k.tt[g])};
  state.phi = update.phi;
  return state;
}

Quad::Stress Quad::cauchy(const Kinematics& k, int g, const material::PointUpdate& update) {
  const auto [rr, zz, rz] = compose(update.sigma[0], update.sigma[1], k.axes(g));
  return {rr, zz, rz, update.sigma[2]};
}

// Along the geodesic of symmetric positive matrices, A (A^-1 B)^factor; phi in proportion.
Quad::State Quad::continued(const State& a, const State& b, double factor) {
  const auto& [a_rr, a_zz, a_rz, a_tt] = a.Cp_inv;
  const auto& [b_rr, b_zz, b_rz, b_tt] = b.Cp_inv;
  // X = A^-1 B has the eigenvalues `high` and `low`, and X^factor = alpha + beta X (Cayley-Hamilton).
  const double det_a = a_rr * a_zz - a_rz * a_rz, det = (b_rr * b_zz - b_rz * b_rz) / det_a;
  const double mean = (a_zz * b_rr + a_rr * b_zz - 2 * a_rz * b_rz) / det_a / 2;
  const double half = std::sqrt(std::max(mean * mean - det, 0.0));
  const double high = mean + half, low = det / high, high_power = std::pow(high, factor);
  const double beta =
      half > 1e-9 * mean ? (high_power - std::pow(low, factor)) / (high - low) : factor * high_power / high;
  const double alpha = high_power - beta * high;
  State c;
  for (int i = 0; i < 3; ++i) c.Cp_inv[i] = alpha * a.Cp_inv[i] + beta * b.Cp_inv[i];
  c.Cp_inv[3] = a_tt * std::pow(b_tt / a_tt, factor);
  c.phi = a.phi + factor * (b.phi - a.phi);
  return c;
}

Quad::Stress Quad::turned(const Stress& stress, const Gradient& from, const Gradient& to) {
  // Of f = to from^-1, up to its determinant: the angle of f_rr + f_zz and f_zr - f_rz.
  const double along = to[0] * from[3] - to[1] * from[2] + to[3] * from[0] - to[2] * from[1],
               across = to[2] * from[3] - to[3] * from[2] + to[0] * from[1] - to[1] * from[0];
  const double length = std::hypot(along, across), c = along / length, s = across / length;
  const auto& [rr, zz, rz, tt] = stress;
  return {c * c * rr - 2 * c * s * rz + s * s * zz, s * s * rr + 2 * c * s * rz + c * c * zz,
          c * s * (rr - zz) + (c * c - s * s) * rz, tt};
}

double Quad::contraction(const Stress& a, const Stress& b) {
  return a[0] * b[0] + a[1] * b[1] + 2 * a[2] * b[2] + a[3] * b[3];
}

PrincipalStrains Quad::plastic_strain(const State& point) {
  const auto& [rr, zz, rz, tt] = point.Cp_inv;
  const PlaneSpectral s = plane_spectral(rr, zz, rz);
  return {-std::log(s.value_1) / 2, -std::log(s.value_2) / 2, -std::log(tt) / 2};
}

} // namespace platen::fe
