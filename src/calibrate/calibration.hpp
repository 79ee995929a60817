#pragma once
// A law from measured particles.

#include "calibrate/search.hpp"
#include "fit/doubt.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace platen::calibrate {

struct Settings {
  std::string law, variant;
  law::ParameterTexts given; ///< parameters that are known: nu, E_Pa, ...
  measure::Machine machine;
};

/// One particle that was used.
struct Particle {
  std::string file, name;
  double diameter_m = 0;
  measure::Stages stages;
  std::size_t rows = 0;
  double delta_bar_max = 0;
  std::vector<double> values, errors; ///< of this particle alone
  double contact_m = 0, contact_error_m = 0;
  std::string contact;                ///< on the scale of the file
  double baseline_N = 0, drift_N = 0; ///< as Own
  bool baseline_fitted = false, drift_fitted = false;
  double R2 = 0, relative_l2 = 0; ///< of the pooled law
  Samples samples;
  std::vector<double> force_N; ///< of the pooled law, at the samples

  /// Of a sample, without the zero of the load cell.
  double measured_N(std::size_t i) const {
    return samples.force_N[i] - baseline_N - drift_N * samples.progress[i];
  }
};

struct Calibration {
  fit::LawCard card; ///< complete, provenance and doubts included
  std::vector<FreeParameter> free;
  std::vector<double> values, errors; ///< pooled
  std::vector<std::vector<double>> correlations;
  std::vector<Particle> particles;
  std::vector<std::string> broken; ///< kept out, a sentence each
  std::vector<std::string> said;   ///< what else was done or cannot be told
  std::vector<fit::Doubt> doubts;
  double R2 = 0, relative_l2 = 0, delta_bar_max = 0;
  std::size_t rows = 0;
};

/// Parameters of the law and contact points together, each particle alone and all together. Broken particles
/// are kept out. InvalidInput where a diameter or a parameter is missing that the curves cannot show, where
/// no whole particle is left; the doubts are not judged here.
Calibration calibrate(const std::vector<measure::Measurement>&, const Settings&);

/// A few lines for people.
std::string words_of(const Calibration&);
/// "0.02 N, drifting by 0.001 N"
std::string zero_words(const Particle&);

} // namespace platen::calibrate
