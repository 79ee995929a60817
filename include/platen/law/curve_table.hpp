#pragma once
// A costly loading curve F(x) turned into cubics that take a few nanoseconds: value and slope exact at the
// nodes, relative error below 1e-4 between them (tested). Made once by `prepare`; lives inside the law,
// without pointers.
//
// LogTable: nodes at 16 an octave of x, found from the bits of x. ClosureTable: the last stretch before a
// cell is full, where F rises like -ln(1 - l X^2); nodes uniform in y = sqrt(-ln(1 - l X^2)), in which F is
// smooth. Each also carries what unloading needs: work so far, steepest d ln F/d ln x so far, least d ln a/d
// ln x so far.

#include "platen/law/contact.hpp"
#include "platen/law/loading_case.hpp"

#include <bit>
#include <cassert>
#include <cstdint>

namespace platen::law {

/// F and dF/dx of a loading curve, and d ln a/d ln x of its contact radius.
struct TableSample {
  double F, slope, a_log_slope;
};

/// What has happened on the loading curve up to here.
struct CurveHistory {
  double work = 0;
  double steepest = 0; ///< largest d ln F/d ln x so far
  double least_a = 1;  ///< smallest d ln a/d ln x so far

  void pass(double x, const TableSample& s) {
    steepest = larger(steepest, x * s.slope / s.F * (1 + 1e-4)); // a margin for what lies between samples
    least_a = smaller(least_a, s.a_log_slope - 1e-4);
  }
};

/// c0 + c1 t + c2 t^2 + c3 t^3
struct Cubic {
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0;

  static Cubic hermite(double h, double f0, double d0, double f1, double d1) {
    const double rise = (f1 - f0) / h;
    return {f0, d0, (3 * rise - 2 * d0 - d1) / h, (d0 + d1 - 2 * rise) / (h * h)};
  }
  [[nodiscard]] PLATEN_FUNCTION double value(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }
  [[nodiscard]] PLATEN_FUNCTION double slope(double t) const { return c1 + t * (2 * c2 + 3 * t * c3); }
  [[nodiscard]] PLATEN_FUNCTION double integral(double t) const {
    return t * (c0 + t * (c1 / 2 + t * (c2 / 3 + t * c3 / 4)));
  }
};

class LogTable {
 public:
  static constexpr int most_cells = 416; // 26 octaves, from 1.5e-8 to 1
  double x_low = 0, x_high = 0;
  CurveHistory end; ///< at x_high

  /// `sample(x)` on [low, high]; `start` is the history at `low`.
  template <class Sample> void make(double low, double high, CurveHistory start, const Sample& sample) {
    x_low = low;
    x_high = high;
    base_ = cell_bits(low);
    cells_ = static_cast<int>(cell_bits(high) - base_) + 1;
    assert(cells_ <= most_cells);
    double left = low;
    TableSample at_left = sample(left);
    start.pass(left, at_left);
    for (int i = 0; i < cells_;) {
      // A cell cut very short by an end joins its neighbour: its cubic would be all rounding.
      int last = i;
      if (i == 0 && cells_ > 1 && right_of(0) - left < 1e-3 * left) last = 1;
      if (cells_ - 1 - last == 1 && high - right_of(last) < 1e-3 * high) last = cells_ - 1;
      const double right = last == cells_ - 1 ? high : right_of(last);
      const double h = right - left;
      for (int k = 1; k < 4; ++k) start.pass(left + h * k / 4, sample(left + h * k / 4));
      const TableSample at_right = sample(right);
      start.pass(right, at_right);
      const Cubic cubic = Cubic::hermite(h, at_left.F, at_left.slope, at_right.F, at_right.slope);
      for (int j = i; j <= last; ++j) {
        cell_[j] = {left, cubic};
        history_[j] = start; // steepest and least include this whole cell
      }
      start.work += cubic.integral(h);
      left = right;
      at_left = at_right;
      i = last + 1;
    }
    end = start;
  }

  PLATEN_FUNCTION void at(double x, double& F, double& slope) const {
    const Cell& c = cell_[index(x)];
    const double t = x - c.left;
    F = c.cubic.value(t);
    slope = c.cubic.slope(t);
  }

  [[nodiscard]] PLATEN_FUNCTION CurveHistory history(double x) const {
    const int i = index(x);
    CurveHistory h = history_[i];
    h.work += cell_[i].cubic.integral(x - cell_[i].left);
    return h;
  }

 private:
  struct Cell {
    double left;
    Cubic cubic;
  };
  static constexpr int mantissa_bits = 4; // 16 cells an octave
  [[nodiscard]] static PLATEN_FUNCTION std::int64_t cell_bits(double x) {
    return std::bit_cast<std::int64_t>(x) >> (52 - mantissa_bits);
  }
  [[nodiscard]] double right_of(int i) const {
    return std::bit_cast<double>((base_ + i + 1) << (52 - mantissa_bits));
  }
  [[nodiscard]] PLATEN_FUNCTION int index(double x) const {
    const auto i = static_cast<int>(cell_bits(x) - base_);
    return i < 0 ? 0 : i < cells_ ? i : cells_ - 1;
  }

  std::int64_t base_ = 0;
  int cells_ = 0;
  Cell cell_[most_cells];
  CurveHistory history_[most_cells];
};

class ClosureTable {
 public:
  static constexpr int cells = 64;
  double x_low = 0, x_high = 0;
  CurveHistory end; ///< at x_high

  /// The curve from the least pressure (X = 0) to X = X_end, X = (chi - chi_min)/(chi_zp - chi_min).
  template <class Sample>
  void make(LoadingCase loading, double chi_min, double chi_zp, double l, double X_end, CurveHistory start,
            const Sample& sample) {
    loading_ = loading;
    chi_min_ = chi_min;
    inverse_span_ = 1 / (chi_zp - chi_min);
    l_ = l;
    h_ = stretch(X_end) / cells;
    x_low = x_of_cell_volume_ratio(loading, chi_min);
    x_high = x_of_cell_volume_ratio(loading, chi_min + X_end * (chi_zp - chi_min));
    TableSample left = sample(x_low);
    double rate_left = x_rate(0, x_low);
    start.pass(x_low, left);
    for (int i = 0; i < cells; ++i) {
      const double y = (i + 1) * h_;
      const double middle = x_of(y - h_ / 2), x = i == cells - 1 ? x_high : x_of(y);
      start.pass(middle, sample(middle));
      const TableSample right = sample(x);
      const double rate = x_rate(y, x);
      start.pass(x, right);
      force_[i] = Cubic::hermite(h_, left.F, left.slope * rate_left, right.F, right.slope * rate);
      history_[i] = start;
      // Simpson on dW/dy, and the cubic through it
      const double W1 =
          h_ / 6 * (left.F * rate_left + 4 * sample(middle).F * x_rate(y - h_ / 2, middle) + right.F * rate);
      work_[i] = Cubic::hermite(h_, 0, left.F * rate_left, W1, right.F * rate);
      start.work += W1;
      left = right;
      rate_left = rate;
    }
    end = start;
  }

  PLATEN_FUNCTION void at(double x, double& F, double& slope) const {
    const double X = larger(1e-12, (cell_volume_ratio(loading_, x) - chi_min_) * inverse_span_);
    const double y = stretch(X);
    const int i = index(y);
    const double t = y - i * h_;
    F = force_[i].value(t);
    // dy/dx = dX/dx l X / ((1 - l X^2) y)
    slope = force_[i].slope(t) * cell_volume_ratio_slope(loading_, x) * inverse_span_ * l_ * X /
            ((1 - l_ * X * X) * y);
  }

  [[nodiscard]] PLATEN_FUNCTION CurveHistory history(double x) const {
    const double y = y_of(x);
    const int i = index(y);
    CurveHistory h = history_[i];
    h.work += work_[i].value(y - i * h_);
    return h;
  }

 private:
  [[nodiscard]] PLATEN_FUNCTION double stretch(double X) const { // y of X
    const double z = l_ * X * X;
    if (z < 1e-4) return std::sqrt(z) * (1 + z * (0.25 + z * (13.0 / 96))); // no cancellation in 1 - z
    return std::sqrt(-std::log(1 - z));
  }
  [[nodiscard]] PLATEN_FUNCTION double y_of(double x) const {
    const double X = (cell_volume_ratio(loading_, x) - chi_min_) * inverse_span_;
    return X > 0 ? stretch(X) : 0;
  }
  [[nodiscard]] double x_of(double y) const {
    return x_of_cell_volume_ratio(loading_, chi_min_ + std::sqrt(-std::expm1(-y * y) / l_) / inverse_span_);
  }
  /// dx/dy
  [[nodiscard]] PLATEN_FUNCTION double x_rate(double y, double x) const {
    const double chi_slope = cell_volume_ratio_slope(loading_, x) * inverse_span_; // dX/dx
    const double y2 = y * y;
    // dX/dy = y e^(-y^2)/(l X), l X^2 = 1 - e^(-y^2)
    const double e = std::exp(-y2);
    const double ratio = y2 < 1e-4 ? 1 - y2 / 2 + y2 * y2 / 6 : (1 - e) / y2; // l X^2/y^2
    return e / std::sqrt(l_ * ratio) / chi_slope;
  }
  [[nodiscard]] PLATEN_FUNCTION int index(double y) const {
    const int i = static_cast<int>(y / h_);
    return i < cells ? i : cells - 1;
  }

  LoadingCase loading_ = LoadingCase::die;
  double chi_min_ = 0, inverse_span_ = 0, l_ = 1, h_ = 1;
  Cubic force_[cells];
  Cubic work_[cells];
  CurveHistory history_[cells];
};

} // namespace platen::law
