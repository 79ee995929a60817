#pragma once
// Touching spheres in blocks, as a pair loop finds them: their laws, damping and friction, several contacts
// at once. Whoever has the loop fills a block, calls `normal_forces` and `step`, and adds up `push` and
// `turn`.

#include "dem/contact_step.hpp"

#include "platen/law/batch.hpp"

namespace platen::dem {

struct Block {
  static constexpr int size = law::Batch::size;
  using Numbers = law::Batch::Numbers;
  struct Vecs {
    alignas(64) Numbers x, y, z;
    PLATEN_HOT Vec operator[](int c) const { return {x[c], y[c], z[c]}; }
    PLATEN_HOT void set(int c, const Vec& v) { x[c] = v.x, y[c] = v.y, z[c] = v.z; }
  };

  // in, in units of the host
  int count = 0;
  Laws* laws[size];
  Memory* memory[size];
  alignas(64) Numbers distance2, R1, R2; ///< R1 of the sphere that has the first card
  Vecs apart;                            ///< x_i - x_j
  Vecs velocity;                         ///< v_i - v_j; with damping or friction
  Vecs spin;                             ///< R_i omega_i + R_j omega_j; with friction
  alignas(64) Numbers mass;              ///< m_i m_j/(m_i + m_j); with damping
  // out
  alignas(64) Numbers distance;
  alignas(64) Numbers flat;     ///< over the sum of radii. The contact divides the distance as the radii do:
                                ///< torques and forces keep the angular momentum
  alignas(64) Numbers from, to; ///< overlaps of the table that the cards cover; some laws have more
  Vecs push;                    ///< force on i, and less on j
  Vecs turn;                    ///< torque on i over -R_i, and on j over -R_j
  law::Batch law;
};

namespace detail {

PLATEN_HOT void find_laws(Block& b, const Units& u) {
  law::Batch& of = b.law;
  alignas(64) Block::Numbers t;
  bool plain = true;
  PLATEN_TOGETHER
  for (int c = 0; c < b.count; ++c) {
    const double d = std::sqrt(b.distance2[c]), reach = b.R1[c] + b.R2[c], per_reach = 1 / reach;
    b.distance[c] = d, b.flat[c] = d * per_reach, t[c] = (b.R1[c] - b.R2[c]) * per_reach;
    of.overlap[c] = (reach - d) * u.length;
    const law::Scale s = scale_of(reach * u.length, t[c]);
    of.R_e[c] = s.R_e, of.x_per_gamma[c] = s.x_per_gamma, of.force_scale[c] = s.force,
    of.pressure_scale[c] = 1;
  }
  for (int c = 0; c < b.count; ++c) {
    plain &= b.laws[c]->plain();
    of.gamma_max[c] = b.memory[c]->gamma_max;
  }
  if (plain) [[likely]]
    for (int c = 0; c < b.count; ++c) {
      Laws& laws = *b.laws[c];
      of.table[c] = laws.table(t[c]);
      if (laws.force_power == 2) continue;
      of.force_scale[c] = laws.force_of(of.R_e[c]);
      of.pressure_scale[c] = of.force_scale[c] / (of.R_e[c] * of.R_e[c]);
    }
  else
    for (int c = 0; c < b.count; ++c) {
      const Laws::At here = b.laws[c]->at(b.R1[c], b.R2[c]);
      of.law(c, *here.table, here.scale);
    }
  for (int c = 0; c < b.count; ++c) {
    const double to = of.table[c]->valid[0][1], cards = b.laws[c]->x_valid;
    b.from[c] = of.table[c]->valid[0][0], b.to[c] = law::detail::pick(cards < to, cards, to);
  }
}

} // namespace detail

/// The laws' forces, and the largest overlaps. `beyond(c)` is told when a contact first leaves what its cards
/// cover. Throws as Laws::at.
template <law::Want want, class Beyond>
PLATEN_HOT void normal_forces(Block& b, const Units& u, const Beyond& beyond) {
  detail::find_laws(b, u);
  law::Batch& of = b.law;
  law::evaluate<want>(of, b.count);
  std::int64_t valid_ones = 0;
  for (int c = 0; c < b.count; ++c) {
    const double x = of.gamma_max[c] * of.x_per_gamma[c];
    valid_ones += (b.from[c] <= x) & (x <= b.to[c]);
  }
  const auto valid = [&](int c, double gamma) {
    return b.laws[c]->valid(*of.table[c], gamma * of.x_per_gamma[c]);
  };
  if (valid_ones < b.count) [[unlikely]]
    for (int c = 0; c < b.count; ++c)
      if (const double before = b.memory[c]->gamma_max;
          before < of.gamma_max[c] && !valid(c, of.gamma_max[c]) && valid(c, before))
        beyond(c);
  for (int c = 0; c < b.count; ++c) b.memory[c]->gamma_max = of.gamma_max[c];
}

/// Forces and torques of a step dt; of one that takes no time, those of what is remembered.
template <bool friction, bool damping> PLATEN_HOT void step(Block& b, const Units& u, double dt) {
  alignas(64) Block::Numbers shear, mu, viscosity, k_t;
  Block::Vecs tangential;
  for (int c = 0; c < b.count; ++c) {
    const Laws& laws = *b.laws[c];
    if constexpr (friction) {
      shear[c] = laws.shear, mu[c] = laws.contact.friction;
      tangential.set(c, b.memory[c]->tangential), k_t[c] = b.memory[c]->k_t;
    }
    if constexpr (damping) viscosity[c] = laws.damping;
  }
  const double per_force = 1 / u.force;
  PLATEN_TOGETHER
  for (int c = 0; c < b.count; ++c) {
    const Vec n = 1 / b.distance[c] * b.apart[c];
    double F = b.law.force[c] * per_force, v_n = 0;
    Vec w;
    if constexpr (friction || damping) w = b.velocity[c], v_n = dot(w, n);
    if constexpr (damping) F = damped(viscosity[c], u, b.law.stiffness[c], F, b.mass[c], v_n);
    Vec push = F * n;
    if constexpr (friction) {
      const double flat = b.flat[c];
      const double now = shear[c] * b.law.contact_radius[c], limit = mu[c] * law::detail::pick(F > 0, F, 0);
      const Vec v_t = w - v_n * n + cross(n, flat * b.spin[c]), before = tangential[c];
      const Vec after = slide(before, k_t[c], now, limit, n, v_t, dt);
      const bool moves = dt > 0;
      const Vec s = {law::detail::pick(moves, after.x, before.x), law::detail::pick(moves, after.y, before.y),
                     law::detail::pick(moves, after.z, before.z)};
      tangential.set(c, s), k_t[c] = law::detail::pick(moves, now, k_t[c]);
      push = push + s;
      b.turn.set(c, flat * cross(n, s));
    }
    b.push.set(c, push);
  }
  if constexpr (friction)
    for (int c = 0; c < b.count; ++c) b.memory[c]->tangential = tangential[c], b.memory[c]->k_t = k_t[c];
}

} // namespace platen::dem
