#pragma once
// Two bodies of any two laws, from what each does against its like (docs/explanation/joined.md).
//
// Let x_i(F) be the overlap at which a pair of two bodies i, of radius R_e, carries the force F. The pair of
// both, with A R_e = s (pair.hpp), carries it at
//
//   x^q = (x_1^q + x_2^q)/s,   q = n/(2 (n - 1)),   n = d ln F/d ln x of the softer
//
// which is exact for elastic bodies (n = 3/2, q = 3/2: Hertz, any radii and moduli) and for the similarity
// solution of rigid-plastic ones (n = 1 + 1/2m, q = m + 1/2: kappa_bar = (kappa_1^-m + kappa_2^-m)^(-1/m)),
// up to perfect plasticity (q infinite: the softer side alone). Where both stiffen as their cells fill (n >
// 2) it is q = 1, springs in series. n, and the contact radius at x, are the softer's; of two nearly as soft,
// weighted by x_i^4. Unloading starts with both elasticities in series at that contact radius, 1/S = sum
// (a_i/a)/(s S_i). The exponent n is that of the work, F x/W - 1, which is smoother.
//
// Of a body that is flatter than a harder partner its curve is in range to x_dented (pair.hpp).
//
// It is an assumption near first yield, where the partner's modulus says at which force the softer body
// yields: up to a fifth too high there for bodies of one strength against rigid ones, a few per cent from
// five times that force on.

#include "platen/law/knot_curve.hpp"
#include "platen/law/tabulate.hpp"

namespace platen::law {

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

/// Slope over x with which unloading starts.
inline double stiffness_at(const Top& top) { return top.alpha * top.F / top.w; }

} // namespace detail

/// One body against its like.
struct JoinedSide {
  const Table* table = nullptr; ///< none: rigid
  double x_end = 0.5;           ///< its curve is followed to here
  double x_valid = 0.5;         ///< it holds to here
};

inline KnotCurve join(const Pair& pair, const JoinedSide& one, const JoinedSide& two) {
  const double s = pair.sharing();
  const double curvature1 = pair.body[one.table ? 0 : 1].curvature,
               curvature2 = pair.body[one.table ? 1 : 0].curvature;
  std::vector<Knot> knots;
  double x_valid = infinity, partner = 0;
  const JoinedSide& first = one.table ? one : two;
  const JoinedSide& second = one.table ? two : one;
  const double low = std::min({0x1p-14, first.table->x_first, second.table ? second.table->x_first : 1.0});
  constexpr int per_octave = 24;
  for (double x1 = std::max(low, 0x1p-22) / 4; x1 <= first.x_end; x1 *= std::exp2(1.0 / per_octave)) {
    const Top top1 = first.table->top(x1);
    const double F = top1.F;
    double x2 = 0;
    Top top2;
    if (second.table) {
      partner = x2 = detail::overlap_at(*second.table, F, partner > 0 ? partner : x1);
      top2 = second.table->top(x2);
      if (x2 > second.x_end) break;
    }
    // What the softer says counts; where both are as soft, both count.
    const double soft1 = std::pow(x1, 4), soft2 = std::pow(x2, 4), share = soft2 / (soft1 + soft2);
    const auto exponent = [](const Top& top, double x) {
      return std::max(top.F * x / top.work() - 1, 1 + 1e-6);
    };
    const double n =
        exponent(top1, x1) + (second.table ? share * (exponent(top2, x2) - exponent(top1, x1)) : 0);
    const double q = std::clamp(n / (2 * (n - 1)), 1.0, 1e3);
    const double most = std::max(x1, x2), ratio = std::min(x1, x2) / most;
    const double x = most * std::pow((1 + std::pow(ratio, q)) / s, 1 / q);
    const double a1 = first.table->top(x).a, a2 = second.table ? second.table->top(x).a : a1;
    const double a = a1 + share * (a2 - a1);
    const double c1 = top1.a / (a * detail::stiffness_at(top1)),
                 c2 = second.table ? top2.a / (a * detail::stiffness_at(top2)) : 0;
    const double alpha = (c1 * top1.alpha + c2 * top2.alpha) / (c1 + c2);
    if (!knots.empty() && !(x > knots.back().x * (1 + 1e-9))) continue; // keeps the curve single-valued
    knots.push_back({x, F, a, s / (c1 + c2), alpha});
    const bool first_is_dented = x1 > x2 * (1 + 1e-9) &&
                                 curvature1<curvature2*(1 - 1e-9), second_is_dented = x2> x1 * (1 + 1e-9) &&
                                 curvature2 < curvature1 * (1 - 1e-9);
    if ((x > x_dented && (first_is_dented || second_is_dented)) || x1 > first.x_valid || x2 > second.x_valid)
      x_valid = std::min(x_valid, x);
  }
  if (knots.size() < 4) throw BadParameter("the two laws share no range of forces");
  x_valid = std::min(x_valid, knots.back().x);
  for (const JoinedSide* side : {&first, &second})
    if (side->table && !side->table->in_range(1e-9)) x_valid = 0;
  const bool elastic = first.table->x_elastic > 0 && (!second.table || second.table->x_elastic > 0);
  const double n_first = std::log(knots[1].F / knots[0].F) / std::log(knots[1].x / knots[0].x);
  return {pair, knots, std::abs(n_first - 1.5) < 1e-3 ? 1.5 : n_first, elastic, x_valid};
}

} // namespace platen::law
