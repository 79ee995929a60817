#pragma once

#include "material/porous.hpp"

#include <cmath>
#include <type_traits>

namespace platen::material {

/// von Mises Double Cap (Edmans & Sinka, Table 2, eqs 3a-5b).
///
///   tension     (p/Lambda)^2 + (q/Gamma)^2 = 1                        p > 0
///   shear       q = Gamma                                             0 >= p >= -pi_3
///   compaction  ((p + pi_3)/(sigma_y - pi_3))^2 + (q/Gamma)^2 = 1     p < -pi_3,  pi_3 = sigma_y - epsilon
///   Gamma
///
/// associated flow.
struct Vmdc : Porous {
  static constexpr std::string_view name = "vmdc";
  static const CardSection<Vmdc>& card();

  /// Along s the point moves in p at unit rate where the pieces meet, so that the curve is C1 in s:
  /// tension s in [-2 Lambda, 0], shear [0, pi_3], compaction [pi_3, pi_3 + 2b], b = sigma_y - pi_3. On a cap
  /// s is twice the semi-axis times the tangent of half the angle: no trigonometry.
  template <class T> struct SurfaceOf : StrengthsOf<T> {
    using StrengthsOf<T>::Lambda, StrengthsOf<T>::Gamma, StrengthsOf<T>::pi_3, StrengthsOf<T>::b;
    using StrengthsOf<T>::Lambda_phi, StrengthsOf<T>::Gamma_phi, StrengthsOf<T>::pi_3_phi,
        StrengthsOf<T>::b_phi;

    T s_min() const { return -2 * Lambda; }
    T s_max() const { return pi_3 + 2 * b; }

    SurfacePointOf<T> at(const T& s) const {
      const T zero{}, one = zero + 1;
      const SurfacePointOf<T> top{-s, Gamma, -one, zero, zero, Gamma_phi, zero, one, zero, zero, zero, zero};
      if constexpr (std::is_same_v<T, double>) {
        if (s < 0) return cap(s / (2 * Lambda), Lambda, Lambda_phi, 0, 0);
        return s <= pi_3 ? top : cap((s - pi_3) / (2 * b), b, b_phi, pi_3, pi_3_phi);
      } else {
        using core::pick;
        const auto tension = s < 0, shear = (s >= 0) & (s <= pi_3);
        const T c = pick(tension, Lambda, b), p0 = pick(tension, zero, pi_3);
        const auto on_cap =
            cap((s - p0) / (2 * c), c, pick(tension, Lambda_phi, b_phi), p0, pick(tension, zero, pi_3_phi));
        const auto either = [&](T SurfacePointOf<T>::*of) { return pick(shear, top.*of, on_cap.*of); };
        using P = SurfacePointOf<T>;
        return {either(&P::p),     either(&P::q),     either(&P::p_s),     either(&P::q_s),
                either(&P::p_phi), either(&P::q_phi), either(&P::n_p),     either(&P::n_q),
                either(&P::n_p_s), either(&P::n_q_s), either(&P::n_p_phi), either(&P::n_q_phi)};
      }
    }
    core::Mask<T> contains(const T& p, const T& q) const {
      using core::pick;
      const T excess = pick(p > 0, p / Lambda, pick(p < -pi_3, (p + pi_3) / b, T{})), y = q / Gamma;
      return excess * excess + y * y <= 1;
    }
    /// On a cap the return keeps q where q < Gamma: the caps give way volumetrically first. Beyond, it meets
    /// the cap near its top, where the normal points along what is left of the strain: tan t = c dv/(Gamma
    /// dw).
    T first_guess(const T& p, const T& q, const ModuliOf<T>& m) const {
      using std::sqrt, core::sqrt, core::pick;
      const auto half_tangent = [](const T& cos_t) -> T { return sqrt((1 - cos_t) / (1 + cos_t)); };
      const auto tension = p > 0;
      const T c = pick(tension, Lambda, b), excess = pick(tension, p, -p - pi_3);
      const T y = q / Gamma, x = excess / c;
      const T dv = c * excess / m.K, dw = Gamma * (q - Gamma) / (3 * m.G);
      const T beyond = half_tangent(dw / sqrt(dv * dv + dw * dw)), within = x / (1 + sqrt(1 - x * x));
      const T u = pick(y < 1, half_tangent(y), pick(core::both(x < 1, within < beyond), within, beyond));
      return pick(tension, -2 * c * u, pick(p < -pi_3, pi_3 + 2 * c * u, -p));
    }
    /// Of lanes a number, that of the zone.
    auto zone(const T& s) const {
      if constexpr (std::is_same_v<T, double>)
        return s < 0 ? Zone::tension : s <= pi_3 ? Zone::shear : Zone::compaction;
      else {
        const auto number = [](Zone zone) { return T{} + static_cast<double>(zone); };
        return core::pick(s < 0, number(Zone::tension),
                          core::pick(s <= pi_3, number(Zone::shear), number(Zone::compaction)));
      }
    }

   private:
    /// Elliptic cap with semi-axes (c, Gamma) about p = -p0: p = -p0 - c sin t, q = Gamma cos t, u =
    /// tan(t/2).
    SurfacePointOf<T> cap(const T& u, const T& c, const T& c_phi, const T& p0, const T& p0_phi) const {
      using std::sqrt, core::sqrt;
      const T t_u = 2 / (1 + u * u), sin_t = u * t_u, cos_t = t_u - 1;
      const T t_s = t_u / (2 * c), t_phi = -(p0_phi + 2 * u * c_phi) * t_s;
      const T p_t = -c * cos_t, q_t = -Gamma * sin_t;
      // The normal (-Gamma sin t, c cos t), made a unit vector by its length.
      const T n_p = -Gamma * sin_t, n_q = c * cos_t;
      const T per_length = 1 / sqrt(n_p * n_p + n_q * n_q);
      const T m_p = n_p * per_length, m_q = n_q * per_length;
      const auto turned = [&](const T& dn_p, const T& dn_q) -> T {
        return (m_q * dn_p - m_p * dn_q) * per_length;
      };
      const T turn_t = turned(-Gamma * cos_t, -c * sin_t);
      const T turn_phi = turned(-Gamma_phi * sin_t, c_phi * cos_t) + turn_t * t_phi;
      const T turn_s = turn_t * t_s;
      return {-p0 - c * sin_t,
              Gamma * cos_t,
              p_t * t_s,
              q_t * t_s,
              -p0_phi - c_phi * sin_t + p_t * t_phi,
              Gamma_phi * cos_t + q_t * t_phi,
              m_p,
              m_q,
              m_q * turn_s,
              -m_p * turn_s,
              m_q * turn_phi,
              -m_p * turn_phi};
    }
  };
  using Surface = SurfaceOf<double>;

  template <class T> Properties<SurfaceOf<T>, T> properties(T phi) const {
    return evolved<SurfaceOf<T>>(phi);
  }
  Surface surface(double phi) const { return strengths<Surface>(phi); }
};

} // namespace platen::material
