#include "core/error.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {

bool grows(double times, const std::vector<double>& knots, const std::vector<double>& F_bar) {
  const std::size_t from = knot_of(knots, 0.3);
  return from < knots.size() && F_bar.back() > times * F_bar[from];
}

std::vector<double> input_of(const Surrogate& s, const std::vector<double>& coordinates) {
  if (coordinates.size() != s.low.size() || coordinates.size() != s.high.size())
    throw core::InvalidInput(
        fmt::format("the surrogate of {} has {} coordinates where a material of {} has {}; "
                    "make it again with `platen study surrogate`",
                    s.pool, s.low.size(), s.model, coordinates.size()));
  std::vector<double> input;
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    if (s.high[k] - s.low[k] > 1e-9) input.push_back((coordinates[k] - s.low[k]) / (s.high[k] - s.low[k]));
  return input;
}

Prediction predict(const Surrogate& s, const Description& d, const CoarsePress* guide) {
  const Said said = said_of(s, d, guide);
  const double band = guide ? s.guide->band : s.band;
  auto [alpha, beta] = alpha_beta(said.work, said.exponent);
  Prediction p{exponentials(said.F, 0, said.F.size()),
               exponentials(said.a, 0, said.a.size()),
               std::move(alpha),
               std::move(beta),
               {},
               {}};
  for (const double variance : said.F_variance) p.band.push_back(band * std::sqrt(variance));
  p.expected = expected_errors(s.knots, p.F_bar, said.F_variance);
  return p;
}

} // namespace platen::surrogate
