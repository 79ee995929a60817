#pragma once
// What the layers of a surrogate say of a material, in logarithms, and how far that is from the truth.

#include "surrogate/surrogate.hpp"

#include <vector>

namespace platen::surrogate {

/// Logarithms, as the components hold them.
struct Said {
  std::vector<double> F, F_variance, a;
  std::vector<double> work, exponent; ///< of each unloading: over_force(), ln alpha
  double scatter = 1;                 ///< of what changes from coarse to fine: scatter_of()
};

/// How much more than a soft granule's the change from coarse to fine scatters: (g/1.6)^1.5 and between 1 and
/// 8, where ln F grows by ln g from delta/R0 = 0.3 to the end. Of powders ln F_fine/F_coarse at 0.5 has a
/// standard deviation of 1.3, 2.6, 5.6 and 9.5 % for g from 1, 2, 3 and 4 on. Changes of force and of work
/// given back are interpolated over it, so that a material near the lock does not disturb those far from it.
double scatter_of(const std::vector<double>& knots, const std::vector<double>& ln_F);

/// Adds to a sum, which may be empty still.
void add(std::vector<double>& sum, const std::vector<double>& more, double factor = 1);

/// Overlap delta/R0 at which Hertz carries a force over pi R0^2 sigma_ref: Edmans & Sinka (12).
double hertz_overlap(double F_bar, const Description&);
/// What returned_of() says of all unloadings, over force and Hertz's overlap where they begin, 1/(beta (1 +
/// alpha)) of the form (13). This is what is interpolated: fits of alpha and beta miss the work by 0.4 % (one
/// in twenty by 2 %), and lean on each other. ln_F at the knots: without ripples, since the work has none.
std::vector<double> over_force(std::vector<double> returned, const std::vector<double>& unload_delta_bar,
                               const std::vector<double>& knots, const std::vector<double>& ln_F);
/// Logarithms at the knots, at an overlap: a straight line over its logarithm between two of them.
double at_overlap(double delta_bar, const std::vector<double>& knots, const std::vector<double>& values);
/// Where an overlap stands among the knots.
std::size_t knot_of(const std::vector<double>& knots, double delta_bar);

/// alpha and beta whose work is that, 1/(beta (1 + alpha)).
struct AlphaBeta {
  std::vector<double> alpha, beta;
};
AlphaBeta alpha_beta(const std::vector<double>& work, const std::vector<double>& exponent);

std::vector<double> logarithms(std::vector<double> values);
std::vector<double> exponentials(const std::vector<double>& values, std::size_t from, std::size_t count);

/// variances: of the force too, which takes a hundred times as long; force_and_work: of force and work alone.
enum class Want { force_and_work, means, variances };
/// At an input (input_of()).
Said said_at(const Surrogate& s, const std::vector<double>& at, const CoarsePress* guide = nullptr,
             Want want = Want::means);
Said said_of(const Surrogate& s, const Description& d, const CoarsePress* guide);
/// Of each fine material, left out of all layers; `which`: their numbers in the fine pool.
std::vector<Said> said_left_out(const Surrogate&, const Pools&, std::vector<std::size_t>* which = nullptr,
                                Left = Left::closed_form);
Errors errors_of(const PoolData& data, const Pressed& run, const Said& said);

/// Relative L2, up to each overlap, of a curve whose logarithm has these variances.
std::vector<double> expected_errors(const std::vector<double>& x, const std::vector<double>& F,
                                    const std::vector<double>& variance);

} // namespace platen::surrogate
