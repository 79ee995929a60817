#pragma once
// What a data pool says of each of its materials, as the numbers that are interpolated.

#include "surrogate/description.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::surrogate {

/// A branch as it was pressed: ascending in delta_bar.
struct PressedBranch {
  std::vector<double> delta_bar, F_bar;
  void push_front(double x, double F) {
    delta_bar.insert(delta_bar.begin(), x), F_bar.insert(F_bar.begin(), F);
  }
};

/// Work that a branch gives back, over pi R0^3 sigma_ref.
double work_along(const PressedBranch&);
/// Its logarithm, over the overlap at which Hertz carries F_bar = 1.
double returned_of(const PressedBranch&, const Description&);
/// A material that was pressed to the end.
struct Pressed {
  std::string pool;
  int run = 0; ///< number in its runs.csv
  material::Material material;
  Description description;
  std::vector<double> F_bar, a_bar;          ///< at the knots
  std::vector<double> alpha, beta, residual; ///< of each unloading; residual: overlap at separation
  std::vector<double> returned;              ///< returned_of() of each
  std::vector<PressedBranch> branches;       ///< what was fitted
};

struct PoolData {
  std::string name; ///< of the folder
  int engine = 0;
  int elements = 0;      ///< asked for
  double step_max = 0;   ///< of delta/R0
  std::size_t asked = 0; ///< runs of its study
  /// Done, with a branch that is too steep for alpha and beta to be fitted, or that the press could not
  /// follow (early_end).
  std::size_t not_unloaded = 0;
  std::size_t locked = 0;                      ///< done, and left aside because they lock
  std::vector<double> knots, unload_delta_bar; ///< delta/R0
  std::vector<Pressed> runs;                   ///< those that are done
};

/// Whether the force of a curve grows more than so many times from delta/R0 = 0.3 to its end: the contact has
/// compacted to solid there, and how much depends on the mesh (docs/explanation/predict.md).
bool grows(double times, const std::vector<double>& knots, const std::vector<double>& F_bar);
/// A material of which that is said is outside of any pool.
constexpr double locked_growth = 5;

/// An unloading that ends above this share of its force is not one to be fitted.
constexpr double early_end = 0.1;

/// usable: without those that lock by far (eightfold), which would spoil the others; what is between tells
/// which lock. And without those of which a branch ends early.
enum class Take { usable, all };

/// InvalidInput where the pool has no curve, was pressed by several engines, or differs from run to run in
/// where it loads to and unloads from.
PoolData read_pool_data(const std::filesystem::path& folder, Take = Take::usable);

/// Adds the runs of a pool of other materials, pressed alike. InvalidInput where they were not.
void append(PoolData& data, const PoolData& more);

} // namespace platen::surrogate
