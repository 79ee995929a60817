#include "surrogate/assess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

constexpr double certain = 0.03, usable = 0.1; ///< expected relative errors of a curve: inside, near the edge
constexpr double least_reach = 0.1;            ///< delta/R0 to which a law near the edge must reach

std::string per_cent(double share) { return fmt::format("{:.2g} %", 100 * share); }

void note(Assessment& a, Verdict verdict, std::string reason) {
  a.verdict = std::max(a.verdict, verdict);
  a.reasons.push_back(std::move(reason));
}

} // namespace

std::string_view name_of(Verdict verdict) {
  return verdict == Verdict::inside ? "inside" : verdict == Verdict::outside ? "outside" : "near the edge";
}

Assessment assess(const Surrogate& s, const Description& d, const Prediction& p) {
  Assessment a;
  for (std::size_t k = 0; k < s.ranges.size(); ++k) {
    const auto& [key, low, high] = s.ranges[k];
    const double value = d.numbers[k].value;
    const double slack = 1e-6 * std::max(std::abs(low), std::abs(high)) + 1e-12;
    if (value >= low - slack && value <= high + slack) continue;
    a.in_ranges = false;
    if (high - low > slack)
      note(a, Verdict::outside, fmt::format("{} = {:.6g} is not in {:.6g} to {:.6g}", key, value, low, high));
    else note(a, Verdict::outside, fmt::format("{} = {:.6g}, where all have {:.6g}", key, value, low));
  }
  a.knots = s.knots.size();
  if (grows(locked_growth, s.knots, p.F_bar))
    note(
        a, Verdict::outside,
        fmt::format(
            "it locks (its force grows more than {}-fold from delta/R0 = 0.3 on), and such presses depend on "
            "their mesh",
            locked_growth));
  if (p.expected.back() <= certain) return a;
  const auto upto = std::find_if(p.expected.begin(), p.expected.end(), [](double e) { return e > usable; });
  a.knots = static_cast<std::size_t>(upto - p.expected.begin());
  const bool early = a.knots == 0 || s.knots[a.knots - 1] < least_reach;
  std::string reason = fmt::format("the curve is expected to be {} off", per_cent(p.expected.back()));
  if (early) a.knots = s.knots.size();
  else if (a.knots < s.knots.size())
    reason += fmt::format(", so the law ends at delta/R0 = {:.4g}, to where it is {}", s.knots[a.knots - 1],
                          per_cent(p.expected[a.knots - 1]));
  note(a, early ? Verdict::outside : Verdict::near_the_edge, std::move(reason));
  return a;
}

std::vector<Near> nearest(const Surrogate& s, const Description& d, std::size_t count) {
  const auto at = input_of(s, d.coordinates);
  const Inputs& inputs = s.layers.front().inputs;
  const auto& w = s.layers.front().force.processes.front().w;
  std::vector<Near> all;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    double squares = 0;
    for (std::size_t k = 0; k < at.size(); ++k) squares += std::pow(w[k] * (at[k] - inputs.row(i)[k]), 2);
    all.push_back({i, std::sqrt(squares)});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Near& x, const Near& y) { return x.distance < y.distance; });
  all.resize(std::min(all.size(), count));
  return all;
}

std::string words(const Surrogate& s, const Near& near) {
  std::string text = s.runs[near.index];
  const char* before = ": ";
  for (std::size_t k = 0; k < s.ranges.size(); ++k) {
    if (!(s.ranges[k].high > s.ranges[k].low)) continue;
    text += fmt::format("{}{} = {:.3g}", before, s.ranges[k].key, s.numbers[near.index][k]);
    before = ", ";
  }
  return text;
}

std::optional<Answer> ask(const Surrogate& s, const Description& d, const std::optional<Answer>& other) {
  Prediction p = predict(s, d);
  Assessment a = assess(s, d, p);
  if (other && std::pair(other->assessment.verdict, other->prediction.expected.back()) <=
                   std::pair(a.verdict, p.expected.back()))
    return {};
  return Answer{s, std::move(p), std::move(a), d.sigma_ref};
}

} // namespace platen::surrogate
