#pragma once
// Many contacts at once, as a DEM code has them: the numbers of `evaluate` (table.hpp) but for rounding, in a
// half to nine tenths of the time, hertz's force in more (bench/law_bench.cpp). A contact alone waits for its
// root, its quotients and its power, and for a wrong guess whether it loads; here the processor takes eight
// or four together, and guesses nothing.
//
//   Batch b;
//   for (int c = 0; c < count; ++c) b.law(c, table, scale), b.overlap[c] = ..., b.gamma_max[c] = ...;
//   evaluate<Want::contact>(b, count);
//
// For GCC and Clang on x86-64; elsewhere one by one. Make it with -fno-math-errno, or roots are taken one by
// one.

#include "platen/lanes.hpp"
#include "platen/law/table.hpp"

#include <cstdint>
#include <utility>

#if defined(__x86_64__) && defined(__GNUC__) && (!defined(__clang__) || 18 <= __clang_major__) &&            \
    !defined(PLATEN_PLAIN)
#define PLATEN_BATCH_VECTORS
#endif
#ifdef __clang__
#define PLATEN_TOGETHER // it asks itself
#define PLATEN_EIGHT "arch=x86-64-v4"
#else
#define PLATEN_TOGETHER _Pragma("GCC ivdep")
#define PLATEN_EIGHT "arch=x86-64-v4,prefer-vector-width=512"
#endif

namespace platen::law {

/// What a host reads of a contact.
enum class Want {
  force,
  contact,   ///< stiffness and contact radius too
  everything ///< mean pressure, lost work and validity too
};

/// Up to 64 contacts; each may have a law of its own, which stays until another is given.
struct Batch {
  static constexpr int size = 64;
  using Numbers = double[size];

  // in
  const TableView* table[size] = {};
  alignas(64) Numbers R_e = {}, x_per_gamma = {}, force_scale = {}, pressure_scale = {}; ///< of its Scale
  alignas(64) Numbers overlap = {};                                                      ///< [m]
  alignas(64) Numbers gamma_max = {}; ///< largest overlap so far [m]; out: with this one
  // out, in SI
  alignas(64) Numbers force = {}, stiffness = {}, contact_radius = {};
  alignas(64) Numbers mean_pressure = {}, dissipated_work = {};
  bool in_range[size] = {};

  PLATEN_HOT void law(int c, const TableView& t, const Scale& s) {
    table[c] = &t;
    R_e[c] = s.R_e, x_per_gamma[c] = s.x_per_gamma, force_scale[c] = s.force, pressure_scale[c] = s.pressure;
  }
};

namespace detail {

constexpr unsigned bit_of(Shape shape) { return 1U << static_cast<unsigned>(shape); }

/// Where the loading curve is left, and what the tables say there.
struct Tops {
  using Numbers = Batch::Numbers;
  alignas(64) Numbers x, x_top, v, F, slope, a, w, alpha, lost;
  int one_by_one[Batch::size]; ///< contacts
  int one_by_one_count = 0;
  alignas(64) Numbers n, lambda, shape; ///< of Shape::difference; where there are several
  unsigned shapes = 0;                  ///< a bit for each Shape that is there
  bool powers = false;                  ///< some alpha is not 3/2

  void none(int c) {
    x[c] = F[c] = slope[c] = lost[c] = 0, alpha[c] = 1.5;
    x_top[c] = v[c] = w[c] = a[c] = 1;
  }
};

/// Overlaps in the measure of the tables.
template <Want want, bool alike> PLATEN_HOT void place(Batch& b, int count, Tops& tops) {
  const double elastic = b.table[0]->x_elastic, first = b.table[0]->x_first;
  std::int64_t usual = 0;
  PLATEN_TOGETHER
  for (int c = 0; c < count; ++c) {
    const double before = b.gamma_max[c], x = b.overlap[c] * b.x_per_gamma[c];
    const double x_max = larger(x, before * b.x_per_gamma[c]);
    const double x_top = pick(x_max <= (alike ? elastic : b.table[c]->x_elastic), x, x_max);
    const bool good =
        ((alike ? first : b.table[c]->x_first) < x_top) & (x_top <= TableView::x_limit) & (0 <= before);
    tops.x[c] = x, tops.x_top[c] = pick(good, x_top, -1);
    usual += good;
  }
  tops.one_by_one_count = 0;
  if (usual < count) [[unlikely]]
    for (int c = 0; c < count; ++c)
      if (tops.x_top[c] < 0) tops.one_by_one[tops.one_by_one_count++] = c;
  for (int c = 0; c < count; ++c) tops.v[c] = std::sqrt(larger(tops.x_top[c], 0.0));
  if constexpr (alike && want == Want::everything) {
    const TableView t = *b.table[0];
    for (int c = 0; c < count; ++c)
      b.in_range[c] = t.in_range(larger(tops.x[c], b.gamma_max[c] * b.x_per_gamma[c]));
  }
}

/// Contact by contact, since each has a cell of its own: all cells first, so that the processor waits for
/// several.
template <Want want, bool alike> PLATEN_HOT void look_up(Batch& b, int count, Tops& tops) {
  const TableView first = *b.table[0]; // a copy, which no number that is stored can change
  bool powers = false;
  unsigned shapes = 0;
  const Cell* cells[Batch::size];
  for (int c = 0; c < count; ++c) {
    const TableView& t = alike ? first : *b.table[c];
    if (tops.x_top[c] < 0) [[unlikely]]
      continue; // a table may have no cells at all
    cells[c] = t.cell(tops.x_top[c]);
  }
  for (int c = 0; c < count; ++c) {
    const TableView& t = alike ? first : *b.table[c];
    const double x = tops.x[c], x_top = tops.x_top[c];
    if (x_top < 0) [[unlikely]] {
      tops.none(c);
      continue;
    }
    const Cell* cell = cells[c];
    const double s = tops.v[c] - cell->left;
    tops.F[c] = cell->F.value(s), tops.w[c] = cell->w.value(s);
    tops.alpha[c] = cell->alpha + s * cell->alpha_slope;
    if constexpr (!alike) powers |= !t.all_three_halves, shapes |= bit_of(t.shape);
    if constexpr (want != Want::force) {
      tops.slope[c] = cell->F.slope(s);
      tops.a[c] = cell->a.value(s);
    }
    if constexpr (want == Want::everything) {
      tops.lost[c] = cell->lost.value(s);
      if constexpr (!alike) b.in_range[c] = t.in_range(larger(x, b.gamma_max[c] * b.x_per_gamma[c]));
      if (x_top < tops.w[c] * (1 - 1e-9)) [[unlikely]] { // some published curves: force at the parting
        tops.one_by_one[tops.one_by_one_count++] = c;
        continue;
      }
    }
    b.gamma_max[c] = larger(b.overlap[c], b.gamma_max[c]);
  }
  tops.powers = alike ? !first.all_three_halves : powers, tops.shapes = alike ? bit_of(first.shape) : shapes;
}

/// (acos(1 - xi) - (1 - xi) sqrt(2 xi - xi^2))/xi^(3/2) as its series, for xi in [0, 1]: to 1e-15.
struct SegmentSeries {
  static constexpr int count = 44;
  double of[count] = {};
  constexpr SegmentSeries() {
    double term = 2 * std::numbers::sqrt2; // of the root of 8 (1 - xi/2), which is integrated
    for (int k = 0; k < count; term *= (k - 0.5) / (2.0 * (k + 1)), ++k) of[k] = term / (k + 1.5);
  }
};
inline constexpr SegmentSeries segment;

/// Every second term from `first` on; written out, or the loop around it is not taken several at once.
template <std::size_t... k> PLATEN_HOT double every_second(int first, double xi2, std::index_sequence<k...>) {
  double sum = 0;
  ((sum = sum * xi2 + segment.of[SegmentSeries::count - 2 - 2 * static_cast<int>(k) + first]), ...);
  return sum;
}

/// u^y of u in (0, 1].
PLATEN_HOT double power_of_part(double u, double y) {
  const double exponent = y * core::detail::log_of_normal(u);
  return core::detail::exp_within(pick(exponent < -700, -700, exponent));
}

/// How contacts unload, several at a time: numbers over those where the loading curve is left (xi = 1).
template <Shape shape, bool powers> struct Shaped {
  double force, slope, radius, pressure; ///< over F, F, a, F/(pi a^2)
  PLATEN_HOT Shaped(const Tops& tops, int c, double xi, double rate, bool touching) {
    const double base = pick(touching, xi, 0);
    if constexpr (shape == Shape::power) {
      radius = powers ? pick(touching, power_of_part(pick(touching, xi, 1), tops.alpha[c] - 1), 0)
                      : std::sqrt(base);
      force = base * radius;
      slope = tops.alpha[c] * radius * rate;
      pressure = powers ? base / pick(touching, radius, 1) : radius;
    } else if constexpr (shape == Shape::indenter) {
      constexpr auto half = std::make_index_sequence<SegmentSeries::count / 2>{};
      const double square = base * base, root2 = base * (2 - base);
      radius = std::sqrt(root2);
      force = 2 / std::numbers::pi * base * std::sqrt(base) *
              (every_second(0, square, half) + base * every_second(1, square, half));
      slope = 4 / std::numbers::pi * radius * rate;
      pressure = force / pick(touching, root2, 1);
    } else {
      const double x = pick(touching, tops.x[c], 1), x_top = pick(touching, tops.x_top[c], 1);
      const double rest = 1 - tops.lambda[c], per = 1 / (rest * x_top), per_x = 1 / x; // quotients are dear
      const double u = x * (rest * per), root = std::sqrt(u);
      const double p = powers ? power_of_part(u, tops.n[c]) : u * root;
      const bool bears = touching & (tops.lambda[c] < p);
      force = pick(bears, (p - tops.lambda[c]) * (x_top * per), 0);
      slope = pick(touching, tops.n[c] * p * (x_top * per) * per_x, 0);
      radius = pick(touching, root, 0);
      pressure = force * (x_top * per_x);
    }
  }
};

/// The compiler takes as many contacts at once as a vector of the processor has numbers. Of several shapes
/// each has its turn, and keeps its own.
template <Want want, Shape shape, bool powers, bool mixed>
PLATEN_HOT void unload(Batch& b, int count, const Tops& tops) {
  PLATEN_TOGETHER
  for (int c = 0; c < count; ++c) {
    const double x = tops.x[c], x_top = tops.x_top[c], F = tops.F[c];
    const double rate = 1 / tops.w[c], xi = 1 - (x_top - x) * rate;
    const Shaped<shape, powers> below(tops, c, xi, rate, (0 < xi) & (0 < x));
    const bool mine = !mixed || tops.shape[c] == static_cast<double>(shape);
    const auto give = [&](double& to, double value) { to = mixed ? pick(mine, value, to) : value; };
    give(b.force[c], b.force_scale[c] * F * below.force);
    if constexpr (want != Want::force) {
      const double slope = pick(x < x_top, F * below.slope, tops.slope[c] / (2 * tops.v[c]));
      give(b.stiffness[c], b.force_scale[c] * b.x_per_gamma[c] * slope);
      give(b.contact_radius[c], b.R_e[c] * tops.a[c] * below.radius);
    }
    if constexpr (want == Want::everything) {
      give(b.mean_pressure[c],
           b.pressure_scale[c] * F * below.pressure / (std::numbers::pi * tops.a[c] * tops.a[c]));
      b.dissipated_work[c] = b.force_scale[c] / b.x_per_gamma[c] * tops.lost[c];
    }
  }
}

template <Want want, bool mixed> PLATEN_HOT void unload(Batch& b, int count, Tops& tops) {
  bool powers = false; // some n is not 3/2
  if (tops.shapes & bit_of(Shape::difference))
    for (int c = 0; c < count; ++c) {
      tops.n[c] = b.table[c]->n, tops.lambda[c] = b.table[c]->lambda_p;
      powers |= tops.n[c] != 1.5;
    }
  if constexpr (mixed)
    for (int c = 0; c < count; ++c) tops.shape[c] = static_cast<double>(b.table[c]->shape);
  if (tops.shapes & bit_of(Shape::power)) {
    if (tops.powers) unload<want, Shape::power, true, mixed>(b, count, tops);
    else unload<want, Shape::power, false, mixed>(b, count, tops);
  }
  if (tops.shapes & bit_of(Shape::indenter)) unload<want, Shape::indenter, false, mixed>(b, count, tops);
  if (tops.shapes & bit_of(Shape::difference)) {
    if (powers) unload<want, Shape::difference, true, mixed>(b, count, tops);
    else unload<want, Shape::difference, false, mixed>(b, count, tops);
  }
}

inline void one_by_one(Batch& b, int c) {
  const double per = b.x_per_gamma[c], force = b.force_scale[c];
  const Scale s{b.R_e[c], per, force, force / per, b.pressure_scale[c]};
  const Response now = evaluate(*b.table[c], s, State{0, b.gamma_max[c]}, b.overlap[c]);
  b.gamma_max[c] = now.state.gamma_max, b.force[c] = now.force;
  b.stiffness[c] = now.stiffness, b.contact_radius[c] = now.contact_radius;
  b.mean_pressure[c] = now.mean_pressure, b.dissipated_work[c] = now.dissipated_work;
  b.in_range[c] = now.in_range;
}

template <Want want> PLATEN_HOT void evaluate_together(Batch& b, int count) {
  if (count < 1) return;
  Tops tops;
  std::uintptr_t unlike = 0;
  for (int c = 0; c < count; ++c)
    unlike |= std::bit_cast<std::uintptr_t>(b.table[c]) ^ std::bit_cast<std::uintptr_t>(b.table[0]);
  if (unlike == 0) place<want, true>(b, count, tops), look_up<want, true>(b, count, tops);
  else place<want, false>(b, count, tops), look_up<want, false>(b, count, tops);
  if (tops.shapes & (tops.shapes - 1)) [[unlikely]]
    unload<want, true>(b, count, tops);
  else unload<want, false>(b, count, tops);
  for (int k = 0; k < tops.one_by_one_count; ++k) one_by_one(b, tops.one_by_one[k]);
}

#ifdef PLATEN_BATCH_VECTORS
template <Want want> [[gnu::target(PLATEN_EIGHT)]] void evaluate_by_eight(Batch& b, int count) {
  evaluate_together<want>(b, count);
}
template <Want want> [[gnu::target("arch=x86-64-v3")]] void evaluate_by_four(Batch& b, int count) {
  evaluate_together<want>(b, count);
}
#endif
inline void evaluate_in_turn(Batch& b, int count) {
  for (int c = 0; c < count; ++c) one_by_one(b, c);
}

} // namespace detail

/// The contacts 0 to count - 1, as `evaluate` of table.hpp has them. What is not wanted is left undefined.
template <Want want = Want::everything> void evaluate(Batch& b, int count) {
#ifdef PLATEN_BATCH_VECTORS
  static void (*const best)(Batch&, int) =
      __builtin_cpu_supports("x86-64-v4")   ? detail::evaluate_by_eight<want>
      : __builtin_cpu_supports("x86-64-v3") ? detail::evaluate_by_four<want>
                                            : detail::evaluate_in_turn;
  best(b, count);
#else
  detail::evaluate_in_turn(b, count);
#endif
}

} // namespace platen::law

#undef PLATEN_EIGHT
