#pragma once
// Two bodies of any two laws, from what each does against its like (docs/explanation/joined.md).
//
// At a force F body i, pressed against its like of radius R_i, is at the overlap x_i (delta/R) with the
// contact radius a_i. R_i is its own; of the larger of two it is 2/A (A of their own radii, pair.hpp), whose
// equal pair has the same gap and yields first at the same force: a plane yields, too. Of R_i^2 x_i and of
// a_i^2 Hertz's share is H_i = (3 F R_i (1 - nu_i^2)/(4 E_i))^(2/3); the rest is plastic:
//
//   (R_i^2 x_i)^(7/4) = H_i^(7/4) + P_i^(7/4),   a_i^3 = H_i^(3/2) + Q_i^(3/2)
//
// The pair carries F at the sums of all three:
//
//   (gamma/A)^(7/4) = H^(7/4) + P^(7/4),   a^3 = H^(3/2) + Q^(3/2)
//   H = sum_3/2 H_i,  P = sum_q P_i,  Q = sum_q Q_i,   sum_q u_i = ((u_1^q/R_1 + u_2^q/R_2)/A)^(1/q)
//   q = n/(2 (n - 1)) >= 1,   n = d ln F/d ln x of the plastic overlap of the softer
//
// which is exact for elastic bodies (n = 3/2 is q = 3/2: Hertz, any radii and moduli) and for the similarity
// solution of rigid-plastic ones (n = 1 + 1/2m, q = m + 1/2: kappa_bar = (kappa_1^-m + kappa_2^-m)^(-1/m),
// any radii), up to perfect plasticity (q infinite: the softer side alone). Where both stiffen as their cells
// fill (n > 2) it is q = 1, springs in series. Against a rigid plane, and of two alike, it is the curve
// itself. The power 7/4 is the one with which P of a metal depends least on its modulus (joined.md). Of two
// nearly as soft n is weighted by P_i^4; it is that of the work, F x/W - 1, which is smoother, and at most
// that of the whole overlap. Unloading starts with both elasticities in series at that contact radius.
//
// Of bodies of unlike strength it is in range as far as a flattened sphere's curve is (flattened_to,
// pair.hpp).

#include "platen/law/knot_curve.hpp"
#include "platen/law/tabulate.hpp"

namespace platen::law {

/// One body against its like.
struct JoinedSide {
  const Table* table = nullptr; ///< none: rigid
  double x_end = 0.5;           ///< its curve is followed to here
};

namespace detail {

/// Where a table carries F (over R_e^2): its x.
inline double overlap_at(const TableView& t, double F, double guess) {
  double x = guess;
  for (int i = 0; i < 60; ++i) {
    const Top top = t.top(x);
    const double step = std::clamp(std::log(F / top.F) * top.F / (top.slope * x), -2.0, 2.0);
    x *= std::exp(step);
    if (std::abs(step) < 1e-13) break;
  }
  return x;
}

/// A body and the radius L of its pair with its like [m].
struct OwnPair {
  JoinedSide side;
  double E_flat = 0, L = 0;

  OwnPair(const JoinedSide& side_, const Body& body, double A)
      : side(side_), E_flat(1 / (body.compliance * (1 - body.nu * body.nu))),
        L(std::min(1 / body.curvature, 2 / A)) {}

  [[nodiscard]] bool in_range(double x) const { return !side.table || side.table->in_range(x); }
  /// At a force over the square of its radius; a rigid body gives way nowhere.
  [[nodiscard]] double overlap(double F_over_square, double guess) const {
    return side.table ? overlap_at(*side.table, F_over_square, guess) : 0;
  }
  /// To where its curve is Hertz's, of one that begins so.
  [[nodiscard]] double x_hertz() const {
    const Cell& first = side.table->cell_list.front();
    const bool begins = side.table->x_elastic > 0 && first.left == 0 && first.alpha == 1.5;
    return begins ? std::min({side.table->x_elastic, side.table->valid[0][1] / 2, side.x_end / 2}) : 0;
  }
};

/// With these powers an elastic and a plastic part make a whole.
inline constexpr double of_overlap = 7.0 / 4, of_area = 3.0 / 2;
inline double whole_of(double elastic, double plastic, double power) {
  return std::pow(std::pow(elastic, power) + std::pow(plastic, power), 1 / power);
}
inline double plastic_of(double whole, double elastic, double power) {
  return std::pow(std::max(std::pow(whole, power) - std::pow(elastic, power), 0.0), 1 / power);
}

/// It at one overlap; a rigid body has none.
struct OwnContact {
  double x = 0;
  double elastic = 0, plastic = 0;           ///< of L^2 x: H and P [m^2]
  double area_elastic = 0, area_plastic = 0; ///< of a^2: H and Q [m^2]
  double n = 1;                              ///< d ln F/d ln x of the plastic overlap
  double compliance =
      0;              ///< with which unloading starts, times the contact radius, of this body alone [m^2/N]
  double alpha = 1.5; ///< of its unloading

  OwnContact() = default;
  OwnContact(const OwnPair& own, double x_, const Top& top) : x(x_), alpha(top.alpha) {
    const double square = own.L * own.L, x_hertz = std::pow(0.75 * top.F / own.E_flat, 2.0 / 3);
    elastic = square * std::min(x, x_hertz), area_elastic = square * std::min(top.a * top.a, x_hertz);
    plastic = plastic_of(square * x, elastic, of_overlap);
    area_plastic = plastic_of(square * top.a * top.a, area_elastic, of_area);
    // Where the whole stiffens beyond its elasticity, no plastic work is left to say n.
    const double work = top.work() - 0.4 * top.F * x_hertz;
    const double whole = std::max(top.F * x / top.work() - 1, 1.0);
    n = work > 0 ? std::clamp(top.F * (x - x_hertz) / work - 1, 1.0, whole) : whole;
    compliance = top.a * top.w / (top.alpha * top.F);
  }
};

/// sum_q u_i of two bodies, k_i = 1/(R_i A).
inline double joined_sum(double u1, double k1, double u2, double k2, double q) {
  const double most = std::max(u1, u2);
  if (most == 0) return 0;
  return most * std::pow(k1 * std::pow(u1 / most, q) + k2 * std::pow(u2 / most, q), 1 / q);
}

/// Of a dense walk every eighth knot, and those that the curve through the others misses.
inline std::vector<Knot> needed(const std::vector<Knot>& walked) {
  constexpr double of_force = 2e-3, of_radius = 1e-2, of_stiffness = 0.2;
  constexpr std::size_t fewest = 8; // a power of two
  const std::size_t n = walked.size();
  std::vector<char> kept(n, false);
  for (std::size_t i = 0; i < n; i += fewest) kept[i] = true;
  kept[n - 1] = true;
  for (std::size_t stride = fewest; stride > 1; stride /= 2) {
    std::vector<double> x, F, a, S;
    for (std::size_t i = 0; i < n; ++i)
      if (kept[i]) {
        const Knot& k = walked[i];
        x.push_back(std::log(k.x)), F.push_back(std::log(k.F));
        a.push_back(std::log(k.a)), S.push_back(std::log(k.S));
      }
    const MonotoneCurve force(x, F), radius(x, a), stiffness(x, S);
    for (std::size_t i = stride / 2; i < n; i += stride) {
      const Knot& k = walked[i];
      const auto off = [u = std::log(k.x)](const MonotoneCurve& curve, double value) {
        return std::abs(curve.value(u) - std::log(value));
      };
      kept[i] = kept[i] || off(force, k.F) > of_force || off(radius, k.a) > of_radius ||
                off(stiffness, k.S) > of_stiffness;
    }
  }
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < n; ++i)
    if (kept[i]) knots.push_back(walked[i]);
  return knots;
}

} // namespace detail

inline KnotCurve join(const Pair& pair, const JoinedSide& side1, const JoinedSide& side2) {
  const int i = side1.table ? 0 : 1; // the first one is not rigid
  const detail::OwnPair one(i == 0 ? side1 : side2, pair.body[i], pair.A),
      two(i == 0 ? side2 : side1, pair.body[1 - i], pair.A);
  const Table &table1 = *one.side.table, *table2 = two.side.table;
  const double square = pair.R_e * pair.R_e, k1 = 1 / (one.L * pair.A), k2 = 1 / (two.L * pair.A);

  std::vector<Knot> knots;
  InRange valid{infinity, infinity};
  double partner = 0;
  // Their radii differ by a factor of 2 at most, x of elastic ones by 2.5.
  double x_begin =
      std::max(std::min({0x1p-14, table1.x_first, table2 ? table2->x_first : 1.0}), 0x1p-22) / 10;
  const bool hertz = one.x_hertz() > 0 && (!table2 || two.x_hertz() > 0);
  if (hertz) { // to where the first one yields
    x_begin = one.x_hertz();
    if (table2) {
      const double F = table2->top(two.x_hertz()).F * two.L * two.L;
      x_begin = std::min(x_begin, one.overlap(F / (one.L * one.L), x_begin));
    }
  }
  constexpr int per_octave = 56;
  for (double x1 = x_begin; x1 <= one.side.x_end; x1 *= std::exp2(1.0 / per_octave)) {
    const Top top1 = table1.top(x1);
    const double F = top1.F * one.L * one.L;
    const detail::OwnContact a(one, x1, top1);
    detail::OwnContact b;
    if (table2) {
      const double F2 = F / (two.L * two.L);
      partner = detail::overlap_at(*table2, F2, partner > 0 ? partner : x1);
      if (partner > two.side.x_end) break;
      b = {two, partner, table2->top(partner)};
    }
    // What the softer says counts; where both are as soft, both count.
    const double soft1 = std::pow(a.plastic, 4), soft2 = std::pow(b.plastic, 4);
    const double n = soft1 + soft2 > 0 ? (soft1 * a.n + soft2 * b.n) / (soft1 + soft2) : 1;
    const double q = n > 1 ? std::clamp(n / (2 * (n - 1)), 1.0, 1e3) : 1e3;
    const auto sum = [&](double u1, double u2) { return detail::joined_sum(u1, k1, u2, k2, q); };
    const auto elastic = [&](double u1, double u2) { return detail::joined_sum(u1, k1, u2, k2, 1.5); };
    const double x =
        detail::whole_of(elastic(a.elastic, b.elastic), sum(a.plastic, b.plastic), detail::of_overlap) /
        square;
    if (!knots.empty() && !(x > knots.back().x * (1 + 1e-9))) continue; // keeps the curve single-valued
    const double area = detail::whole_of(elastic(a.area_elastic, b.area_elastic),
                                         sum(a.area_plastic, b.area_plastic), detail::of_area);
    const double compliance = a.compliance + b.compliance,
                 alpha = (a.compliance * a.alpha + b.compliance * b.alpha) / compliance;
    knots.push_back({x, F / square, std::sqrt(area / square), pair.A * std::sqrt(area) / compliance, alpha});
    const auto strength = [&](int side) { return 1 / (side == i ? one : two).overlap(F / square, x); };
    const bool in_range = one.in_range(a.x) && two.in_range(b.x);
    if (in_range && !(valid.from < infinity)) valid.from = knots.size() == 1 ? 0 : x;
    if (!in_range && valid.from < infinity) valid.to = std::min(valid.to, x);
    if (x > x_dented) valid.to = flattened_to(valid.to, pair, strength(0), strength(1));
  }
  if (knots.size() < 4) throw BadParameter("the two laws share no range of forces");
  valid.to = std::min(valid.to, knots.back().x);
  const bool elastic = table1.x_elastic > 0 && (!table2 || table2->x_elastic > 0);
  const double n_first = std::log(knots[1].F / knots[0].F) / std::log(knots[1].x / knots[0].x);
  return {pair, detail::needed(knots), hertz || std::abs(n_first - 1.5) < 1e-3 ? 1.5 : n_first, elastic,
          valid};
}

} // namespace platen::law
