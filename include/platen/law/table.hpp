#pragma once
// What runs in a contact loop: any law as one table. Over the largest overlap so far it holds force, contact
// radius, and how unloading goes, as cubics of v = sqrt(x), in which Hertz's force and radius are cubics
// themselves. Without length and without radius: of two bodies whose A R_e (pair.hpp) is that of the table,
// the Scale says how large they are. tabulate.hpp makes tables.
//
//   x = gamma x_per_gamma,   F = scale.force F(x),   a = R_e a(x),   W = scale.force/x_per_gamma int F dx
//   unloading F xi^alpha, xi = 1 - (x_max - x)/w: w is the overlap that it gives back

#include "platen/law/contact.hpp"
#include "platen/law/cubic.hpp"
#include "platen/law/pair.hpp"

#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace platen::law {

namespace detail {

/// a or b without a jump: which one it is can hardly be foreseen from contact to contact, and a wrong guess
/// costs more than the rest.
PLATEN_HOT double pick(bool first, double a, double b) {
  const std::uint64_t mask = -static_cast<std::uint64_t>(first);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & mask) |
                               (std::bit_cast<std::uint64_t>(b) & ~mask));
}

} // namespace detail

/// Size of two bodies in contact.
struct Scale {
  double R_e = 0;         ///< radius of the equivalent equal pair [m]
  double x_per_gamma = 0; ///< [1/m]
  double force = 0;       ///< R_e^2, or what force goes with [m^2]
  double work = 0;        ///< force/x_per_gamma
  double pressure = 1;    ///< force/R_e^2
};

/// One stretch of overlaps, t = v - left.
struct Cell {
  double left = 0; ///< where it begins, in v
  double end = 0;  ///< in x
  Cubic F, w, a;
  Cubic lost; ///< work that unloading does not give back; it never falls
  double alpha = 1.5, alpha_slope = 0;
};

/// Force, contact radius and unloading at one overlap x, in units of the table.
struct Top {
  double F = 0, slope = 0, a = 0, w = 0, alpha = 1.5, lost = 0;
  double per_area = 0; ///< 1/(pi a^2); not below the cells

  /// What unloading gives back, where it ends before the bodies part.
  [[nodiscard]] PLATEN_HOT double back() const { return F * w / (1 + alpha); }
  /// Of loading.
  [[nodiscard]] PLATEN_HOT double work() const { return lost + back(); }
};

/// A table without ownership: plain data that may be copied to another device with what it points to.
struct TableView {
  static constexpr double x_limit = 1000; ///< from here on everything is held

  const Cell* cells = nullptr;
  const std::uint16_t* slot = nullptr; ///< the cell at the left end of each slot
  std::int64_t base = 0;
  int bits = 6; ///< 2^bits slots an octave of x lead to the cells
  int slots = 0;
  Top first;                           ///< at x_first
  double x_first = 0;                  ///< up to here powers of x; `first` without force: no contact
  double n_first = 1.5, m_first = 0.5; ///< exponents of force and radius there
  double x_elastic = 0;                ///< up to here unloading retraces the loading curve
  double valid[2][2] = {};             ///< the law was made for overlaps in either interval
  Shape shape = Shape::power;
  double n = 1.5, lambda_p = 0;  ///< of Shape::difference
  bool all_three_halves = false; ///< alpha is 3/2 wherever it is followed

  [[nodiscard]] PLATEN_HOT bool in_range(double x) const {
    return ((valid[0][0] <= x) & (x <= valid[0][1])) | ((valid[1][0] <= x) & (x <= valid[1][1]));
  }

  /// Of x from x_first to x_limit, from its bits. Most slots have one cell or two: the second is not guessed.
  [[nodiscard]] PLATEN_HOT const Cell* cell(double x) const {
    const auto bits_of_x = std::bit_cast<std::int64_t>(x);
    std::int64_t k = (bits_of_x >> (52 - bits)) - base;
    k = k < slots ? k : slots - 1;
    k = k < 0 ? 0 : k;
    std::uint64_t at = slot[k];
    at += static_cast<std::uint64_t>(std::bit_cast<std::int64_t>(cells[at].end) - bits_of_x - 1) >>
          63; // end <= x
    const Cell* c = cells + at;
    while (c->end <= x) ++c;
    return c;
  }

  [[nodiscard]] PLATEN_HOT Top top(double x) const { return x < x_first ? start(x) : in_cells(x); }

  /// The cell is found from the bits of x, while the root is still on its way, and one division serves both
  /// quotients: a contact waits for little else.
  [[nodiscard]] PLATEN_HOT Top in_cells(double x) const {
    const double v = std::sqrt(x);
    const Cell* c = cell(x);
    const double t = v - c->left, a = c->a.value(t);
    const double area = std::numbers::pi * a * a, twice_v = 2 * v, per_both = 1 / (area * twice_v);
    return {c->F.value(t),     c->F.slope(t) * (per_both * area), a,
            c->w.value(t),     c->alpha + t * c->alpha_slope,     c->lost.value(t),
            per_both * twice_v};
  }

  /// Below the cells.
  [[nodiscard]] PLATEN_RARE Top start(double x) const {
    const double u = x / x_first, part = power(u, n_first);
    const double F = first.F * part, a = first.a * power(u, m_first);
    return {F, n_first * F / x, a, first.w * u, first.alpha, first.lost * part * u};
  }
};

/// How far a table may be from the formulas that it is made from, relative.
struct TableAccuracy {
  double force = 2e-5, slope = 2e-4, radius = 5e-5, rate = 3e-5;
  double lost = 3e-5;  ///< over the work of loading
  int bits = 6;        ///< of a TableView
  double bent = 1e-12; ///< unloading that ends so near the origin, over x, ends there
  int octaves = 1;     ///< of a cell, at most
};
/// Two fifths of the memory, where the ratio of radii is rounded.
inline constexpr TableAccuracy coarse_table{2e-4, 2e-3, 1e-3, 1e-3, 1e-3};
/// A tenth, of unlike bodies: the rule that joins them is right to a few per cent (joined.hpp).
inline constexpr TableAccuracy joined_table{9e-4, 5e-2, 5e-3, 1e-2, 3e-3, 3, 3e-4, 2};

/// A table and its cells.
struct Table : TableView {
  std::vector<Cell> cell_list;
  std::vector<std::uint16_t> slot_list;

  Table() = default;
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(Table) + cell_list.size() * sizeof(Cell) + slot_list.size() * sizeof(slot_list[0]);
  }
};

namespace detail {

/// Force, its slope over x and the contact radius below the largest overlap, each over its value F or a
/// there.
struct Below {
  double force = 0, slope = 0, radius = 0;
};

/// On unloading, of a shape that is no power.
PLATEN_RARE Below own_shape(const TableView& t, double xi, double x, double x_top, double rate) {
  if (!(0 < xi && 0 < x)) return {};
  if (t.shape == Shape::indenter) {
    const double radius = std::sqrt(xi * (2 - xi));
    // acos(1 - xi) - (1 - xi) sqrt(2 xi - xi^2), whose terms cancel for small xi
    const double area = xi < 1e-4 ? 4.0 / 3 * std::sqrt(2 * xi) * xi : std::acos(1 - xi) - (1 - xi) * radius;
    return {2 / std::numbers::pi * area, 4 / std::numbers::pi * radius * rate, radius};
  }
  const double u = x / x_top, p = t.n == 1.5 ? u * std::sqrt(u) : power(u, t.n), rest = 1 - t.lambda_p;
  return {larger((p - t.lambda_p) / rest, 0.0), t.n * p / (rest * x), std::sqrt(u)};
}

/// Overlaps of a contact, and the same in units of the table; at x_top the loading curve is left.
struct Place {
  State state;
  double x = 0, x_max = 0, x_top = 0;
};

PLATEN_HOT Response respond(const TableView& t, const Scale& s, const State& old, const Place& at,
                            const Top& top) {
  Response now;
  now.state = at.state;
  now.in_range = t.in_range(at.x_max);
  const double x = at.x, x_top = at.x_top, rate = 1 / top.w, xi = 1 - (x_top - x) * rate;
  now.dissipated_work = s.work * top.lost;
  if (const double left = 1 - rate * x_top; 1e-9 < left)
      [[unlikely]] // some published curves: force at the parting
    now.dissipated_work += s.work * top.back() * left * power(left, top.alpha);
  const bool touching = (0 < xi) & (0 < x);
  double force = 1, slope = top.slope, radius = 1, pressure = 1; // over F, 1, a, F/(pi a^2) at the top
  if (x < x_top) { // asked early: the processor guesses, and a wrong guess costs less the sooner it is seen
    if (t.shape == Shape::power) {
      const double base = pick(touching, xi, 0);
      radius = t.all_three_halves ? std::sqrt(base) : pick(touching, fast_power(base, top.alpha - 1), 0);
      force = base * radius;
      slope =
          top.F * top.alpha * radius * rate; // dF/dgamma stays proportional to a, as for any elastic punch
      pressure = t.all_three_halves ? radius : pick(touching, base / radius, 0);
    } else {
      const Below below = own_shape(t, xi, x, x_top, rate);
      force = below.force, slope = top.F * below.slope, radius = below.radius;
      pressure = touching ? force / (radius * radius) : 0;
    }
  }
  now.force = s.force * top.F * force;
  now.stiffness = s.force * s.x_per_gamma * slope;
  now.contact_radius = s.R_e * top.a * radius;
  now.mean_pressure = s.pressure * top.F * top.per_area * pressure;
  const bool loading = old.gamma_max < at.state.gamma;
  const int going = 3 - 2 * loading - ((at.state.gamma < old.gamma) & !loading);
  now.branch = static_cast<Branch>(touching * going);
  return now;
}

/// Apart, before the cells, beyond the limit, no number, or no memory.
PLATEN_RARE Response respond_outside(const TableView& t, const Scale& s, const State& old, double overlap) {
  Response now;
  const double limit = TableView::x_limit / s.x_per_gamma * (1 + 1e-9);
  if (overlap != overlap || !(0 <= old.gamma_max && old.gamma_max <= limit)) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    now.force = now.stiffness = now.contact_radius = now.mean_pressure = now.dissipated_work = none;
    now.state = old;
    now.in_range = false;
    return now;
  }
  const bool beyond = TableView::x_limit < overlap * s.x_per_gamma;
  const double gamma = beyond ? TableView::x_limit / s.x_per_gamma : overlap;
  const double gamma_max = larger(gamma, old.gamma_max);
  const double x = gamma * s.x_per_gamma, x_max = gamma_max * s.x_per_gamma;
  const double x_top = x_max <= t.x_elastic ? x : x_max;
  now.state = {gamma, gamma_max};
  now.in_range = x_max <= 0 || t.in_range(x_max); // never touched: nothing that could be wrong
  if (0 < x_top)                                  // else never touched, or apart without a trace
    if (const Top top = t.top(x_top); 0 < top.F)  // so small an overlap may have no force
      now = respond(t, s, old, {now.state, x, x_max, x_top}, top);
  now.mean_pressure = mean_pressure(now.force, now.contact_radius);
  if (beyond) now.stiffness = 0, now.in_range = false;
  return now;
}

} // namespace detail

/// The whole law in one pure step: remembered state and overlap in, response and new state out. An overlap
/// that is no number, or a memory that no overlap could have left, gives a response that is none, and leaves
/// the memory alone.
PLATEN_HOT Response evaluate(const TableView& t, const Scale& s, const State& old, double overlap) {
  const double x = overlap * s.x_per_gamma, x_max = larger(x, old.gamma_max * s.x_per_gamma);
  const double x_top = detail::pick(x_max <= t.x_elastic, x, x_max);
  if (!(t.x_first < x_top && x_top <= TableView::x_limit && 0 <= old.gamma_max)) [[unlikely]] {
    const Response far = detail::respond_outside(t, s, old, overlap);
    // member by member: as a whole it would be kept in memory on the usual path too
    return {far.force,         far.stiffness,       far.contact_radius,
            far.mean_pressure, far.dissipated_work, {far.state.gamma, far.state.gamma_max},
            far.branch,        far.in_range};
  }
  return detail::respond(t, s, old, {{overlap, larger(overlap, old.gamma_max)}, x, x_max, x_top},
                         t.in_cells(x_top));
}

/// A law for two bodies, ready to run. Copies share the table.
struct Law {
  Pair pair;
  Scale scale;
  std::shared_ptr<const Table> table;
  double gamma_elastic = 0; ///< up to here unloading retraces the loading curve [m]
  double force_power = 2;   ///< the force goes with R_e to this power
  std::function<Response(const State&, double)> formulas; ///< what the table was made from, exact and slower
};

PLATEN_HOT Response evaluate(const Law& law, const State& old, double overlap) {
  return evaluate(static_cast<const TableView&>(*law.table), law.scale, old, overlap);
}

/// How unloading from `gamma` goes, as a power law; of a law with a shape of its own, the one that returns
/// its work.
inline Unloading<double> unloading_at(const Law& law, double gamma) {
  const Top top = law.table->top(gamma * law.scale.x_per_gamma);
  return {law.scale.x_per_gamma / top.w, top.alpha};
}

/// Work of loading to `gamma` [J].
inline double loading_work(const Law& law, double gamma) {
  return law.table->top(gamma * law.scale.x_per_gamma).work() * law.scale.work;
}

} // namespace platen::law
