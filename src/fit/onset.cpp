#include "fit/onset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace platen::fit {
namespace {

using Numbers = std::vector<double>;

struct Foot {
  double x_0 = 0, baseline = 0, deviation = std::numeric_limits<double>::infinity();
};

/// The best line of F over max(x - x_0, 0)^p.
Foot foot_at(const Numbers& x, const Numbers& F, double x_0, double p, bool with_baseline) {
  const double n = static_cast<double>(x.size());
  Numbers u(x.size());
  double mu = 0, mF = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    u[i] = x[i] > x_0 ? std::pow(x[i] - x_0, p) : 0;
    mu += u[i] / n, mF += F[i] / n;
  }
  if (!with_baseline) mu = mF = 0;
  double uu = 0, uF = 0;
  for (std::size_t i = 0; i < x.size(); ++i) uu += (u[i] - mu) * (u[i] - mu), uF += (u[i] - mu) * (F[i] - mF);
  const double A = uu > 0 ? uF / uu : 0, baseline = mF - A * mu;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(F[i] - baseline - A * u[i], 2);
  return {x_0, baseline, sum};
}

/// Of the rows up to a share of the largest force.
Onset onset_below(double share, const Numbers& x, const Numbers& F, double force_noise, double p_most) {
  const double F_max = *std::ranges::max_element(F);
  std::size_t end = 0;
  while (end < F.size() && F[end] < share * F_max) ++end;
  end = std::clamp<std::size_t>(end, std::min<std::size_t>(F.size(), 6), F.size());
  Numbers fx, fF;
  const std::size_t stride = std::max<std::size_t>(1, end / 400); // more rows do not show it better
  for (std::size_t i = 0; i < end; i += stride) fx.push_back(x[i]), fF.push_back(F[i]);
  std::size_t before = 0;
  const double threshold = std::max(5 * force_noise, 0.02 * F_max);
  while (before < fF.size() && std::abs(fF[before]) < threshold) ++before;
  const bool with_baseline = before >= 6;
  const double scale = x.back() - x.front();
  double step = (fx.back() - fx.front() + 0.5 * scale) / 60, low = fx.front() - 0.5 * scale, high = fx.back();
  Foot best;
  for (int level = 0; level < 6; ++level) {
    for (double x_0 = low; x_0 < high; x_0 += step)
      for (double p = 0.8; p < p_most + 0.05; p += 0.1)
        if (const Foot foot = foot_at(fx, fF, x_0, p, with_baseline); foot.deviation < best.deviation)
          best = foot;
    low = best.x_0 - 2 * step, high = best.x_0 + 2 * step;
    step /= 8;
  }
  const double allowed = best.deviation * (1 + 1 / std::max(1.0, static_cast<double>(fx.size()) - 4));
  double reach = 1e-4 * scale;
  for (double d = reach; d < scale; d *= 1.3) {
    double least = std::numeric_limits<double>::infinity();
    for (const double x_0 : {best.x_0 - d, best.x_0 + d})
      for (double p = 0.8; p < p_most + 0.05; p += 0.05)
        least = std::min(least, foot_at(fx, fF, x_0, p, with_baseline).deviation);
    if (least > allowed) break;
    reach = d;
  }
  return {best.x_0, reach, with_baseline ? best.baseline : 0, with_baseline ? before * stride : 0};
}

} // namespace

Onset find_onset(const Numbers& x, const Numbers& F, double force_noise, double p_most) {
  const Onset near = onset_below(0.15, x, F, force_noise, p_most),
              far = onset_below(0.35, x, F, force_noise, p_most);
  Onset best = near.uncertainty < 3 * far.uncertainty ? near : far;
  best.uncertainty += std::abs(near.x - far.x); // no power law holds far, elastic at first and plastic then
  return best;
}

} // namespace platen::fit
