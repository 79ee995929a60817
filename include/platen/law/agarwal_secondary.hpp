#pragma once
// The side contacts of a particle in a die, which nobody pushes: Shahin's thesis 2.6, (2.49)-(2.52),
// "preliminary" in its own words. A function of the *primary* overlap, without unloading; not reachable by
// name in the catalogue.
//
// Up to x = 0.1 the sides are pushed out by gamma_s = tau gamma^omega and follow the elastic and
// elastic-plastic law. (2.49) has no units: its lengths are in mm for R = 10 mm, so gamma_s/R = tau 10^(omega
// - 1) (gamma/R)^omega. From x_onset on (Table 2.4) all contacts of the particle carry the pressure of the
// primary ones; the area there is known at the onset alone, from (2.52). Between 0.1 and x_onset the thesis
// gives nothing, and neither do we.

#include "platen/law/agarwal_curve.hpp"

#include <optional>

namespace platen::law {

struct SecondaryContact {
  std::optional<double> H_bar; ///< mean pressure over sigma_y
  std::optional<double> a_bar; ///< contact radius over R
  std::optional<double> F_bar; ///< force over pi R^2 sigma_y
};

/// gamma_s/R = tau (gamma/R)^omega (2.49)-(2.51), without units.
struct SideMotion {
  double tau, omega;
};
inline SideMotion side_motion(double lambda) {
  const double tau = 1 / (1480.8863 * std::tanh(5.0261e-5 * std::pow(lambda, 1.2889)));
  const double omega = 5.7775 * std::tanh(0.0159 * std::pow(lambda, 0.6146));
  return {tau * std::pow(10.0, omega - 1), omega};
}

/// gamma_s/2R at primary overlap x = gamma/2R.
inline double secondary_overlap(double lambda, double x) {
  const auto [tau, omega] = side_motion(lambda);
  return tau * std::pow(2 * x, omega) / 2;
}

/// Primary overlap at which the sides enter the low-compressibility regime: Table 2.4, linear in ln lambda,
/// held outside its 163..4954.
inline double secondary_onset(double lambda) {
  constexpr double at[] = {163.08, 386.40, 1045.79, 2841.32, 4954.40},
                   onset[] = {0.4159, 0.4115, 0.4102, 0.41, 0.4098};
  if (lambda <= at[0]) return onset[0];
  for (int i = 1; i < 5; ++i)
    if (lambda <= at[i])
      return onset[i - 1] +
             (onset[i] - onset[i - 1]) * std::log(lambda / at[i - 1]) / std::log(at[i] / at[i - 1]);
  return onset[4];
}

/// `primary` is the curve of the die's primary contacts.
inline SecondaryContact secondary_contact(const AgarwalCurve<double>& primary, double x) {
  SecondaryContact side;
  if (x <= 0) return {0.0, 0.0, 0.0};
  if (x <= 0.1) {
    const double x_s = secondary_overlap(primary.lambda, x);
    double a = 0, a_log_slope = 0, H = 0, slope = 0;
    primary.contact_radius(x_s, a, a_log_slope);
    primary.hardness(x_s, H, slope);
    return {H, a, H * a * a};
  }
  const double onset = secondary_onset(primary.lambda);
  if (x < onset) return side;
  double H = 0, slope = 0;
  primary.hardness(x, H, slope);
  side.H_bar = H;
  if (x == onset) { // (2.52)
    const double pi = std::numbers::pi;
    side.a_bar = 12 * (1 - x) * std::sqrt(shahin_minimum_density_product) / pi;
    side.F_bar = H * *side.a_bar * *side.a_bar;
  }
  return side;
}

} // namespace platen::law
