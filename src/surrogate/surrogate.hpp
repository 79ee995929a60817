#pragma once
// A surrogate: what a data pool says of materials between those that were pressed. Logarithms of force and
// contact radius at the knots, and of work and alpha of the unloadings, are reduced to a few principal
// components, and each of these is a Gaussian process over the coordinates of the material.
//
// Where presses are dear, most are made on a coarse mesh (Kennedy & O'Hagan 2000): the first layer is of
// these, and a second one of what the logarithms change from coarse to fine, in the materials that were
// pressed on both. It is small and smooth, and few presses tell it.
//
// A material may be pressed on that coarse mesh before it is predicted, its guide; then its own curve stands
// in place of the first layer.

#include "surrogate/components.hpp"
#include "surrogate/description.hpp"
#include "surrogate/pool_data.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platen::surrogate {

/// One sum of components for each quantity.
struct Layer {
  explicit Layer(Inputs in) : inputs(std::move(in)), columns(inputs) {}

  Inputs inputs;   ///< in [0, 1]; they stay
  Columns columns; ///< the same
  Components force, radius, work, exponent;
};

/// What a press on the coarse mesh says of a material.
struct CoarsePress {
  std::vector<double> F_bar, a_bar;    ///< at the knots
  std::vector<double> returned, alpha; ///< of the unloadings: returned_of(); none where one ends early or
                                       ///< cannot be fitted
};

/// Relative errors of the pool's materials, each predicted without itself: of five in a hundred larger, and
/// so on.
struct Quantiles {
  double median = 0, p95 = 0, worst = 0;
};
Quantiles quantiles(const std::vector<double>&);
struct LeaveOneOut {
  int materials = 0, locked = 0; ///< of all, those that are said to lock are not counted in what follows
  Quantiles force;               ///< relative L2 of F over the loading
  Quantiles radius;              ///< likewise of a
  Quantiles work;                ///< that an unloading gives back, of all unloadings
  Quantiles residual;            ///< overlap at separation, over that where it turns
  double coverage = 0; ///< of the 90 % band: share of all points of the left-out curves that lie in it
};

/// The coarse mesh, and how good a prediction is that starts with a press on it.
struct Guide {
  int elements = 0;
  double step_max = 0;
  double band = 1.645;
  LeaveOneOut left_out;
};

/// A number that the pool's materials have: a range, or one value.
struct Range {
  std::string key;
  double low = 0, high = 0;
};

struct Surrogate {
  std::string pool, model;
  int engine = 0;
  int asked = 0; ///< runs of the study, finished or not
  int fine = 0;  ///< materials pressed on the mesh that counts
  std::vector<double> knots, unload_delta_bar;
  std::vector<Range> ranges;
  std::vector<double> low, high; ///< of each coordinate; those that do not vary are none of the inputs'
  std::vector<std::string> runs; ///< of the first layer, "powders-17": pool, and number in its runs.csv
  std::vector<std::vector<double>> numbers; ///< of each run, in the order of the ranges
  std::vector<Layer> layers;
  /// Half the width of the 90 % band of ln F over the standard deviation that the processes give: as the
  /// left-out materials want it.
  double band = 1.645;
  LeaveOneOut left_out;
  std::optional<Guide> guide;
};

/// The pools of a surrogate: the same study, and on fewer elements; null where there is none.
struct Pools {
  const PoolData& fine;
  const PoolData* coarse = nullptr;
};

/// The same, and whoever has them.
struct ReadPools {
  PoolData fine;
  std::optional<PoolData> coarse;

  Pools all() const { return {fine, coarse ? &*coarse : nullptr}; }
};
/// From their folders; `with`: of other materials that were pressed alike. An empty name: there is none.
ReadPools read_pools(const std::filesystem::path& fine, const std::vector<std::string>& with,
                     const std::string& coarse = "");

/// Deterministic. InvalidInput where the pools do not belong together. Throws Interrupted.
Surrogate fit_surrogate(const Pools&);

/// What a surrogate says of a material that was pressed, beside the truth.
struct Errors {
  double force = 0, radius = 0;       ///< relative L2 over the loading
  std::vector<double> work, residual; ///< of each unloading
  std::vector<double> standardised;   ///< |ln F - ln F| over the standard deviation, at each knot
  double expected = 0;
  bool locks = false; ///< by what is said
};
/// How a material is left out. closed_form: components, lengths and so on as they are, made with it. anew:
/// those of the finest layer's force are made without a tenth of the materials at a time, so that they say
/// nothing of them; what the closed form thinks it knows is too good.
enum class Left { closed_form, anew };
/// Of each of the fine materials, left out of all layers in turn. The pools must be the surrogate's.
std::vector<Errors> leave_out(const Surrogate&, const Pools&, Left = Left::closed_form);
/// The same, each with its guide.
std::vector<Errors> leave_out_guided(const Surrogate&, const Pools&, Left = Left::closed_form);
/// Of each material of a pool that the surrogate was not made of, unloaded from the same overlaps.
std::vector<Errors> errors_beside(const Surrogate&, const PoolData&, bool guided = false);
/// The number of standard deviations that nine tenths of the errors at knots lie within.
double band_of(const std::vector<Errors>&);
LeaveOneOut summary_of(const std::vector<Errors>&, double band);

struct Prediction {
  std::vector<double> F_bar, a_bar; ///< at the knots
  std::vector<double> alpha, beta;  ///< of the unloadings
  std::vector<double> band;         ///< at each knot, half the 90 % band of ln F
  /// Relative L2 of F over the loading up to each knot, were it one standard deviation off.
  std::vector<double> expected;
};

/// Of a material of the surrogate's model; whether it may be believed is not asked here.
Prediction predict(const Surrogate&, const Description&, const CoarsePress* guide = nullptr);
/// The guide of a surrogate of two layers: a press of a second or two. ConvergenceError where it does not get
/// to the end.
CoarsePress press_guide(const Surrogate&, const material::Material&);
/// The input that stands for a material: coordinates over their ranges.
std::vector<double> input_of(const Surrogate&, const std::vector<double>& coordinates);

/// The file: text, one list a line.
std::string text_of(const Surrogate&);
/// InvalidInput for a file that is none, or of another version.
Surrogate read_surrogate(const std::filesystem::path&);
Surrogate parse_surrogate(std::string_view text, const std::string& file);

} // namespace platen::surrogate
