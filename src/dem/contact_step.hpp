#pragma once
// One contact in one step, for pairs and walls of any host alike: viscous damping, and Coulomb friction with
// Mindlin's tangential stiffness. The normal force is Laws' (contacts.hpp). Without branches, so that many
// contacts can be taken together (contact_block.hpp).

#include "dem/contacts.hpp"

#include <cmath>

namespace platen::dem {

struct Vec {
  double x = 0, y = 0, z = 0;
};
PLATEN_HOT Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PLATEN_HOT Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PLATEN_HOT Vec operator*(double s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
PLATEN_HOT double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
PLATEN_HOT Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PLATEN_HOT Vec vec(const double* a) { return {a[0], a[1], a[2]}; }
PLATEN_HOT void add(double* sum, const Vec& a) { sum[0] += a.x, sum[1] += a.y, sum[2] += a.z; }

/// What a contact remembers: 40 bytes.
struct Memory {
  double gamma_max; ///< largest overlap so far [m]
  Vec tangential;   ///< force on the first body [force]
  double k_t;       ///< its stiffness when it was stored [force/length]
};
inline constexpr int memory_size = sizeof(Memory) / sizeof(double);

/// The normal force with viscous damping, c = damping sqrt(dF/dgamma m) (damping.hpp). It never pulls: a
/// sphere that slides throughout has no more than mu J_n. Bodies apart have none.
PLATEN_HOT double damped(double damping, const Units& u, double stiffness, double F, double mass,
                         double v_n) {
  const double viscous = F - damping * std::sqrt(stiffness * u.length / u.force * mass) * v_n;
  return law::detail::pick(F > 0, law::detail::pick(viscous < 0, 0, viscous), F);
}

/// The tangential force after a step dt with relative velocity v_t: it follows the sliding with stiffness
/// k_t = 8 G* a. When a shrinks it shrinks with it (else unloading would leave more elastic energy than was
/// put in: Thornton, Cummins & Cleary 2013), and friction limits it to `limit`.
PLATEN_HOT Vec slide(const Vec& before, double k_t_before, double k_t, double limit, const Vec& n,
                     const Vec& v_t, double dt) {
  constexpr double tiny = 1e-300;
  const double most = law::detail::pick(k_t < k_t_before, k_t_before, k_t);
  const double keep = k_t / law::detail::pick(tiny < most, most, tiny); // 1 where a grows
  const Vec f = keep * (before - dot(before, n) * n) - k_t * dt * v_t;  // the contact plane has turned
  const double size2 = dot(f, f);
  const bool slips = size2 > limit * limit;
  return law::detail::pick(slips, limit / std::sqrt(law::detail::pick(slips, size2, 1)), 1) * f;
}

} // namespace platen::dem
