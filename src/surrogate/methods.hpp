#pragma once
// Ways to predict a granule of Edmans & Sinka's design from the others, side by side: what their paper does,
// what it could have done, and what the surrogate does.

#include "surrogate/surrogate.hpp"

#include <string>
#include <vector>

namespace platen::surrogate {

/// A closed form that was fitted to all: its terms and their coefficients.
struct ClosedForm {
  std::string of;
  std::vector<std::string> terms;
  std::vector<double> coefficients;
};

struct Method {
  std::string name;
  int materials = 0; ///< that it could predict
  Quantiles force;   ///< relative L2 of F over the loading; zeros where it is the press's
  Quantiles work;    ///< given back in unloading; zeros where it says nothing of it
  Quantiles residual;
};

struct Methods {
  std::vector<Method> loading, unloading;
  std::vector<ClosedForm> forms; ///< of alpha and beta
};

/// Of the granules with E_bar of 4.5 and more, for which Appendix A is meant; each without itself wherever
/// something is fitted to others. `s`: the surrogate of the pools in `data`. InvalidInput where these are no
/// granules of which one to four numbers vary.
Methods methods_side_by_side(const Surrogate& s, const PoolData& data);

} // namespace platen::surrogate
