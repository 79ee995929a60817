#pragma once
// What `evaluate` needs of a law at the largest overlap so far - force, radius, unloading, work - as cubics
// over cells of equal ratio, found from the bits of the overlap: one look-up instead of the formulas, several
// times faster. Lives inside the law, without pointers.
//
// Relative errors are below 2e-5, of the stiffness below 1e-4, at nine points of each cell, where they are
// checked as it is made; between them the test holds them to 1e-4 and 1e-3. Where a cubic misses that, as in
// the cell of a kink, and where the unloading curve is so near to creating energy that an error could do so,
// the cell is left out and the formulas serve.

#include "platen/law/contact.hpp"
#include "platen/law/log_table.hpp"

#include <cmath>

namespace platen::law {

class PeakTable {
 public:
  /// Up to `high`, from `low` or 2^-20 of `high`. Where unloading still retraces a loading curve that is one
  /// power, the law is elastic: its `gamma_elastic` is moved there.
  template <class Law> void make(Law& law, double low, double high) {
    base_ = cell_bits(high * 0x1p-20);
    law.gamma_elastic = end_of_retracing(law, left_of(0), high);
    for (int i = 0; i < cells; ++i)
      if (left_of(i) >= low) cell_[i] = made(law, left_of(i), left_of(i + 1));
      else cell_[i] = {};
  }

  /// False: no cell here. `peak` then holds nothing of use.
  PLATEN_HOT bool at(double gamma, Peak<double>& peak) const {
    const std::int64_t i = cell_bits(gamma) - base_;
    if (static_cast<std::uint64_t>(cells) <= static_cast<std::uint64_t>(i)) return false;
    const Cell& c = cell_[i];
    const double t = gamma - left_of(i);
    peak.F = c.F.value(t);
    peak.slope = c.F.slope(t);
    peak.a = c.a.value(t);
    const double per_gamma = 1 / gamma; // a division that does not wait for the table
    peak.end = {c.rate_gamma.value(t) * per_gamma, c.alpha.value(t)};
    peak.work = c.work + t * c.work_slope + c.F.integral(t);
    return 0 < peak.F; // not where the cell is left out, nor where none was ever made
  }

 private:
  static constexpr int bits = 3, cells = 20 << bits; // 8 cells an octave, 20 octaves
  static constexpr int samples = 8;                  // of a cell, when it is checked
  static constexpr double most_error = 2e-5, rounding = 1e-12;
  /// Of the work of a further overlap that is lost, at least; and how much more steeply unloading has to
  /// start.
  static constexpr double least_loss = 0.01, least_steepness = 1.001;

  struct Cell {
    Cubic F, rate_gamma, alpha, a;
    double work = 0, work_slope = 0; // what the integral of F leaves
  };

  template <class Law> static bool retraces(const Law& law, double gamma, double log_slope) {
    const Peak<double> p = formula_peak(law, gamma);
    return std::abs(p.end.rate * gamma - 1) < rounding && std::abs(p.end.alpha - log_slope) < 1e-9 &&
           std::abs(p.slope * gamma - log_slope * p.F) < 1e-9 * p.F;
  }

  template <class Law> static double end_of_retracing(const Law& law, double low, double high) {
    double from = larger(low, law.gamma_elastic), to = from * (1 + 1e-9);
    const Peak<double> start = formula_peak(law, to);
    const double log_slope = start.slope * to / start.F;
    while (to < high && retraces(law, to, log_slope)) from = to, to *= 1.1;
    if (from == larger(low, law.gamma_elastic)) return law.gamma_elastic;
    for (int i = 0; i < 50; ++i) {
      const double middle = (from + to) / 2;
      (retraces(law, middle, log_slope) ? from : to) = middle;
    }
    return from;
  }

  template <class Law> static Cell made(const Law& law, double left, double right) {
    Peak<double> exact[samples + 1];
    const double h = right - left;
    for (int k = 0; k <= samples; ++k) exact[k] = formula_peak(law, left + h * k / samples);
    const Peak<double>&first = exact[0], &last = exact[samples];
    const bool elastic = right <= law.gamma_elastic;
    Cell c;
    c.F = Cubic::hermite(h, first.F, first.slope, last.F, last.slope);
    const auto through = [&](const auto& of) {
      const auto at = [&](double gamma) { return of(gamma, formula_peak(law, gamma)); };
      return Cubic::through(h, at(left), at(left + h / 3), at(left + 2 * h / 3), at(right));
    };
    c.a = through([](double, const Peak<double>& p) { return p.a; });
    if (!elastic) { // else never followed
      c.rate_gamma = through([](double gamma, const Peak<double>& p) { return p.end.rate * gamma; });
      c.alpha = through([](double, const Peak<double>& p) { return p.end.alpha; });
    }
    c.work = first.work;
    c.work_slope = (last.work - first.work - c.F.integral(h)) / h;

    const auto near = [](double value, double reference, double error = most_error) {
      return std::abs(value - reference) <= error * std::abs(reference);
    };
    const auto lost = [&](int k) { return detail::dissipated_work(left + h * k / samples, exact[k]); };
    bool good = true, bent = true, residual = true;
    for (int k = 0; k <= samples; ++k) {
      const double t = h * k / samples, gamma = left + t, rate_gamma = exact[k].end.rate * gamma;
      const Peak<double>& p = exact[k];
      good = good && near(c.F.value(t), p.F) && near(c.F.slope(t), p.slope, 5 * most_error) &&
             near(c.a.value(t), p.a) && near(c.work + t * c.work_slope + c.F.integral(t), p.work);
      if (elastic) continue;
      bent = bent && std::abs(rate_gamma - 1) < rounding;
      residual = residual && rate_gamma > 1 + 5 * most_error;
      good = good && near(c.rate_gamma.value(t), rate_gamma) && near(c.alpha.value(t), p.end.alpha) &&
             p.end.alpha * p.end.rate * p.F > least_steepness * p.slope;
      if (k > 0) good = good && lost(k) - lost(k - 1) > least_loss * (p.work - exact[k - 1].work);
    }
    if (bent) c.rate_gamma = {1, 0, 0, 0}; // ends at the origin
    if (!good || !(elastic || bent || residual)) c.F.c0 = std::nan("");
    return c;
  }

  [[nodiscard]] static PLATEN_FUNCTION std::int64_t cell_bits(double gamma) {
    return std::bit_cast<std::int64_t>(gamma) >> (52 - bits);
  }
  [[nodiscard]] PLATEN_FUNCTION double left_of(std::int64_t i) const {
    return std::bit_cast<double>((base_ + i) << (52 - bits));
  }

  std::int64_t base_ = 0;
  Cell cell_[cells];
};

} // namespace platen::law
