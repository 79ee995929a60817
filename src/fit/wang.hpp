#pragma once
// Fit of the law of Wang et al. (16)-(18) to the curve of a local press:
//   F/F_y = a omega^b,                      omega = delta/delta_y >= 1        (16)
//   F/F_y = m (omega - omega_res)^n         through the turning point         (17), (18)
// by least squares in F over delta. F_y and delta_y are Hertz's at first yield on the axis. delta is the
// Hertz-consistent one, with the far field of the finite sphere taken out: then an elastic sphere has
// a = m = 1 and b = n = 3/2.

#include "fit/first_yield.hpp"
#include "fit/law_card.hpp"
#include "fit/unloading.hpp"
#include "press/curve.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::fit {

/// How well a form follows the loading branch.
struct FormFit {
  std::string name;
  int parameters = 0;
  double r_squared = 0;
  double rmse = 0; ///< of F/F_y
};

struct WangUnloadingFit {
  double omega_max = 0; ///< where the branch leaves the loading curve
  double m = 0, n = 0;
  double delta_res_m = 0; ///< residual overlap, one sphere
  double r_squared = 0;
};

/// Points of the loading branch from first yield on, over the Hertz-consistent overlap. With as few
/// as a and b are, first yield itself is the third; fewer than `enough` are said.
std::size_t points_beyond(const press::Curve&, const FirstYield&);
inline constexpr std::size_t wang_fewest_points = 2, wang_enough_points = 8;

struct WangFit {
  double F_y_N = 0;
  double delta_y_m = 0; ///< of one sphere
  double a = 0, b = 0;
  double omega_max = 0;   ///< end of the fitted range, which begins at 1
  std::size_t points = 0; ///< in that range
  double r_squared = 0;
  double rmse = 0;             ///< of F/F_y
  std::vector<FormFit> others; ///< exponential, parabola, cubic polynomial (WG 4.1), as the points allow
  std::vector<WangUnloadingFit> unloading; ///< ascending in omega_max
  double m = 0, n = 0; ///< of all branches together, each weighed alike; 0 where there is none
  double unloading_r_squared = 0;
  std::vector<UnloadingFit> branches; ///< the same over the Hertz-consistent overlap, as they were fitted
  std::string caveat;                 ///< where the loading goes hardly beyond first yield; it is in the card
  std::vector<std::string> notes;     ///< the caveat, and branches that are too short

  double F_over_F_y(double omega) const;
};

/// The curve over delta with the far field of a finite sphere taken out, as the press says it, or by its
/// formula where the curve is a measured one.
press::Curve hertz_consistent(const press::Curve&);

/// Throws core::InvalidInput where the curve lacks E, nu, phi_deg or sigma_c, or has fewer than two points
/// beyond first yield.
WangFit fit_wang(const press::Curve&);

/// The law card: `fitted` with m and n of all branches together, `generic` where there is none.
LawCard law_card(const press::Curve&, const WangFit&, std::string_view curve_text);

} // namespace platen::fit
