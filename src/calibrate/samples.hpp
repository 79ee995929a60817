#pragma once
// A measured particle as the search sees it: rows of one particle, few enough to be evaluated often, and what
// a law says for them.

#include "measure/machine.hpp"
#include "measure/stages.hpp"
#include "platen/law/catalogue.hpp"

#include <cmath>
#include <vector>

namespace platen::calibrate {

struct Samples {
  double radius_m = 0, per_travel = 0.5;
  double force_max_N = 0;
  double contact_guess_m = 0; ///< travel
  double travel_noise_m = 0, force_noise_N = 0;
  std::vector<double> travel_m; ///< the machine's part taken off
  std::vector<double> force_N;
  std::vector<double> compliance; ///< of the machine at this force [m/N]
  std::vector<measure::Stage> stage;
  std::vector<double> sigma_N; ///< what the noise of force and travel lets expect
  std::size_t rows = 0;        ///< of the file
  bool unloads = false;
  std::vector<double> progress; ///< of the test at each row, 0 to 1, by time where the file has it
  std::size_t apart_before = 0, apart_after = 0; ///< rows out of contact: they show the zero of the load cell

  double delta(std::size_t i, double contact_m) const { return per_travel * (travel_m[i] - contact_m); }
};

/// Rows that follow each other in one stage are averaged where there are more than some thousands; rows from
/// a break on are left out. `with_unloading` false: up to the first unloading.
Samples samples_of(const measure::Specimen&, const measure::Stages&, const measure::Machine&,
                   bool with_unloading);

/// The force of the law at each row, and its stiffness where asked for. The law is made against a plane, for
/// a particle of radius `made_for`; it gives F = R^2 f(delta/R). Below the largest overlap it unloads from
/// the row where the platens turned.
template <class Law>
void predict(const Law& law, double made_for, const Samples& s, double contact_m, std::vector<double>& force,
             std::vector<double>* stiffness = nullptr) {
  using measure::Stage;
  force.resize(s.travel_m.size());
  if (stiffness) stiffness->resize(s.travel_m.size());
  const double length = s.radius_m / made_for;
  double largest = 0, last = 0;
  bool closing = true; // a hold belongs to what was before it
  for (std::size_t i = 0; i < s.travel_m.size(); ++i) {
    double delta = s.delta(i, contact_m) / length;
    const bool back = s.stage[i] == Stage::unloading || s.stage[i] == Stage::reloading;
    if (s.stage[i] != Stage::hold) closing = !back;
    const law::State before{last, closing ? 0.0 : largest};
    auto response = evaluate(law, before, delta);
    // The machine gives way under the law's force, not under the noisy one that was measured.
    const double softness = s.per_travel * s.compliance[i];
    for (int iteration = 0; softness > 0 && iteration < 4; ++iteration) {
      const double F = response.force * length * length, k = response.stiffness * length;
      const double at = s.delta(i, contact_m) + softness * (s.force_N[i] - F);
      const double off = at - delta * length;
      delta += off / (1 + k * softness) / length;
      response = evaluate(law, before, delta);
      if (std::abs(off) < 1e-7 * s.radius_m) break;
    }
    force[i] = response.force * length * length;
    if (stiffness) (*stiffness)[i] = response.stiffness * length;
    largest = delta > largest ? delta : largest;
    last = delta;
  }
}

} // namespace platen::calibrate
