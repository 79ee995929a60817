#pragma once
// Snapshots made from formulas, for the tests of pictures.

#include "press/press.hpp"

#include <cmath>
#include <functional>

namespace platen::test {

/// n x n elements over a quarter disc, flattened to the plane at 1 - delta_bar; zones as told by (r, z).
inline press::Snapshot quarter_disc(int n, double delta_bar,
                                    const std::function<press::Zone(double r, double z)>& zone_at) {
  press::Snapshot snapshot;
  snapshot.delta_bar = delta_bar;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double u = double(i) / n, v = double(j) / n;
      const double r = u * std::sqrt(1 - v * v / 2), z = v * std::sqrt(1 - u * u / 2);
      snapshot.nodes.push_back({r * (1 + 0.3 * delta_bar * (1 - z * z)), z * (1 - delta_bar)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int corner = j * (n + 1) + i;
      snapshot.elements.push_back({corner, corner + 1, corner + n + 2, corner + n + 1});
      const auto centre = [&](double du, double dv) { return zone_at((i + du) / n, (j + dv) / n); };
      snapshot.zones.push_back({centre(.25, .25), centre(.75, .25), centre(.75, .75), centre(.25, .75)});
      snapshot.rho_r.push_back(0.7 + 0.2 * delta_bar * (j + 0.5) / n);
      snapshot.p.push_back(-1e8 * j / n);
      snapshot.q.push_back(1e8 * i / n);
      snapshot.phi.push_back(0);
      snapshot.stress.push_back({});
    }
  return snapshot;
}

} // namespace platen::test
