#pragma once
// What the layers of a surrogate say of a material, in logarithms, and how far that is from the truth.

#include "surrogate/surrogate.hpp"

#include <vector>

namespace platen::surrogate {

/// Logarithms, as the components hold them.
struct Said {
  std::vector<double> F, F_variance, a, unloading;
};

/// Adds to a sum, which may be empty still.
void add(std::vector<double>& sum, const std::vector<double>& more);

std::vector<double> logarithms(std::vector<double> values);
std::vector<double> exponentials(const std::vector<double>& values, std::size_t from, std::size_t count);

Said said_of(const Surrogate& s, const Description& d, const Loading* guide);
/// Of each fine material, left out of all layers; `which`: their numbers in the fine pool.
std::vector<Said> said_left_out(const Surrogate&, const Pools&, std::vector<std::size_t>* which = nullptr);
Errors errors_of(const PoolData& data, const Pressed& run, const Said& said);

/// Relative L2, up to each overlap, of a curve whose logarithm has these variances.
std::vector<double> expected_errors(const std::vector<double>& x, const std::vector<double>& F,
                                    const std::vector<double>& variance);

} // namespace platen::surrogate
