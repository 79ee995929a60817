#include "calibrate/samples.hpp"

#include <algorithm>
#include <cmath>

namespace platen::calibrate {

using measure::Stage;

Samples samples_of(const measure::Specimen& s, const measure::Stages& stages, const measure::Machine& machine,
                   bool with_unloading) {
  constexpr std::size_t most = 2000; // rows of a particle; more say nothing that their means do not
  Samples samples;
  samples.radius_m = s.radius_m();
  samples.per_travel = s.per_travel();
  samples.contact_guess_m = stages.contact_travel_m;
  samples.travel_noise_m = stages.travel_noise_m;
  samples.force_noise_N = stages.force_noise_N;
  std::size_t end = 0;
  for (; end < s.force_N.size(); ++end) {
    if (stages.of_row[end] == Stage::broken) break;
    if (!with_unloading && stages.of_row[end] == Stage::unloading) break;
  }
  const std::size_t together = std::max<std::size_t>(1, end / most);
  samples.travel_noise_m /= std::sqrt(static_cast<double>(together));
  samples.force_noise_N /= std::sqrt(static_cast<double>(together));
  for (std::size_t i = 0; i < end;) {
    std::size_t stop = i;
    double x = 0, F = 0;
    while (stop < end && stop - i < together && stages.of_row[stop] == stages.of_row[i]) {
      x += s.travel_m[stop], F += s.force_N[stop];
      ++stop;
    }
    const double n = static_cast<double>(stop - i);
    F /= n;
    samples.travel_m.push_back(x / n - machine.travel(F));
    samples.force_N.push_back(F);
    samples.compliance.push_back(machine.slope(F));
    samples.stage.push_back(stages.of_row[i]);
    samples.unloads = samples.unloads || stages.of_row[i] == Stage::unloading;
    samples.apart_before += stages.of_row[i] == Stage::approach;
    samples.progress.push_back(s.time_s.empty() ? static_cast<double>(i) : s.time_s[i]);
    i = stop;
  }
  samples.rows = end;
  const double begin = samples.progress.front(), whole = samples.progress.back() - begin;
  for (double& p : samples.progress) p = whole > 0 ? (p - begin) / whole : 0;
  samples.force_max_N = *std::ranges::max_element(samples.force_N);
  samples.sigma_N.assign(samples.force_N.size(), std::max(samples.force_noise_N, 1e-4 * samples.force_max_N));
  return samples;
}

} // namespace platen::calibrate
