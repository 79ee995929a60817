#pragma once
// What the layers of a surrogate say of a material, in logarithms, and how far that is from the truth.

#include "surrogate/surrogate.hpp"

#include <vector>

namespace platen::surrogate {

/// Logarithms, as the components hold them.
struct Said {
  std::vector<double> F, F_variance, a;
  std::vector<double> work, exponent; ///< of each unloading: work_of(), ln alpha
};

/// Adds to a sum, which may be empty still.
void add(std::vector<double>& sum, const std::vector<double>& more);

/// Logarithm of the work that an unloading gives back, over its largest force and the overlap at which Hertz
/// carries that: 1/(beta (1 + alpha)). What is interpolated: fits of alpha and beta lean on each other, and
/// where they are off together the work is not.
double work_of(double alpha, double beta);
/// alpha and beta of it.
struct AlphaBeta {
  std::vector<double> alpha, beta;
};
AlphaBeta alpha_beta(const std::vector<double>& work, const std::vector<double>& exponent);

std::vector<double> logarithms(std::vector<double> values);
std::vector<double> exponentials(const std::vector<double>& values, std::size_t from, std::size_t count);

Said said_of(const Surrogate& s, const Description& d, const Loading* guide);
/// Of each fine material, left out of all layers; `which`: their numbers in the fine pool.
std::vector<Said> said_left_out(const Surrogate&, const Pools&, std::vector<std::size_t>* which = nullptr,
                                Left = Left::closed_form);
Errors errors_of(const PoolData& data, const Pressed& run, const Said& said);

/// Relative L2, up to each overlap, of a curve whose logarithm has these variances.
std::vector<double> expected_errors(const std::vector<double>& x, const std::vector<double>& F,
                                    const std::vector<double>& variance);

} // namespace platen::surrogate
