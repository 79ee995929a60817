#pragma once
// A costly loading curve F(x) turned into cubics, and what unloading needs beside it. Relative error of the
// force below 1e-4 (tested). Made once by `prepare`.
//
// LoadingTable: 16 cells an octave. ClosureTable: the last stretch before a cell is full, where F rises like
// -ln(1 - l X^2); uniform in y = sqrt(-ln(1 - l X^2)), in which F is smooth. SlopeTable: the slope with which
// unloading starts, 4 cells an octave.

#include "platen/law/contact.hpp"
#include "platen/law/loading_case.hpp"
#include "platen/law/log_table.hpp"

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

/// S gamma_max [N] against x: what unloading_from_slope takes.
using SlopeTable = LogTable<2>;

class LoadingTable {
 public:
  CurveHistory end; ///< at x_high

  /// `sample(x)` on [low, high]; `start` is the history at `low`.
  template <class Sample> void make(double low, double high, CurveHistory start, const Sample& sample) {
    first_ = start;
    force_.make(
        low, high,
        [&](double x) {
          const TableSample s = sample(x);
          return Force::Sample{s.F, s.slope};
        },
        [&](int first, int last, double left, double right, const Cubic& cubic) {
          for (int k = 0; k <= 4; ++k) {
            const double x = left + (right - left) * k / 4;
            start.pass(x, sample(x));
          }
          for (int j = first; j <= last; ++j)
            history_.push_back(start); // steepest and least: of this whole cell
          start.work += cubic.integral(right - left);
        });
    end = start;
  }

  [[nodiscard]] PLATEN_FUNCTION double x_low() const { return force_.x_low; }
  [[nodiscard]] PLATEN_FUNCTION double x_high() const { return force_.x_high; }

  /// Everything but the radius.
  PLATEN_HOT void at(double x, Loading<double>& here) const {
    force_.at(x, here.F, here.slope);
    const std::size_t i = force_.index(x);
    const double t = force_.share(x);
    here.steepest = before(i).steepest + t * (history_[i].steepest - before(i).steepest);
    here.least_a = before(i).least_a + t * (history_[i].least_a - before(i).least_a);
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double x) const {
    return history_[force_.index(x)].work + force_.integral_in_cell(x);
  }

 private:
  using Force = LogTable<4>;
  Force force_;
  [[nodiscard]] PLATEN_FUNCTION const CurveHistory& before(std::size_t i) const {
    return i > 0 ? history_[i - 1] : first_;
  }
  CurveHistory first_;
  std::vector<CurveHistory> history_;
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
    first_ = start;
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

  PLATEN_HOT void at(double x, Loading<double>& here) const {
    const double X = larger(1e-12, (cell_volume_ratio(loading_, x) - chi_min_) * inverse_span_);
    const double y = stretch(X);
    const int i = index(y);
    const double t = y - i * h_;
    here.F = force_[i].value(t);
    const CurveHistory &from = i > 0 ? history_[i - 1] : first_, &to = history_[i];
    here.steepest = from.steepest + t / h_ * (to.steepest - from.steepest);
    here.least_a = from.least_a + t / h_ * (to.least_a - from.least_a);
    // dy/dx = dX/dx l X / ((1 - l X^2) y)
    here.slope = force_[i].slope(t) * cell_volume_ratio_slope(loading_, x) * inverse_span_ * l_ * X /
                 ((1 - l_ * X * X) * y);
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double x) const {
    const double y = y_of(x);
    const int i = index(y);
    return history_[i].work + work_[i].value(y - i * h_);
  }

 private:
  [[nodiscard]] PLATEN_HOT double stretch(double X) const { // y of X
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
  [[nodiscard]] PLATEN_HOT int index(double y) const {
    const int i = static_cast<int>(y / h_);
    return i < cells ? i : cells - 1;
  }

  LoadingCase loading_ = LoadingCase::die;
  double chi_min_ = 0, inverse_span_ = 0, l_ = 1, h_ = 1;
  Cubic force_[cells];
  Cubic work_[cells];
  CurveHistory first_, history_[cells];
};

} // namespace platen::law
