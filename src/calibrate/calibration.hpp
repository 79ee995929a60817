#pragma once
// A law, or a material, from measured particles.

#include "calibrate/curves.hpp"
#include "calibrate/free_material.hpp"
#include "calibrate/profile.hpp"
#include "fit/doubt.hpp"
#include "study/store.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace platen::calibrate {

struct Settings {
  std::string law, variant;
  law::ParameterTexts given; ///< parameters that are known: nu, E_Pa, ...
  measure::Machine machine;
  bool all_profiles = false;                         ///< else of what is weakly determined
  std::shared_ptr<const FreeMaterial> material = {}; ///< is looked for instead of a law
  Curves curves = {};                                ///< of its materials
  std::vector<double> start = {};                    ///< of what is free; empty: from a grid
  std::vector<std::vector<double>> asked = {};       ///< sets of what is free that are to be judged
};

/// What is looked for. InvalidInput for a law that cannot be calibrated.
std::vector<FreeParameter> free_parameters(const Settings&);

/// A set of parameters that was asked for.
struct Told {
  std::vector<double> values;
  double deviance = std::numeric_limits<double>::infinity(); ///< -2 ln(L/L_max)
  double R2 = 0, relative_l2 = std::numeric_limits<double>::infinity();
  /// Of each particle at its samples, as those of the instrument without the zero of its load cell; empty:
  /// there is no such material.
  std::vector<std::vector<double>> force_N;
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
  std::vector<double> noise_errors;   ///< without what is not known of the law of a material
  std::vector<std::vector<double>> correlations;
  std::vector<std::optional<Profile>> profiles; ///< of each free parameter, where it was asked for
  std::optional<material::Material> material;
  std::vector<Told> told;
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

/// The same for a material: the card is the law of the material that was found, and may be used without it.
/// InvalidInput where no surrogate knows such materials.
Calibration calibrate_material(const std::vector<measure::Measurement>&, const Settings&);

/// How the presses of a calibration are done.
struct Presses {
  study::Store store;                          ///< open for writing
  int workers = 1;                             ///< processes
  std::function<void(const std::string&)> say; ///< told each press
};

/// The same through a few presses. Throws ConvergenceError, IoError, Interrupted too; what was pressed is in
/// the store then, and not pressed again.
Calibration calibrate_material_by_presses(const std::vector<measure::Measurement>&, const Settings&,
                                          const Presses&);

/// Its card, with what is known of each number under [source].
std::string material_card(const Calibration&, const std::vector<std::string>& doubts);

/// The law card of a calibration: values, their errors, and where they are from. `card`: law, variant and the
/// parameters that were given.
fit::LawCard card_of(const Calibration&, fit::LawCard card, const std::vector<measure::Measurement>&,
                     const measure::Machine&);

/// A few lines for people.
std::string words_of(const Calibration&);
/// "0.02 N, drifting by 0.001 N"
std::string zero_words(const Particle&);

} // namespace platen::calibrate
