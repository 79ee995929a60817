#pragma once
// One law over many contacts: what a DEM code calls between its neighbour list and its force sum, and what
// the C interface offers to codes that cannot inline a law. It is a convenience, not faster than the loop a
// C++ host writes itself: regimes and table cells differ from contact to contact, so nothing vectorises.

#include "platen/law/contact.hpp"

#include <cstddef>
#include <span>

namespace platen::law {

/// Advances `state` in place; `force` and `stiffness` have the size of `overlap`, `stiffness` may be empty.
template <ContactLaw Law>
PLATEN_FUNCTION void evaluate_all(const Law& law, std::span<const typename Law::Scalar> overlap,
                                  std::span<BasicState<typename Law::Scalar>> state,
                                  std::span<typename Law::Scalar> force,
                                  std::span<typename Law::Scalar> stiffness = {}) {
  const bool with_stiffness = !stiffness.empty();
  for (std::size_t i = 0; i < overlap.size(); ++i) {
    const auto now = evaluate(law, state[i], overlap[i]);
    state[i] = now.state;
    force[i] = now.force;
    if (with_stiffness) stiffness[i] = now.stiffness;
  }
}

} // namespace platen::law
