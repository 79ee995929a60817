#include "material/yield_curve.hpp"

#include <algorithm>

namespace platen::material {

std::vector<YieldCurve> yield_curves(const Model& model, double phi, double p_low, double p_high) {
  constexpr int points = 200;
  return std::visit(
      [&]<class M>(const M& m) -> std::vector<YieldCurve> {
        if constexpr (PrincipalModel<M>)
          if (!in_invariants(m)) return m.meridians(p_low);
        if constexpr (InvariantModel<M>) {
          const auto surface = m.surface(phi);
          std::array stretch{surface.s_min(), surface.s_max()};
          if constexpr (requires { surface.drawn(p_low, p_high); }) stretch = surface.drawn(p_low, p_high);
          YieldCurve curve;
          for (int i = 0; i <= points; ++i) {
            const SurfacePoint f = surface.at(stretch[0] + (stretch[1] - stretch[0]) * i / points);
            curve.p_q.push_back({f.p, std::max(f.q, 0.0)});
          }
          return {curve};
        } else return {};
      },
      model);
}

} // namespace platen::material
