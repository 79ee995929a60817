#pragma once
// Yield stress of von Mises over the equivalent plastic strain eps_p.

#include <algorithm>
#include <array>
#include <cassert>
#include <variant>
#include <vector>

namespace platen::material {

/// sigma = sigma_y.
struct PerfectlyPlastic {};

/// sigma = sigma_y exp(eta eps_p) (Edmans & Sinka, section 3.3: eta prescribes the evolution of von Mises).
struct ExponentialHardening {
  double eta; ///< exponent, any number with eta sigma_y > -3G
};

/// sigma = kappa eps^{1/m} over the total strain eps = eps_p + sigma/E (Shahin, eqs 2.2, 2.3). The law has no
/// yield stress of its own: it starts where it meets the elastic line, at eps_y = (kappa/E)^{1/(1 - 1/m)},
/// sigma_y = E eps_y, and there its slope over eps_p is the finite (E/m)/(1 - 1/m).
struct Hollomon {
  double kappa;     ///< strength coefficient (Pa), in (0, E)
  double inverse_m; ///< hardening exponent 1/m, in (0, 1]
};

/// sigma = sigma_y + K eps_p^{1/n} (Shahin, eq. 2.1). For 1/n < 1 the slope at eps_p = 0 is infinite: below
/// the eps_0 where it is 10 E, a parabola that joins in value and slope takes its place, so that the strain
/// at a given stress is changed by less than eps_0.
struct Ludwik {
  double K;         ///< strength coefficient (Pa), in (0, E)
  double inverse_n; ///< hardening exponent 1/n, > 0
};

/// Straight lines between the points; the last stress beyond the last strain.
struct HardeningTable {
  static constexpr int size_max = 100;
  std::array<double, size_max> strain{}; ///< equivalent plastic strain, from 0, ascending
  std::array<double, size_max> stress{}; ///< Pa, > 0
  int size = 0;                          ///< points in use, at least 2

  HardeningTable() = default;
  HardeningTable(const std::vector<double>& strain_, const std::vector<double>& stress_)
      : size(static_cast<int>(strain_.size())) {
    assert(size >= 2 && size <= size_max && stress_.size() == strain_.size());
    std::copy(strain_.begin(), strain_.end(), strain.begin());
    std::copy(stress_.begin(), stress_.end(), stress.begin());
  }
  double last_strain() const { return strain[size - 1]; }
};

using Hardening = std::variant<PerfectlyPlastic, ExponentialHardening, Hollomon, Ludwik, HardeningTable>;

/// sigma (Pa) and d(sigma)/d(eps_p) (Pa).
struct YieldStress {
  double value, slope;
};

/// Below eps_p = 0, where iterations may look, every law goes on as a straight line.
YieldStress yield_stress(const Hardening&, double E, double sigma_y, double eps_p);

/// Yield stress at eps_p = 0 (Pa): the law's own for Hollomon and a table, else `sigma_y`.
double initial_yield_stress(const Hardening&, double E, double sigma_y);

/// Whether the law knows its yield stress, so that a card must not give one.
bool has_own_yield_stress(const Hardening&);

} // namespace platen::material
