// Unloading of the nine materials of Edmans & Sinka, section 6.3 (the base case and the eight corners of
// their parameter space, Fig. 2a), and of the usable powders of their Table 4: how well (13) follows it, and
// what it gives back. 1,000 elements, five branches each.

#include "core/catalogue.hpp"
#include "fit/unloading.hpp"
#include "material/card.hpp"
#include "press/press.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace platen;

namespace {

std::vector<material::Material> nine() {
  const material::Vmdc base{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7,
                            10,  7.5,   10,   10,  0.4,   1.5}; // ES Table 6
  std::vector<material::Material> materials = {{"base case", base}};
  for (const double E_bar : {3.0, 500.0})
    for (const double Gamma_bar : {0.25, 1.0})
      for (const double Lambda_bar : {0.01, 1.0}) {
        material::Vmdc corner = base;
        corner.E = E_bar * base.sigma_y;
        corner.Gamma = Gamma_bar * base.sigma_y;
        corner.Lambda = Lambda_bar * base.sigma_y;
        materials.push_back(
            {fmt::format("E_bar {}, Gamma_bar {}, Lambda_bar {}", E_bar, Gamma_bar, Lambda_bar), corner});
      }
  return materials;
}

std::vector<material::Material> powders() {
  std::vector<material::Material> materials;
  for (const auto& name :
       {"mcc-ph-200", "lactose-dt", "lactose-310-nf", "dical-fujicalin", "dical-emcompress"})
    materials.push_back(material::read_card(name).material);
  return materials;
}

/// Over the contact alone, as the law card says it; and from no overlap to the largest, the zeros after
/// separation counted, which (9) defines as well. ES do not say which of the two is theirs.
struct RSquared {
  double contact, whole;
};

/// The second from the first: the sum of squared residuals is the same, that about the mean is not.
RSquared r_squared(const press::Curve& curve, const fit::UnloadingFit& fit) {
  double length = 0, F_1 = 0, F_2 = 0;
  const press::CurvePoint* last = nullptr;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::unloading || point.branch_id != fit.branch_id) continue;
    if (last) {
      const double step = last->delta_bar - point.delta_bar;
      length += step;
      F_1 += step * (last->F_bar + point.F_bar) / 2;
      F_2 += step * (last->F_bar * last->F_bar + point.F_bar * point.F_bar) / 2;
    }
    last = &point;
  }
  const double left = (1 - fit.r_squared) * (F_2 - F_1 * F_1 / length);
  return {fit.r_squared, 1 - left / (F_2 - F_1 * F_1 / fit.delta_bar_max)};
}

/// Work given back by a branch over the energy stored where it starts.
double returned(const press::Curve& curve, int branch_id) {
  const press::CurvePoint *first = nullptr, *last = nullptr;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::unloading || point.branch_id != branch_id) continue;
    if (!first) first = &point;
    last = &point;
  }
  return (first->work_J - last->work_J) / first->stored_J;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Table {
  std::vector<RSquared> branches, ends; ///< all, and those from the end of each press
};

Table unloaded(const std::vector<material::Material>& materials) {
  Table table;
  for (const auto& material : materials) {
    press::Simple e;
    e.elements = 1000;
    e.unload_from = {0.1, 0.2, 0.3, 0.4};
    // Past 0.4 the force of this powder rises twentyfold, and between 0.45 and 0.5, with the mesh, the press
    // stops.
    if (material.name == "Dical Emcompress") e.delta_bar_max = 0.4;
    else e.unload_from.push_back(0.5);
    const auto result = press::press({material, 1e-3, e});
    EXPECT_FALSE(result.failure) << material.name << ": " << *result.failure;
    const auto unloading = fit::fit_unloading(result.curve);
    EXPECT_EQ(unloading.fits.size(), e.unload_from.size()) << material.name;
    std::printf("%s\n  delta_bar   alpha     beta   R2 in contact   from 0   work back/stored\n",
                material.name.c_str());
    for (const auto& fit : unloading.fits) {
      const RSquared r2 = r_squared(result.curve, fit);
      const double back = returned(result.curve, fit.branch_id);
      std::printf("  %9.1f  %6.3f  %7.3f  %14.6f %8.6f %10.4f\n", fit.delta_bar_max, fit.alpha, fit.beta,
                  r2.contact, r2.whole, back);
      EXPECT_LT(back, 1.002) << material.name << " from "
                             << fit.delta_bar_max; // work is integrated by trapezoids
      table.branches.push_back(r2);
      if (fit.delta_bar_max == 0.5) table.ends.push_back(r2);
    }
  }
  return table;
}

double least(const std::vector<RSquared>& list, double RSquared::*kind) {
  double result = 1;
  for (const auto& r2 : list) result = std::min(result, r2.*kind);
  return result;
}

double middle(const std::vector<RSquared>& list, double RSquared::*kind) {
  std::vector<double> values;
  for (const auto& r2 : list) values.push_back(r2.*kind);
  return median(values);
}

void print(const char* what, const std::vector<RSquared>& list) {
  std::printf("%s: R2 in contact: least %.6f, median %.6f; from 0: least %.6f, median %.6f\n", what,
              least(list, &RSquared::contact), middle(list, &RSquared::contact),
              least(list, &RSquared::whole), middle(list, &RSquared::whole));
}

} // namespace

TEST(Unloading, OfTheNineMaterialsFollowsThePowerLawAndReturnsNoMoreThanIsStored) {
  const Table table = unloaded(nine());
  print("nine materials, five branches each", table.branches);
  print("nine materials, from delta_bar = 0.5", table.ends);
  // ES section 6.3: least 0.998825, median 0.999948. From which overlap, and whether with the stretch below
  // delta_0, it does not say.
  EXPECT_GT(least(table.branches, &RSquared::whole), 0.9988);
  EXPECT_GT(middle(table.branches, &RSquared::whole), 0.999948);
  EXPECT_GT(least(table.ends, &RSquared::contact), 0.998825);
  EXPECT_GT(least(table.branches, &RSquared::contact), 0.996); // see docs/explanation/unloading.md
}

TEST(Unloading, OfThePowdersFollowsThePowerLawAndReturnsNoMoreThanIsStored) {
  const Table table = unloaded(powders());
  print("five powders, all branches", table.branches);
  print("four of them, from delta_bar = 0.5", table.ends);
  EXPECT_GT(least(table.branches, &RSquared::contact), 0.994);
  EXPECT_GT(least(table.branches, &RSquared::whole), 0.996);
}
