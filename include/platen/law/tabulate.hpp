#pragma once
// Any law's formulas as a table (table.hpp): knots at the kinks that the law names, cells of one octave, of
// coarse tables two, between them, halved until force and radius are within `accuracy` of the formulas.
//
// What tabulate() may ask of a law beside ContactLaw; each may be missing.
//   law.kinks()         overlaps [m] where the formulas change
//   law.gamma_end()     overlap [m] from which on the tangent goes on; else 2 R_e
//   Law::force_power    the force goes with R_e to this power; else 2
//   Law::shape, law.n, law.lambda_p   how it unloads (table.hpp)

#include "platen/law/error.hpp"
#include "platen/law/table.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

namespace platen::law {

namespace detail {

template <class L> double force_power(const L&) {
  if constexpr (requires { L::force_power; }) return L::force_power;
  else return 2;
}

template <class L> class Tabulator {
 public:
  Tabulator(const L& law_, const TableAccuracy& accuracy_)
      : law(law_), accuracy(accuracy_), per_gamma(law.pair.x_per_gamma), R_e(law.pair.R_e),
        force(std::pow(R_e, force_power(law))), table(std::make_shared<Table>()) {}

  std::shared_ptr<const Table> make() {
    Table& t = *table;
    if constexpr (requires { L::shape; }) t.shape = L::shape;
    if constexpr (requires {
                    law.n;
                    law.lambda_p;
                  })
      t.n = law.n, t.lambda_p = law.lambda_p;
    t.x_elastic = end_of_retracing(law.gamma_elastic * per_gamma);
    if constexpr (requires { law.gamma_end(); }) x_end = std::min(x_end, law.gamma_end() * per_gamma);
    std::vector<double> kinks{t.x_elastic};
    if constexpr (requires { law.kinks(); })
      for (const double gamma : law.kinks()) kinks.push_back(gamma * per_gamma);
    std::sort(kinks.begin(), kinks.end());
    begin(kinks);
    std::vector<double> ends{t.x_first};
    for (const double x : kinks)
      if (x > ends.back() * (1 + 1e-9) && x < x_end * (1 - 1e-9)) ends.push_back(x);
    if (x_end > ends.back() * (1 + 1e-9)) ends.push_back(x_end);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const int parts = std::max(
          1, static_cast<int>(std::ceil(std::log2(ends[i] / ends[i - 1]) / accuracy.octaves - 1e-9)));
      double left = ends[i - 1];
      for (int k = 1; k <= parts; ++k) {
        const double right =
            k == parts ? ends[i] : ends[i - 1] * std::pow(ends[i] / ends[i - 1], double(k) / parts);
        between(left, right);
        left = right;
      }
    }
    finish(ends.back());
    validity();
    index();
    return table;
  }

 private:
  static constexpr double lowest = 0x1p-26; // cells begin here
  static constexpr double side = 2e-14;     // how far beside a knot a formula is asked, over x
  static constexpr double narrowest = 1e-6;
  /// By so much unloading starts more steeply than the formulas say: where they leave no room, the errors of
  /// the cubics would else carry it above the loading curve, or let the lost work fall.
  static constexpr double stiffer = 2e-5;
  static constexpr int checks = 9;
  struct Sample {
    double F, slope, a, rate_x, alpha;
  };

  Sample at(double x) const {
    const double gamma = x / per_gamma;
    const Loading<double> l = law.loading(gamma);
    const Unloading<double> u = law.unloading(gamma, l);
    return {l.F / force, l.slope / (force * per_gamma), l.a / R_e, u.rate * gamma, u.alpha};
  }
  bool elastic(double x) const { return x <= table->x_elastic * (1 + 1e-12); }

  /// Where unloading still retraces a loading curve that is one power, the law is elastic, to this x.
  double end_of_retracing(double elastic_to) const {
    const double low = std::max(lowest, elastic_to * (1 + 1e-9));
    const Sample start = at(low);
    const double power = start.slope * low / start.F;
    const auto retraces = [&](double x) {
      const Sample s = at(x);
      return bent(s) && std::abs(s.alpha - power) < 1e-9 && std::abs(s.slope * x - power * s.F) < 1e-9 * s.F;
    };
    double from = low, to = low;
    if (!retraces(low)) return elastic_to;
    while (to < x_end && retraces(to)) from = to, to *= 1.1;
    for (int i = 0; i < 60; ++i) {
      const double middle = (from + to) / 2;
      (retraces(middle) ? from : to) = middle;
    }
    return from;
  }

  /// The first cell: from no overlap on where the curve is a cubic there, else from `lowest` on, below which
  /// it goes on as a power of x.
  void begin(const std::vector<double>& kinks) {
    Table& t = *table;
    const double x0 = t.x_elastic > 0 ? std::min(lowest / 16, t.x_elastic / 4) : lowest / 16;
    const Sample s0 = at(x0);
    const double n0 = s0.slope * x0 / s0.F, m0 = std::log2(at(2 * x0).a / s0.a);
    const auto is_power = [&](double x) {
      const Sample s = at(x);
      const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
      const double u = x / x0;
      return near(s.F, s0.F * std::pow(u, n0)) && near(s.slope * x, n0 * s.F) &&
             near(s.a, s0.a * std::pow(u, m0)) &&
             (elastic(x) || (near(s.rate_x, s0.rate_x) && near(s.alpha, s0.alpha))) &&
             elastic(x) == elastic(x0);
    };
    double good = x0, bad = TableView::x_limit;
    for (const double x : kinks)
      if (x > x0) {
        bad = std::min(bad, x);
        break;
      }
    double next = good;
    while (next * 1.3 < bad && is_power(next * 1.3)) next *= 1.3;
    good = next;
    if (is_power(bad * (1 - 1e-12))) good = bad;
    else {
      bad = std::min(bad, good * 1.3);
      for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(good * bad);
        (is_power(middle) ? good : bad) = middle;
      }
    }
    // Hertz, and straight lines, are cubics of v: their first cell begins at no overlap.
    if (const double n = rounded(n0); elastic(good) && rounded(m0) == 0.5 && (n == 1.5 || n == 1)) {
      Cell c;
      c.end = good;
      const Sample s = at(good * (1 - side));
      (n == 1.5 ? c.F.c3 : c.F.c2) = s.F / std::pow(good, n);
      c.a.c1 = s.a / std::sqrt(good);
      c.w = {0, 0, 1, 0};
      c.alpha = n;
      work = work_in(c, std::sqrt(good));
      t.cell_list.push_back(c);
      t.x_first = good;
      from_nothing = true;
      return;
    }
    t.x_first = lowest;
    const double x = t.x_first * (1 - side);
    const Sample s = at(x);
    const bool one_power = good >= lowest;
    t.n_first = one_power ? rounded(n0) : s.slope * x / s.F;
    t.m_first = one_power ? rounded(m0) : std::log2(s.a / at(x / 2).a);
    work = s.F * x / (t.n_first + 1);
    t.first = {s.F, s.slope, s.a, x, t.n_first, 0};
    if (!elastic(x)) {
      t.first.w = bent(s) ? x : x / s.rate_x * (1 - stiffer);
      t.first.alpha = bent(s) ? s.alpha * s.rate_x * (1 + stiffer) : s.alpha;
      t.first.lost = std::max(0.0, work - t.first.back());
      lost = work - t.first.back();
    }
  }

  static double rounded(double exponent) {
    for (const double known : {0.5, 1.0, 1.5})
      if (std::abs(exponent - known) < 1e-9) return known;
    return exponent;
  }
  /// Whether unloading ends at the origin.
  [[nodiscard]] bool bent(const Sample& s) const { return std::abs(s.rate_x - 1) < accuracy.bent; }

  /// Cells from `left` to `right`: one, or halves where one does not follow the formulas. Where unloading
  /// begins or ceases to end at the origin the formulas have a kink that no law can name: there the two
  /// halves meet.
  void between(double left, double right) {
    Cell cell;
    if (!make_cell(left, right, cell) && right > left * (1 + narrowest)) {
      double middle = std::sqrt(left * right);
      if (const bool first = bent(at(left * (1 + side)));
          !elastic(right) && first != bent(at(right * (1 - side)))) {
        double low = left, high = right;
        for (int i = 0; i < 60; ++i) {
          const double x = std::sqrt(low * high);
          (bent(at(x)) == first ? low : high) = x;
        }
        if (low > left * (1 + narrowest) && low < right * (1 - narrowest)) middle = low;
      }
      between(left, middle);
      between(middle, right);
      return;
    }
    const double h = std::sqrt(right) - cell.left;
    work += work_in(cell, h);
    if (!elastic(right))
      lost = work - cell.F.value(h) * cell.w.value(h) / (1 + cell.alpha + h * cell.alpha_slope);
    table->cell_list.push_back(cell);
    if (table->cell_list.size() > 4000) throw BadParameter("law: its curve changes too often for a table");
  }

  /// Never falls where its ends do not, and passes through them.
  static Cubic rising(double h, const Cubic& c) {
    const double end = c.value(h), rise = (end - c.c0) / h, d0 = c.c1, d1 = c.slope(h);
    const double turn = c.c3 != 0 ? -c.c2 / (3 * c.c3) : -1;
    if (d0 >= 0 && d1 >= 0 && !(turn > 0 && turn < h && c.slope(turn) < 0)) return c;
    const auto inside = [&](double d) { return std::clamp(d, 0.0, 3 * std::max(rise, 0.0)); };
    return Cubic::hermite(h, c.c0, inside(d0), end, inside(d1));
  }

  /// Work of a cell up to t: int F 2 v dv.
  static double work_in(const Cell& c, double t) {
    const double twice = 2 * c.left;
    const Cubic& F = c.F;
    return t * (twice * F.c0 + t * ((twice * F.c1 + 2 * F.c0) / 2 +
                                    t * ((twice * F.c2 + 2 * F.c1) / 3 +
                                         t * ((twice * F.c3 + 2 * F.c2) / 4 + t * F.c3 * 2 / 5))));
  }

  /// How unloading goes in a cell, at four points: as the formulas say, but giving back no more than lets the
  /// lost work grow where theirs does.
  void unload(double h, const Sample* s, bool to_origin, Cell& c) const {
    double w[4], alpha[4], least = lost, formula_before = 0;
    for (int i = 0; i < 4; ++i) {
      const Sample& v = s[i * checks / 3];
      const double t = h * i / 3, x = (c.left + t) * (c.left + t);
      const double F = c.F.value(t), W = work + work_in(c, t),
                   formula = W - v.F * x / (v.rate_x * (1 + v.alpha));
      w[i] = to_origin ? x : x / v.rate_x * (1 - stiffer);
      alpha[i] = to_origin ? v.alpha * v.rate_x * (1 + stiffer)
                           : s[0].alpha + i / 3.0 * (s[checks].alpha - s[0].alpha);
      const double wanted = F * w[i] / (1 + alpha[i]);
      double back = wanted;
      if (i > 0) least += std::min(formula - formula_before, 0.0);
      if (table->shape == Shape::power && back > W - least) {
        back = std::max(W - least, wanted * (1 - accuracy.rate / 2));
        (to_origin ? alpha : w)[i] = to_origin ? F * x / back - 1 : back * (1 + alpha[i]) / F;
      }
      least = W - back, formula_before = formula;
    }
    c.w = to_origin ? Cubic{c.left * c.left, 2 * c.left, 1, 0} : Cubic::through(h, w[0], w[1], w[2], w[3]);
    c.alpha = alpha[0];
    c.alpha_slope = (alpha[3] - alpha[0]) / h;
  }

  bool make_cell(double left, double right, Cell& c) const {
    c.left = std::sqrt(left);
    c.end = right;
    const double h = std::sqrt(right) - c.left;
    const auto x_at = [&](int k, int of) {
      const double v = c.left + h * k / of;
      return k == 0 ? left * (1 + side) : k == of ? right * (1 - side) : v * v;
    };
    const auto near = [](double value, double reference, double error) {
      return std::abs(value - reference) <= error * std::abs(reference);
    };
    Sample s[checks + 1];
    for (const int k : {0, checks}) s[k] = at(x_at(k, checks));
    c.F = rising(h, Cubic::hermite(h, s[0].F, 2 * c.left * s[0].slope, s[checks].F,
                                   2 * std::sqrt(right) * s[checks].slope));
    static_assert(checks == 9);
    for (const int k : {5, 2, 7, 1, 3, 4, 6, 8}) {
      s[k] = at(x_at(k, checks));
      if (right > left * (1 + narrowest) && !near(c.F.value(h * k / checks), s[k].F, accuracy.force))
        return false; // soonest: half of all cells end here
    }
    c.a = Cubic::through(h, s[0].a, s[checks / 3].a, s[2 * checks / 3].a, s[checks].a);
    const bool is_elastic = elastic(right);
    const auto ends_at_origin = std::count_if(s, s + checks + 1, [&](const Sample& v) { return bent(v); });
    if (is_elastic) {
      c.w = {c.left * c.left, 2 * c.left, 1, 0};
      c.alpha = s[0].slope * left / s[0].F;
    } else unload(h, s, ends_at_origin > checks, c);
    bool follows = is_elastic || ends_at_origin == 0 || ends_at_origin == checks + 1;
    double losses[checks + 1] = {}, lost_formula = 0, work_here = work;
    for (int k = 0; k <= checks; ++k) {
      const double x = x_at(k, checks), t = h * k / checks, F = c.F.value(t);
      follows = follows && near(F, s[k].F, accuracy.force) && near(c.a.value(t), s[k].a, accuracy.radius) &&
                near(c.F.slope(t) / (2 * std::sqrt(x)), s[k].slope, accuracy.slope);
      if (is_elastic) continue;
      const double alpha = c.alpha + t * c.alpha_slope, w = c.w.value(t);
      follows = follows && near(x / w, s[k].rate_x, accuracy.rate) &&
                near(alpha, s[k].alpha, accuracy.rate) &&
                (w <= x * (1 + 1e-9) || s[k].rate_x < 1); // nor past the origin
      // Unloading starts below the loading curve, and the lost work grows, where they do in the formulas.
      const double steepness = s[k].alpha * s[k].rate_x * s[k].F / (s[k].slope * x);
      const double here = alpha * F / (w * c.F.slope(t)) * 2 * std::sqrt(x);
      follows = follows && (table->shape != Shape::power || here >= std::min(1.0, steepness));
      if (table->shape == Shape::power &&
          steepness < 1.02) // hardly below it: no room for errors of the force
        follows = follows && near(F, s[k].F, accuracy.force / 20) &&
                  near(c.F.slope(t) / (2 * std::sqrt(x)), s[k].slope, accuracy.slope / 20);
      const double work_before = work_here, lost_before = lost_formula;
      work_here = work + work_in(c, t);
      losses[k] = work_here - F * w / (1 + alpha);
      lost_formula = work_here - s[k].F * x / (s[k].rate_x * (1 + s[k].alpha));
      const double hardly = 1e-5 * (work_here - work_before);
      follows =
          follows && (k == 0 || losses[k] >= losses[k - 1] - hardly || lost_formula - lost_before < hardly);
    }
    if (is_elastic) return follows;
    c.lost = Cubic::through(h, losses[0], losses[checks / 3], losses[2 * checks / 3], losses[checks]);
    if (losses[checks] >= losses[0]) c.lost = rising(h, c.lost);
    for (int k = 0; k <= checks; ++k)
      follows = follows && std::abs(c.lost.value(h * k / checks) - losses[k]) <= accuracy.lost * work_here;
    return follows;
  }

  /// The tangent beyond the last knot: radius, exponent and recovered overlap are held.
  void finish(double x) {
    Cell c;
    const Sample s = at(x * (1 - side));
    c.left = std::sqrt(x);
    c.end = infinity;
    // t^2 + 2 left t = v^2 - left^2
    c.F = {s.F, 2 * c.left * s.slope, s.slope, 0};
    c.a = {s.a, 0, 0, 0};
    c.alpha = s.alpha;
    if (elastic(x)) { // rate_x may be none
      c.w = {x, 2 * c.left, 1, 0};
      c.alpha = s.slope * x / s.F;
    } else {
      double back = s.F * x / (s.rate_x * (1 + s.alpha));
      if (table->shape == Shape::power) back = std::min(back, work - lost);
      c.w = {back * (1 + s.alpha) / s.F, 0, 0, 0};
      // D = W - F w/(1 + alpha), without its fourth power of t, far outside any validity
      const double d1 = s.F - s.slope * c.w.c0 / (1 + s.alpha);
      c.lost = {work - back, 2 * c.left * d1, d1 + 2 * c.left * c.left * s.slope, 2 * c.left * s.slope};
    }
    table->cell_list.push_back(c);
  }

  /// The overlaps for which the law says it was made, found by sampling and bisection.
  void validity() {
    int found = 0;
    const auto valid = [&](double x) { return law.in_range(x / per_gamma); };
    const auto edge = [&](double a, double b) { // valid(a) != valid(b)
      const bool of_a = valid(a);
      for (int i = 0; i < 100; ++i) {
        const double middle = std::sqrt(a * b);
        (valid(middle) == of_a ? a : b) = middle;
      }
      return of_a ? a : b;
    };
    for (auto& v : table->valid) v[0] = 1, v[1] = 0; // empty
    double x = 0x1p-40, start = 0;
    bool inside = valid(x);
    if (!inside) start = -1;
    const auto close = [&](double end) {
      if (found < 2) table->valid[found][0] = start, table->valid[found][1] = end, ++found;
    };
    for (double next = x * 1.01; next < 2 * TableView::x_limit; x = next, next *= 1.01) {
      if (valid(next) == inside) continue;
      const double at_edge = edge(x, next);
      if (inside) close(at_edge * (1 + 1e-12));
      else start = at_edge * (1 - 1e-12);
      inside = !inside;
    }
    if (inside) close(infinity);
  }

  void index() {
    Table& t = *table;
    t.bits = accuracy.bits;
    const auto bits_of = [&](double v) { return std::bit_cast<std::int64_t>(v) >> (52 - t.bits); };
    if (from_nothing) t.x_first = 0x1p-300; // below it no contact
    const auto begins = [](const Cell& c) { return c.left * c.left; };
    t.base = from_nothing ? bits_of(t.cell_list.front().end) - 1 : bits_of(begins(t.cell_list.front()));
    t.slots = static_cast<int>(bits_of(begins(t.cell_list.back())) - t.base) + 1;
    std::uint16_t cell = 0;
    for (int k = 0; k < t.slots; ++k) {
      const double left = std::bit_cast<double>((t.base + k) << (52 - t.bits));
      while (t.cell_list[cell].end <= left) ++cell;
      t.slot_list.push_back(cell);
    }
    t.all_three_halves = t.shape == Shape::power;
    for (const Cell& c : t.cell_list) {
      const bool is_elastic = c.end <= t.x_elastic * (1 + 1e-9) || elastic(begins(c) * (1 + 1e-9));
      t.all_three_halves &= is_elastic || (c.alpha == 1.5 && c.alpha_slope == 0);
    }
    t.all_three_halves &= elastic(t.x_first) || t.first.alpha == 1.5;
    t.cell_list.shrink_to_fit();
    t.cells = t.cell_list.data();
    t.slot = t.slot_list.data();
  }

  const L& law;
  const TableAccuracy accuracy;
  const double per_gamma, R_e, force;
  double x_end = 1, work = 0, lost = -infinity; ///< of the cells so far
  bool from_nothing = false;
  std::shared_ptr<Table> table;
};

} // namespace detail

/// The size of two bodies of a law whose force goes with R_e to the given power.
inline Scale scale_of(const Pair& pair, double force_power = 2) {
  const double force = std::pow(pair.R_e, force_power);
  return {pair.R_e, pair.x_per_gamma, force, force / pair.x_per_gamma, force / (pair.R_e * pair.R_e)};
}

/// A law ready to run, from its formulas for the same two bodies. Throws BadParameter.
template <ContactLaw L> Law tabulate(const L& law, const TableAccuracy& accuracy = {}) {
  auto table = detail::Tabulator<L>(law, accuracy).make();
  const double elastic = table->x_elastic / law.pair.x_per_gamma;
  return {law.pair,
          scale_of(law.pair, detail::force_power(law)),
          std::move(table),
          elastic,
          detail::force_power(law),
          [law](const State& old, double overlap) { return evaluate(law, old, overlap); }};
}

} // namespace platen::law
