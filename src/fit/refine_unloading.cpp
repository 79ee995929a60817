#include "fit/refine_unloading.hpp"

#include <algorithm>
#include <cmath>

namespace platen::fit {

void refine_unloading(law::PressedMaterial& m) {
  const auto x = m.unload_delta_bar, alpha = m.alpha;
  const std::size_t n = x.size(), through = 4;
  if (n < through) return;
  std::vector<double> work; // its logarithm, over F_max times Hertz's overlap
  for (std::size_t i = 0; i < n; ++i) work.push_back(-std::log(m.beta[i] * (1 + alpha[i])));
  const auto cubic = [&](double at) {
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
    const std::size_t first = std::min(above < 2 ? 0 : above - 2, n - through);
    double sum = 0;
    for (std::size_t i = first; i < first + through; ++i) {
      double weight = 1;
      for (std::size_t j = first; j < first + through; ++j)
        if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
      sum += weight * work[i];
    }
    return sum;
  };
  law::PressedMaterial fine;
  const auto add = [&](double at, double alpha_at, double beta) {
    fine.unload_delta_bar.push_back(at);
    fine.alpha.push_back(alpha_at);
    fine.beta.push_back(beta);
  };
  const auto add_between = [&](double at, double alpha_at) {
    add(at, alpha_at, std::exp(-cubic(at)) / (1 + alpha_at));
  };
  for (const double part : {0.5, 0.75}) add_between(part * x[0], alpha[0]);
  for (std::size_t i = 0; i < n; ++i) {
    add(x[i], alpha[i], m.beta[i]);
    if (i + 1 == n) break;
    for (const double part : {0.25, 0.5, 0.75})
      add_between(x[i] + part * (x[i + 1] - x[i]), alpha[i] + part * (alpha[i + 1] - alpha[i]));
  }
  m.unload_delta_bar = fine.unload_delta_bar;
  m.alpha = fine.alpha;
  m.beta = fine.beta;
}

} // namespace platen::fit
