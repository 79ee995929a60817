#pragma once
// Synthetic measurements: what an instrument would have written of a curve that is known.

#include "measure/specimen.hpp"
#include "press/curve.hpp"

#include <random>
#include <string>
#include <vector>

namespace platen::measure {

/// What stands between a particle and its file.
struct Instrument {
  double gap_m = 0;              ///< way of the platens before contact
  double noise = 0;              ///< of the force, standard deviation over the largest force
  double compliance_m_per_N = 0; ///< of the machine
  double zero_N = 0;             ///< of the load cell
  double row_s = 0.1;            ///< time between two rows
};

/// A test without an instrument: delta of one platen, negative before contact, and the force there.
struct Test {
  std::vector<double> delta_m, force_N;
};

/// The curve of a press along its branches: at each that unloads before the end a loop, half of the way back
/// and again forth; the unloading from the end where there is one, until the platens are apart. For a
/// particle of this diameter: F goes with R^2. `rows`: of the loading. InvalidInput for a curve without
/// loading.
Test test_of(const press::Curve&, double diameter_m, double gap_m, int rows = 150);

/// travel = gap + 2 delta + compliance F; force = F + zero + noise. Contact is at travel = gap.
Specimen as_measured(const Test&, double diameter_m, const Instrument&, std::mt19937_64&);

/// Many particles: diameters from 0.6 to 1.4 times `diameter_m`, gaps from half to one and a half times that
/// of the instrument; a single one as it is said.
std::vector<Specimen> batch(const press::Curve&, int particles, double diameter_m, const Instrument&,
                            std::uint64_t seed);

/// As a file: particle, diameter_mm, time_s, travel_um, force_N.
std::string raw_text(const std::vector<Specimen>&);

} // namespace platen::measure
