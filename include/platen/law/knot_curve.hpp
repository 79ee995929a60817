#pragma once
// A law whose curve is known at knots, not by a formula: force, contact radius and unloading over x,
// interpolated in the logarithms, C1 and monotone (Fritsch & Carlson 1980, three-point slopes).
//
//   below the first knot   F = F_1 (x/x_1)^n, a = a_1 (x/x_1)^(1/2)
//   beyond the last        the tangent; the radius is held

#include "platen/law/contact.hpp"
#include "platen/law/error.hpp"
#include "platen/law/pair.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace platen::law {

/// y over x, both growing or y constant in places; C1, monotone between any two knots.
class MonotoneCurve {
 public:
  MonotoneCurve() = default;
  /// `first_slope`: at the first knot, where it is known.
  MonotoneCurve(std::vector<double> x, std::vector<double> y, double first_slope = required_by_data)
      : x_(std::move(x)), y_(std::move(y)), slope_(x_.size()) {
    const std::size_t n = x_.size();
    const auto rise = [&](std::size_t i) { return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]); };
    for (std::size_t i = 0; i < n; ++i) {
      if (i == 0 || i + 1 == n) {
        slope_[i] = n == 1 ? 0 : rise(i == 0 ? 0 : n - 2);
        if (n > 2) { // the parabola through three knots
          const std::size_t k = i == 0 ? 0 : n - 3;
          const double h0 = x_[k + 1] - x_[k], h1 = x_[k + 2] - x_[k + 1],
                       bend = (rise(k + 1) - rise(k)) / (h0 + h1);
          slope_[i] = i == 0 ? rise(0) - bend * h0 : rise(n - 2) + bend * h1;
        }
        continue;
      }
      const double h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
      slope_[i] = (rise(i - 1) * h1 + rise(i) * h0) / (h0 + h1);
    }
    if (std::isfinite(first_slope)) slope_[0] = first_slope;
    for (std::size_t i = 0; i + 1 < n;
         ++i) // Fritsch & Carlson: end slopes within three times the secant are monotone
      for (double* s : {&slope_[i], &slope_[i + 1]}) {
        const double r = rise(i);
        *s = r >= 0 ? std::clamp(*s, 0.0, 3 * r) : std::clamp(*s, 3 * r, 0.0);
      }
  }
  /// Value and slope; the first or last value outside.
  void at(double x, double& y, double& slope) const {
    if (x <= x_.front()) return void((y = y_.front(), slope = x == x_.front() ? slope_.front() : 0));
    if (x >= x_.back()) return void((y = y_.back(), slope = x == x_.back() ? slope_.back() : 0));
    between(interval(x), x, y, slope);
  }
  /// Of an x between the first and the last knot: the knot below it.
  [[nodiscard]] std::size_t interval(double x) const {
    std::size_t i = 0;
    for (std::size_t n = x_.size() - 1; n > 1;) { // without branches: asked for in no order
      const std::size_t half = n / 2;
      i += x_[i + half] <= x ? half : 0;
      n -= half;
    }
    return i;
  }
  /// Value and slope by the cubic of an interval.
  void between(std::size_t i, double x, double& y, double& slope) const {
    const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, rise = y_[i + 1] - y_[i];
    const double c2 = 3 * rise - h * (2 * slope_[i] + slope_[i + 1]),
                 c3 = h * (slope_[i] + slope_[i + 1]) - 2 * rise;
    y = y_[i] + t * (h * slope_[i] + t * (c2 + t * c3));
    slope = slope_[i] + t * (2 * c2 + 3 * t * c3) / h;
  }
  [[nodiscard]] double value(double x) const {
    double y = 0, slope = 0;
    at(x, y, slope);
    return y;
  }
  [[nodiscard]] const std::vector<double>& knots() const { return x_; }
  [[nodiscard]] double end_slope() const { return slope_.back(); }

 private:
  static constexpr double required_by_data = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x_, y_, slope_;
};

/// One knot, in units of R_e.
struct Knot {
  double x = 0;       ///< overlap of the pair (pair.hpp)
  double F = 0;       ///< force over R_e^2 [Pa]
  double a = 0;       ///< contact radius over R_e
  double S = 0;       ///< slope over x with which unloading starts [Pa]
  double alpha = 1.5; ///< exponent of unloading
};

/// Overlaps x for which a curve holds.
struct InRange {
  double from = 0, to = 0;
};

/// The ContactLaw of such knots.
class KnotCurve {
 public:
  using Scalar = double;
  Pair pair;
  double gamma_elastic = 0, gamma_limit = 0;
  InRange valid;

  /// `n_first`: exponent of the force below the first knot; `elastic`: unloading retraces it there.
  KnotCurve(const Pair& pair_, const std::vector<Knot>& knots, double n_first_, bool elastic, InRange valid_)
      : pair(pair_), gamma_limit(1000 / pair.x_per_gamma), valid(valid_), n_first(n_first_) {
    std::vector<double> x, F, a, S, alphas;
    for (const Knot& k : knots) {
      x.push_back(std::log(k.x));
      F.push_back(std::log(k.F));
      a.push_back(std::log(k.a));
      S.push_back(std::log(k.S));
      alphas.push_back(k.alpha);
    }
    x_first = knots.front().x;
    x_last = knots.back().x;
    if (elastic) gamma_elastic = x_first / pair.x_per_gamma;
    force = MonotoneCurve(x, F, n_first);
    radius = MonotoneCurve(x, a);
    stiffness = MonotoneCurve(x, S);
    exponent = MonotoneCurve(x, alphas);
    double y = 0, slope = 0;
    force.at(x.back(), y, slope);
    end_slope = slope * knots.back().F / x_last;
    work_to_knot = {knots.front().F * x_first / (n_first + 1)};
    for (std::size_t i = 1; i < knots.size(); ++i)
      work_to_knot.push_back(work_to_knot.back() + work_between(knots[i - 1].x, knots[i].x));
    limit_unloading();
  }

  [[nodiscard]] Loading<double> loading(double gamma) const {
    const double x = gamma * pair.x_per_gamma, F_scale = pair.R_e * pair.R_e;
    Loading<double> l;
    double y = 0, slope = 0;
    if (x < x_first) {
      l.F = std::exp(force.value(std::log(x_first))) * std::pow(x / x_first, n_first);
      l.slope = n_first * l.F / x;
      l.a = std::exp(radius.value(std::log(x_first))) * std::sqrt(x / x_first);
    } else if (x > x_last) {
      l.slope = end_slope;
      l.F = std::exp(force.value(std::log(x_last))) + end_slope * (x - x_last);
      l.a = std::exp(radius.value(std::log(x_last)));
    } else {
      const double u = std::log(x);
      const std::size_t i = force.interval(u);
      force.between(i, u, y, slope);
      l.F = std::exp(y);
      l.slope = l.F * slope / x;
      radius.between(i, u, y, slope);
      l.a = std::exp(y);
    }
    l.F *= F_scale;
    l.slope *= F_scale * pair.x_per_gamma;
    l.a *= pair.R_e;
    return l;
  }
  [[nodiscard]] Unloading<double> unloading(double gamma, const Loading<double>&) const {
    const double x = gamma * pair.x_per_gamma;
    if (gamma <= gamma_elastic) return {0, 1.5}; // never followed: elastic
    const double u = std::log(std::clamp(x, x_first, x_last));
    const double w = std::min(x, x_last) * std::exp(recovered.value(u)); // beyond the last knot held
    return {pair.x_per_gamma / w, exponent.value(u)};
  }
  [[nodiscard]] bool in_range(double gamma) const {
    const double x = gamma * pair.x_per_gamma;
    return valid.from * (1 - 1e-9) <= x && x <= valid.to * (1 + 1e-9);
  }
  [[nodiscard]] double work(double gamma) const {
    const double x = gamma * pair.x_per_gamma, scale = pair.R_e * pair.R_e / pair.x_per_gamma;
    if (x <= x_first) return loading(gamma).F * gamma / (n_first + 1);
    const auto& knots = force.knots();
    std::size_t i = 0;
    while (i + 1 < knots.size() && std::exp(knots[i + 1]) < x) ++i;
    return scale * (work_to_knot[i] + work_between(std::exp(knots[i]), x));
  }
  [[nodiscard]] std::vector<double> kinks() const {
    return {x_first / pair.x_per_gamma, x_last / pair.x_per_gamma};
  }
  [[nodiscard]] double gamma_end() const { return x_last / pair.x_per_gamma; }

 private:
  /// How far unloading goes back, on a finer grid than the knots: as the slopes S say, but less where it
  /// would rise above the loading curve, go past the origin, or give back more than was put in since the last
  /// point. A curve's small waves have exponents of their own, so that general bounds (unloading_from_slope)
  /// would stiffen it everywhere.
  void limit_unloading() {
    std::vector<double> u,
        ln_share; // w/x: between two points it goes past neither, and so not past the origin
    const auto& x = force.knots();
    const int parts = std::clamp(static_cast<int>(1200 / x.size()), 4, 30);
    constexpr double room = 1e-3; // for what lies between the points
    double lost = 0, work = work_to_knot.front();
    if (gamma_elastic == 0) lost = -infinity;
    double F_last = 0;
    std::vector<double> xs, ln_Fs;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      for (int k = 0; k < parts + (i + 2 == x.size()); ++k) {
        const double at = x[i] + (x[i + 1] - x[i]) * k / parts, here = std::exp(at);
        double y = 0, slope = 0;
        force.at(at, y, slope);
        const double F = std::exp(y), alpha = exponent.value(at), per_alpha = 1 / alpha;
        const double put_in = xs.empty() ? 0 : put_in_between(xs.back(), F_last, here, F);
        work += put_in;
        double w = std::min(here, alpha * F / std::exp(stiffness.value(at)));
        if (slope > 0) w = std::min(w, alpha * here / slope); // starts as steeply as the loading curve ends
        for (std::size_t back = 1; back <= xs.size(); back += 1 + back / 16) { // densest near by
          const std::size_t j = xs.size() - back;
          const double way = (here - xs[j]) * (1 - room), t = (y - ln_Fs[j]) * per_alpha;
          if (way >= w) break;                                  // nor do those farther away bound it
          if (way >= w * t * (1 - t * (0.5 - t / 6))) continue; // more than 1 - e^-t
          w = std::min(w, way / (1 - std::exp(-t)));
        }
        w = std::min(w, (work - lost - room * put_in) * (1 + alpha) / F);
        lost = work - F * w / (1 + alpha);
        F_last = F;
        xs.push_back(here), ln_Fs.push_back(y), u.push_back(at), ln_share.push_back(std::log(w / here));
      }
    recovered = MonotoneCurve(u, ln_share);
  }

  /// Between two points of the fine grid, where Simpson's rule needs no parts.
  [[nodiscard]] double put_in_between(double from, double F_from, double to, double F_to) const {
    const double middle = (from + to) / 2;
    return (to - from) / 6 * (F_from + 4 * std::exp(force.value(std::log(middle))) + F_to);
  }

  /// Simpson's rule, over R_e^2 and in x; between two knots, or beyond the last.
  [[nodiscard]] double work_between(double from, double to) const {
    if (from >= x_last)
      return (to - from) * (std::exp(force.value(std::log(x_last))) + end_slope * ((from + to) / 2 - x_last));
    constexpr int parts = 8;
    const double h = (to - from) / parts;
    const std::size_t i = force.interval(std::log(from + h / 2));
    const auto F = [&](double x) {
      double y = 0, slope = 0;
      force.between(i, std::log(x), y, slope);
      return std::exp(y);
    };
    double sum = 0, left = F(from);
    for (int k = 0; k < parts; ++k) {
      const double right = F(from + (k + 1) * h);
      sum += h / 6 * (left + 4 * F(from + (k + 0.5) * h) + right);
      left = right;
    }
    return sum;
  }

  std::vector<double> work_to_knot;
  double n_first, x_first = 0, x_last = 0, end_slope = 0;
  MonotoneCurve force, radius, stiffness, exponent, recovered;
};

} // namespace platen::law
