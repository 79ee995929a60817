#include "plot/fit_picture.hpp"

#include "plot/curve_picture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::plot {

void fit_picture(const press::Curve& curve, const fit::FittedLaw& law, const std::filesystem::path& file) {
  constexpr int intervals = 400;
  std::vector<double> delta_bar(intervals + 1);
  for (int i = 0; i <= intervals; ++i) delta_bar[i] = law.loading.delta_bar_max * i / intervals;
  curve_with_law(curve, delta_bar, law.loading.F_bar(delta_bar),
                 fmt::format("edmans-sinka, {}", fit::name_of(law.loading.variant)), file,
                 law.unloading.fits);
}

void fit_picture(const press::Curve& pressed, const fit::WangFit& f, const std::filesystem::path& file) {
  constexpr int intervals = 400;
  const press::Curve curve = fit::hertz_consistent(pressed);
  const double x_y = f.delta_y_m / curve.radius_m;
  const double F_bar_y = f.F_y_N / (std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa);
  std::vector<double> delta_bar, F_bar;
  for (int i = 0; i <= intervals; ++i) {
    const double omega = 1 + (f.omega_max - 1) * i / intervals;
    delta_bar.push_back(omega * x_y);
    F_bar.push_back(F_bar_y * f.F_over_F_y(omega));
  }
  // One m and n for all branches, as the card has it.
  std::vector<fit::UnloadingFit> branches = f.branches;
  for (auto& branch : branches) {
    branch.alpha = f.n;
    branch.delta_bar_0 = branch.delta_bar_max - x_y * std::pow(branch.F_bar_max / F_bar_y / f.m, 1 / f.n);
  }
  curve_with_law(curve, delta_bar, F_bar, "wang", file, branches);
}

} // namespace platen::plot
