#pragma once
// Vectors, and symmetric tensors in space and in a plane.

#include "platen/lanes.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace platen::fe {

template <std::size_t N> using Vector = std::array<double, N>;
using Vector3 = Vector<3>;

template <std::size_t N> Vector<N> operator+(Vector<N> a, const Vector<N>& b) {
  for (std::size_t k = 0; k < N; ++k) a[k] += b[k];
  return a;
}
template <std::size_t N> Vector<N> operator-(Vector<N> a, const Vector<N>& b) {
  for (std::size_t k = 0; k < N; ++k) a[k] -= b[k];
  return a;
}
template <std::size_t N> Vector<N> operator*(double s, Vector<N> a) {
  for (double& x : a) x *= s;
  return a;
}
template <std::size_t N> double dot(const Vector<N>& a, const Vector<N>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < N; ++k) sum += a[k] * b[k];
  return sum;
}
template <std::size_t N> double norm(const Vector<N>& a) { return std::sqrt(dot(a, a)); }
template <std::size_t N> Vector<N> unit(const Vector<N>& a) { return 1 / norm(a) * a; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// xx, yy, zz, xy, yz, zx.
using Symmetric3 = std::array<double, 6>;

/// Eigenvalues of a symmetric tensor and unit eigenvectors.
struct Spectral {
  std::array<double, 3> value;
  std::array<Vector3, 3> axis;
};

/// By Jacobi's rotations, which lose no digits where eigenvalues are close.
inline Spectral spectral(const Symmetric3& s) {
  double a[3][3] = {{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
  std::array<Vector3, 3> axis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int p_of[3] = {0, 1, 0}, q_of[3] = {1, 2, 2}, r_of[3] = {2, 0, 1};
  const double scale = std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]);
  for (int sweep = 0; sweep < 12; ++sweep) {
    if (std::abs(a[0][1]) + std::abs(a[1][2]) + std::abs(a[0][2]) <= 1e-17 * scale) break;
    for (int k = 0; k < 3; ++k) {
      const int p = p_of[k], q = q_of[k], r = r_of[k];
      const double off = a[p][q];
      if (std::abs(off) <= 1e-18 * scale) continue;
      const double theta = (a[q][q] - a[p][p]) / (2 * off);
      const double t = std::copysign(1 / (std::abs(theta) + std::sqrt(theta * theta + 1)), theta);
      const double c = 1 / std::sqrt(t * t + 1), sn = t * c;
      a[p][p] -= t * off;
      a[q][q] += t * off;
      a[p][q] = a[q][p] = 0;
      const double rp = a[r][p], rq = a[r][q];
      a[r][p] = a[p][r] = c * rp - sn * rq;
      a[r][q] = a[q][r] = sn * rp + c * rq;
      for (int i = 0; i < 3; ++i) {
        const double vp = axis[p][i], vq = axis[q][i];
        axis[p][i] = c * vp - sn * vq;
        axis[q][i] = sn * vp + c * vq;
      }
    }
  }
  return {{a[0][0], a[1][1], a[2][2]}, axis};
}

/// The symmetric tensor with these eigenvalues and axes.
inline Symmetric3 compose(const std::array<double, 3>& value, const std::array<Vector3, 3>& axis) {
  Symmetric3 s{};
  for (int A = 0; A < 3; ++A) {
    const auto& n = axis[A];
    s[0] += value[A] * n[0] * n[0], s[1] += value[A] * n[1] * n[1], s[2] += value[A] * n[2] * n[2];
    s[3] += value[A] * n[0] * n[1], s[4] += value[A] * n[1] * n[2], s[5] += value[A] * n[2] * n[0];
  }
  return s;
}

/// Eigenvalues of a symmetric tensor in a plane, the larger one first, and the direction of its axis. T: a
/// number, or several (platen/lanes.hpp).
template <class T> struct PlaneSpectralOf {
  T value_1, value_2;
  T cos, sin;
};
using PlaneSpectral = PlaneSpectralOf<double>;

/// Half-angle of (half, xy), without trigonometry and without cancellation.
template <class T> PlaneSpectralOf<T> plane_spectral(const T& xx, const T& yy, const T& xy) {
  using std::abs, std::sqrt, core::abs, core::sqrt, core::pick;
  const T zero{}, mean = (xx + yy) / 2, half = (xx - yy) / 2, radius = sqrt(half * half + xy * xy);
  const auto turned = radius > 0, upright = half >= 0;
  const T larger = sqrt((1 + abs(half) / radius) / 2), smaller = abs(xy) / (2 * radius * larger);
  const T cos = pick(upright, larger, smaller), sin = pick(upright, smaller, larger);
  return {mean + radius, mean - radius, pick(turned, cos, zero + 1),
          pick(turned, pick(xy < 0, -sin, sin), zero)};
}

/// xx, yy, xy of the symmetric tensor with the eigenvalues `first` and `second` on the axes of s.
inline std::array<double, 3> compose(double first, double second, const PlaneSpectral& s) {
  const double cc = s.cos * s.cos, ss = s.sin * s.sin;
  return {first * cc + second * ss, first * ss + second * cc, (first - second) * s.cos * s.sin};
}

} // namespace platen::fe
