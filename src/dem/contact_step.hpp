#pragma once
// One contact in one step, for pairs and walls of any host alike: viscous damping, and Coulomb friction with
// Mindlin's tangential stiffness. The normal force is Laws' (contacts.hpp).

#include "dem/contacts.hpp"

#include <cmath>

namespace platen::dem {

/// What a contact remembers: 40 bytes.
struct Memory {
  double gamma_max;     ///< largest overlap so far [m]
  double tangential[3]; ///< force on the first body [force]
  double k_t;           ///< its stiffness when it was stored [force/length]
};
inline constexpr int memory_size = sizeof(Memory) / sizeof(double);

/// The normal force with viscous damping, c = damping sqrt(dF/dgamma m) (damping.hpp). It never pulls: a
/// sphere that slides throughout has no more than mu J_n.
PLATEN_HOT double damped(double damping, const Units& u, double stiffness, double F, double mass,
                         double v_n) {
  if (!(F > 0)) return F; // apart
  return law::larger(F - damping * std::sqrt(stiffness * u.length / u.force * mass) * v_n, 0.0);
}

/// The tangential force follows the sliding with stiffness 8 G* a. When a shrinks it shrinks with it (else
/// unloading would leave more elastic energy than was put in: Thornton, Cummins & Cleary 2013), and friction
/// limits it.
PLATEN_HOT void slide(double shear, double friction, double a, double F_n, const double n[3],
                      const double v_t[3], double dt, Memory& m) {
  double* f = m.tangential;
  const double along = f[0] * n[0] + f[1] * n[1] + f[2] * n[2]; // the contact plane has turned
  const double k_t = shear * a, more = k_t * dt;
  const double keep = k_t / law::larger(law::larger(m.k_t, k_t), 1e-300); // 1 where a grows
  for (int k = 0; k < 3; ++k) f[k] = (f[k] - along * n[k]) * keep - more * v_t[k];
  const double size2 = f[0] * f[0] + f[1] * f[1] + f[2] * f[2], limit = F_n > 0 ? friction * F_n : 0;
  if (size2 > limit * limit) {
    const double scale = limit / std::sqrt(size2);
    for (int k = 0; k < 3; ++k) f[k] *= scale;
  }
  m.k_t = k_t;
}

} // namespace platen::dem
