#pragma once
// Random finite increments from random admissible states, for every model with the corners of its parameters,
// and what must hold of every answer.

#include "material/reserve.hpp"
#include "random_states.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace platen::material::testing {

inline double largest(const std::array<double, 3>& x) {
  return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
}

/// Any strain of an elastic material.
inline Trial random_state(const Elastic&, std::mt19937& generator, double) {
  std::uniform_real_distribution<double> sign(-1, 1);
  return {{0.1 * sign(generator), 0.1 * sign(generator), 0.1 * sign(generator)}, 0};
}
/// Any direction of the stress, as far as the surface or ten strengths.
inline Trial random_state(const MohrCoulomb& m, std::mt19937& generator, double inside_min) {
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  std::array<double, 3> sigma{sign(generator), sign(generator), sign(generator)};
  const double strength = m.reference_stress(), start = 1e-3 * std::min(strength, m.cutoff);
  for (double& s : sigma) s *= start;
  const double reserve = std::min(stress_reserve(m, sigma, 0), 10 * strength / start) *
                         (inside_min + (1 - inside_min) * unit(generator));
  const double mean = (sigma[0] + sigma[1] + sigma[2]) / 3;
  const Moduli k = m.moduli(0);
  Trial state{{}, 0.3 * sign(generator)};
  for (int A = 0; A < 3; ++A) state.eps[A] = reserve * (mean / (3 * k.K) + (sigma[A] - mean) / (2 * k.G));
  return state;
}

/// Half of the states yield, one of twenty is relaxed; the increment is log-uniform from 1e-8 to 0.3, one of
/// ten along an edge.
template <class M> Trial random_increment(const M& m, std::mt19937& generator) {
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  Trial trial = random_state(m, generator, unit(generator) < 0.5 ? 1 : 0);
  if (unit(generator) < 0.05) trial.eps = {};
  const double size = 1e-8 * std::pow(3e7, unit(generator));
  for (double& e : trial.eps) e += size * sign(generator);
  if (unit(generator) < 0.1) trial.eps[1] = trial.eps[2];
  if (unit(generator) < 0.1) trial.eps[0] = trial.eps[1];
  // Beyond eps_v = 1 the elastic tension K eps_v e^{-eps_v} falls: no law for materials.
  const double beyond = std::max(0.0, trial.eps[0] + trial.eps[1] + trial.eps[2] - 0.95);
  for (double& e : trial.eps) e -= beyond / 3;
  return trial;
}

/// On the surface of a return in principal stresses, or inside; beside the strength the rounding of the trial
/// stress counts.
template <PrincipalModel M> double expect_not_beyond(const M& m, const PointUpdate& u) {
  const double size = std::max(m.reference_stress(), largest(u.sigma)) + 1e-5 * m.moduli(0).K;
  const double excess = m.excess(u.sigma);
  EXPECT_LE(excess, 1e-9 * size);
  if (u.zone != Zone::elastic) { EXPECT_GE(excess, -1e-9 * size); }
  return size;
}
inline void expect_admissible(const MohrCoulomb& m, const PointUpdate& u) {
  const double size = expect_not_beyond(m, u);
  if (u.zone == Zone::tension) {
    EXPECT_NEAR(*std::max_element(u.sigma.begin(), u.sigma.end()), m.cutoff, 1e-9 * size);
  }
}

/// Stress on the surface where it flows, inside where it does not; p on the part of it that the zone names.
template <InvariantModel M> void expect_admissible(const M& m, const PointUpdate& u) {
  const auto surface = m.surface(u.phi);
  if constexpr (PrincipalModel<M>)
    if (!in_invariants(m)) {
      expect_not_beyond(m, u);
      if (u.zone == Zone::tension) { EXPECT_NEAR(u.p, surface.p_apex(), 1e-9 * surface.p_apex()); }
      return;
    }
  if (u.zone == Zone::elastic) {
    EXPECT_TRUE(surface.contains(u.p, u.q));
    return;
  }
  EXPECT_NEAR(yield_ratio(surface, u.p, u.q), 1, 1e-8);
  EXPECT_GE(u.q, -1e-12 * m.moduli(u.phi).G); // on the axis it is rounding
  if constexpr (std::derived_from<M, Porous>) {
    const Porous::Strengths f = m.strengths(u.phi);
    if (u.zone == Zone::tension) { EXPECT_GE(u.p, -1e-9 * f.Lambda); }
    if (u.zone == Zone::shear) { EXPECT_GE(u.p, -f.pi_3 - 1e-9 * f.b); }
    if (u.zone == Zone::compaction) { EXPECT_LE(u.p, -f.pi_3 + 1e-9 * f.b); }
  }
  if constexpr (std::same_as<M, DruckerPrager>)
    if (u.zone == Zone::tension) { EXPECT_NEAR(u.p, surface.p_apex(), 1e-9 * surface.p_apex()); }
}
inline void expect_admissible(const Elastic&, const PointUpdate& u) { EXPECT_EQ(u.zone, Zone::elastic); }

/// The published flow of the Drucker-Prager Cap gives energy back.
template <class M> bool dissipates(const M&) { return true; }
inline bool dissipates(const Dpc& m) { return !m.published_flow; }

template <class M> void expect_right(const M& m, const Trial& t, const PointUpdate& u) {
  double sum = u.p + u.q + u.phi + u.dv + u.dw + u.plastic_work, sigma = 0, eps = 0, trial = 0;
  for (int A = 0; A < 3; ++A) {
    sigma += u.sigma[A], eps += u.eps[A], trial += t.eps[A];
    sum += u.sigma[A] + u.eps[A] + u.D[A][0] + u.D[A][1] + u.D[A][2];
  }
  ASSERT_TRUE(std::isfinite(sum));
  EXPECT_EQ(u.status == Status::elastic, u.zone == Zone::elastic);
  const double stress = initial_E(m) * 1e-12 + 1e-12 * largest(u.sigma);
  EXPECT_NEAR(u.p, sigma / 3, stress);
  EXPECT_NEAR(u.dv, trial - eps, 1e-12);
  if constexpr (requires { M::phi_rate; }) {
    EXPECT_NEAR(u.phi, t.phi + M::phi_rate.v * u.dv + M::phi_rate.w * u.dw, 1e-12);
  }
  expect_admissible(m, u);
  const double rounding = 1e-12 * (std::abs(u.p * u.dv) + std::abs(u.q * u.dw)) + 1e-14 * largest(u.sigma);
  if (u.zone != Zone::elastic && dissipates(m)) {
    EXPECT_GE(u.p * u.dv + u.q * u.dw, -rounding);
    EXPECT_GE(u.plastic_work, -rounding);
  }
}

/// The tangent against differences of fourth order, where the zone and the tangent itself hold still: true
/// where they were compared.
template <class M> bool tangent_compared(const M& m, const Trial& t, const PointUpdate& u) {
  const double h = std::min(1e-6, 1e-3 * invariants(t.eps).eps_q);
  if (h < 1e-9) return false;
  double scale = 1, error = 0, turn = 0;
  for (int B = 0; B < 3; ++B) {
    std::array<PointUpdate, 4> at;
    constexpr int steps[4] = {-2, -1, 1, 2};
    for (int k = 0; k < 4; ++k) {
      auto eps = t.eps;
      eps[B] += steps[k] * h;
      at[k] = update_one(m, eps, t.phi);
      if (at[k].zone != u.zone || is_refused(at[k].status)) return false;
    }
    for (int A = 0; A < 3; ++A) {
      const double slope =
          (at[0].sigma[A] - 8 * at[1].sigma[A] + 8 * at[2].sigma[A] - at[3].sigma[A]) / (12 * h);
      error = std::max(error, std::abs(slope - u.D[A][B]));
      for (int C = 0; C < 3; ++C) {
        scale = std::max(scale, std::abs(u.D[A][C]));
        turn = std::max({turn, std::abs(at[0].D[A][C] - u.D[A][C]), std::abs(at[3].D[A][C] - u.D[A][C])});
      }
    }
  }
  if (turn > 1e-2 * scale) return false;
  EXPECT_LT(error, 1e-5 * scale + 1e-14 * initial_E(m) / h);
  return true;
}

/// The same answer, whether a point is updated alone or beside seven others; the way to it may be another.
inline void expect_same(const PointUpdate& alone, const PointUpdate& beside) {
  EXPECT_EQ(is_refused(alone.status), is_refused(beside.status));
  EXPECT_EQ(alone.zone, beside.zone);
  if (is_refused(alone.status)) return;
  double stiffness = 0;
  for (const auto& row : alone.D) stiffness = std::max(stiffness, largest(row));
  const double stress = 1e-9 * largest(alone.sigma) + 1e-12 * stiffness;
  for (int A = 0; A < 3; ++A) {
    EXPECT_NEAR(alone.sigma[A], beside.sigma[A], stress);
    EXPECT_NEAR(alone.eps[A], beside.eps[A], 1e-11);
    for (int B = 0; B < 3; ++B) EXPECT_NEAR(alone.D[A][B], beside.D[A][B], 1e-6 * stiffness);
  }
  EXPECT_NEAR(alone.phi, beside.phi, 1e-11);
}

/// `count` increments shared among the materials, the tangents of one in `every` compared.
template <class M>
void check_increments(const char* name, const std::vector<M>& materials, long count, int every,
                      unsigned seed) {
  std::mt19937 generator(seed);
  const auto failures = [] {
    return ::testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
  };
  std::array<Trial, 8> trials;
  std::array<std::array<double, 3>, 8> eps;
  std::array<double, 8> phi;
  std::array<PointUpdate, 8> updates;
  long tried = 0, plastic = 0, bracketed = 0, refused = 0, unstable = 0, compared = 0;
  for (std::size_t k = 0; k < materials.size(); ++k)
    for (long i = 0; i < count / std::ssize(materials) + 1; ++i) {
      if (i % 8 == 0) {
        for (int n = 0; n < 8; ++n) {
          trials[n] = random_increment(materials[k], generator);
          eps[n] = trials[n].eps, phi[n] = trials[n].phi;
        }
        (void)update(materials[k], eps, phi, updates);
      }
      const Trial& t = trials[i % 8];
      const PointUpdate& u = updates[i % 8];
      const int before = failures();
      expect_same(update_one(materials[k], t.eps, t.phi), u);
      ++tried;
      plastic += u.zone != Zone::elastic;
      bracketed += u.status == Status::bracketed;
      refused += u.status == Status::refused;
      unstable += u.status == Status::unstable;
      if (!is_refused(u.status)) {
        expect_right(materials[k], t, u);
        if (i % every == 0) compared += tangent_compared(materials[k], t, u);
      }
      EXPECT_NE(u.status, Status::refused);
      ASSERT_EQ(failures(), before) << fmt::format("{}, material {}: eps {}, phi {}, zone {}, status {}",
                                                   name, k, fmt::join(t.eps, " "), t.phi, int(u.zone),
                                                   int(u.status));
    }
  std::printf("%-16s %ld increments: %ld plastic, %ld bracketed, %ld refused, %ld unstable, %ld tangents\n",
              name, tried, plastic, bracketed, refused, unstable, compared);
  EXPECT_GT(compared, tried / every / 4) << name;
}

/// Every model of the list, with the corners of its parameters and what lies beyond them.
inline void check_every_model(long count, int every) {
  check_increments<Elastic>("elastic", {{100, 0.3}, {1, 0}, {1e6, 0.49}}, count, every, 40);
  check_increments("von-mises", metals(), count, every, 41);
  check_increments("vmdc", corner_materials(), count, every, 42);
  check_increments("drucker-prager", rocks(), count, every, 43);
  check_increments("dpc", caps(), count, every, 44);
  check_increments("dpc-published", caps(true), count, every, 46);
  check_increments("mohr-coulomb", rocks_by_mohr(), count, every, 45);
  std::vector<DruckerPrager> sections = rocks();
  for (std::size_t i = 0; i < sections.size(); ++i)
    sections[i].flow_stress_ratio = i % 2 == 0 ? 7.0 / 9 : 0.9;
  check_increments("other sections", sections, count, every, 52);

  const auto hollomon = [](double E, double inverse_m) {
    return VonMises{E, 0, initial_yield_stress(Hollomon{1, inverse_m}, E, 0), Hollomon{1, inverse_m}};
  };
  check_increments<VonMises>("metals beyond",
                             {{1e6, 0, 1},
                              {2, 0.499, 1},
                              {100, 0.3, 1, ExponentialHardening{5}},
                              {100, 0.3, 1, ExponentialHardening{-80}},
                              {1000, 0.3, 1, Ludwik{900, 0.05}},
                              hollomon(1e5, 0.01),
                              hollomon(2, 0.9),
                              {1e4, 0.3, 1, HardeningTable{{0, 1e-4, 2e-4}, {1, 1.5, 0.5}}}},
                             count, every, 47);
  std::vector<Vmdc> granules;
  const Vmdc base{{0.7, 1, 100, 0.3, 1, 0.01, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}};
  const auto changed = [&](auto change) { change(granules.emplace_back(base)); };
  changed([](Vmdc& m) { m.nu = 0, m.xi_1 = -1; });               // nu at its lower bound
  changed([](Vmdc& m) { m.nu = 0.49, m.xi_1 = 2; });             // and at its upper
  changed([](Vmdc& m) { m.Lambda = 1e-6; });                     // hardly any tension
  changed([](Vmdc& m) { m.rho_r0 = 1; });                        // dense from the start
  changed([](Vmdc& m) { m.epsilon = 0.01, m.xi_2 = 0; });        // a cap at its bound
  changed([](Vmdc& m) { m.epsilon = 3; });                       // pi_3 = 0
  changed([](Vmdc& m) { m.E = 1e5; });                           // stiff
  changed([](Vmdc& m) { m.Gamma = 3, m.epsilon = 0.2; });        // strong in shear
  changed([](Vmdc& m) { m.eta = m.zeta = m.omega = m.xi = 0; }); // no hardening
  changed([](Vmdc& m) { m.eta = 1, m.zeta = 20, m.omega = -3; });
  check_increments("vmdc beyond", granules, count, every, 48);
  for (const bool published : {false, true}) {
    std::vector<Dpc> capped;
    for (const Vmdc& m : granules)
      if (m.epsilon * m.Gamma < m.sigma_y) capped.push_back(Dpc::through(m, published));
    check_increments(published ? "published beyond" : "dpc beyond", capped, count, every, 49);
  }
  check_increments<DruckerPrager>("rocks beyond",
                                  {{1e6, 0, 70, 1, 70},
                                   {1e6, 0.49, 70, 1, 0},
                                   {3, 0.3, 1, 1, 0.5},
                                   {1e5, 0.2, 30, 1, 1e-3},
                                   {1e7, 0.2, 5, 1, 2},
                                   {1e6, 0, 70, 1, 70, 0.8},
                                   {1e6, 0.49, 70, 1, 0, 7.0 / 9},
                                   {3, 0.3, 1, 1, 0.5, 0.8},
                                   {1e7, 0.2, 5, 1, 2, 0.99}},
                                  count, every, 50);
  check_increments<MohrCoulomb>("mohr beyond",
                                {{1e6, 0, 60, 1, 60, 0.1},
                                 {1e6, 0.49, 80, 1, 0, 1e-3},
                                 {3, 0.3, 1, 1, 0.5, 2},
                                 {1e5, 0.2, 30, 1, 30, 1e-4}},
                                count, every, 51);
}

} // namespace platen::material::testing
