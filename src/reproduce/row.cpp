#include "reproduce/row.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::reproduce {

namespace {

/// How many tolerances ours is away.
double excess(const Comparison& c) {
  const double d = std::abs(difference(c));
  return std::isfinite(d) ? d / c.tolerance : HUGE_VAL;
}

} // namespace

double difference(const Comparison& c) {
  const double d = c.ours - c.theirs;
  return c.measure == Measure::relative ? d / std::abs(c.theirs) : d;
}

bool agrees(const Comparison& c) { return std::abs(difference(c)) <= c.tolerance; }

Comparison overlay(const std::string& what, const std::string& abscissa, const std::vector<double>& x,
                   const std::vector<double>& theirs, const std::vector<double>& ours, double tolerance,
                   double error) {
  if (x.empty() || x.size() != theirs.size() || x.size() != ours.size())
    throw core::InvalidInput(fmt::format("{}: {} abscissae, {} values of the paper and {} of ours", what,
                                         x.size(), theirs.size(), ours.size()));
  Comparison furthest;
  double largest = -1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string of = x.size() > 1 ? fmt::format("largest difference of {} points, ", x.size()) : "";
    const Comparison here{fmt::format("{}, {}at {} = {:.4g}", what, of, abscissa, x[i]),
                          theirs[i],
                          ours[i],
                          tolerance,
                          Measure::relative,
                          error};
    const double d = std::abs(difference(here));
    if (!(d <= largest)) { // a value that is not finite is the furthest
      furthest = here;
      largest = std::isfinite(d) ? d : HUGE_VAL;
    }
  }
  return furthest;
}

std::string_view name_of(Verdict v) {
  switch (v) {
  case Verdict::reproduced:
    return "reproduced";
  case Verdict::differs:
    return "differs";
  case Verdict::not_comparable:
    break;
  }
  return "not comparable";
}

Verdict verdict(const Row& row) {
  if (row.comparisons.empty()) {
    if (row.because.empty())
      throw core::InvalidInput(fmt::format("{}: neither a number nor a reason why there is none", row.id));
    return Verdict::not_comparable;
  }
  return std::ranges::all_of(row.comparisons, agrees) ? Verdict::reproduced : Verdict::differs;
}

const Comparison* worst(const Row& row) {
  const auto furthest = std::ranges::max_element(row.comparisons, {}, excess);
  return furthest == row.comparisons.end() ? nullptr : &*furthest;
}

std::string difference_text(double d, Measure measure) {
  const std::string_view sign = d < 0 ? "−" : "+";
  const double size = std::abs(d);
  if (measure == Measure::absolute) return fmt::format("{}{:.3g}", sign, size);
  if (d >= 10) return fmt::format("a factor of {:.0f}", 1 + d);
  return size >= 0.0995 ? fmt::format("{}{:.0f} %", sign, 100 * size)
                        : fmt::format("{}{:.2g} %", sign, 100 * size);
}

std::string difference_text(const Comparison& c) {
  const double d = difference(c);
  if (!std::isfinite(d)) return "no number";
  return difference_text(d, c.measure);
}

std::string sentence(const Row& row) {
  switch (verdict(row)) {
  case Verdict::reproduced:
    return "reproduced";
  case Verdict::differs:
    return fmt::format("differs by {}: {}", difference_text(*worst(row)), worst(row)->what);
  case Verdict::not_comparable:
    break;
  }
  return "cannot be compared, because " + row.because;
}

} // namespace platen::reproduce
