#pragma once
// The runs of pools as tables of logarithms, and what they change from pool to pool.

#include "surrogate/components.hpp"
#include "surrogate/pool_data.hpp"

#include <vector>

namespace platen::surrogate {

/// A row a run: ln F_bar, ln a_bar at the knots, without ripples; of each unloading over_force() and
/// ln alpha.
struct Tables {
  Table force, radius, work, exponent;
};
Tables tables_of(const PoolData& data);

/// A fine run and the coarse one of the same material.
struct Both {
  std::size_t fine, coarse;
};
/// InvalidInput where the pools do not belong together, or have too few in common.
std::vector<Both> in_both(const PoolData& fine, const PoolData& coarse);

/// What the logarithms change from coarse to fine; of force and work over scatter_of() of the coarse curve.
Tables change(const Tables& fine, const Tables& coarse, const std::vector<Both>& both,
              const std::vector<double>& knots);

} // namespace platen::surrogate
