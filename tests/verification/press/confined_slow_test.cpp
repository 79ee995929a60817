// The press in space against the axisymmetric one, closed forms, finer meshes, and the published laws.

#include "press/press.hpp"

#include "material/models.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace platen;

namespace {

template <class X> press::Case case_of(const material::Model& model, double delta_bar_max, int elements) {
  X e;
  e.delta_bar_max = delta_bar_max;
  e.elements = elements;
  return {{"ball", model, {}}, 1, e};
}

double at(const press::Curve& curve, double delta_bar, double press::CurvePoint::*what) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const auto &a = curve.points[i - 1], &b = curve.points[i];
    if (b.delta_bar >= delta_bar)
      return a.*what + (b.*what - a.*what) * (delta_bar - a.delta_bar) / (b.delta_bar - a.delta_bar);
  }
  return curve.points.back().*what;
}

const material::VonMises metal{100, 0.3, 1};

} // namespace

TEST(ConfinedPress, SimpleOnTheWedgeIsTheAxisymmetricPress) {
  const auto c = case_of<press::Simple>(metal, 0.45, 5000);
  const auto wedge = press::press_in_space(c);
  const auto flat = press::press(c);
  ASSERT_FALSE(wedge.failure || flat.failure);
  double beyond = 0;
  int points = 0;
  for (double x = 0.05; x < 0.451; x += 0.025) {
    const double F = at(wedge.curve, x, &press::CurvePoint::force_N) /
                     at(flat.curve, x, &press::CurvePoint::force_N),
                 a = at(wedge.curve, x, &press::CurvePoint::contact_radius_m) /
                     at(flat.curve, x, &press::CurvePoint::contact_radius_m);
    RecordProperty("x_" + std::to_string(x).substr(0, 5), std::to_string(F) + " " + std::to_string(a));
    // Where the side of the sphere folds onto the plane it does so face by face: the force waves, by 1.5 %
    // with 5,000 elements, 1.1 % with 10,000, and the radius is too small by half a face.
    EXPECT_NEAR(F, 1, x < 0.36 ? 0.01 : 0.015) << x;
    EXPECT_NEAR(a, 1, x < 0.26 ? 0.03 : 0.045) << x;
    if (x > 0.29) beyond += F, ++points;
  }
  EXPECT_NEAR(beyond / points, 1, 0.005);
}

TEST(ConfinedPress, SmallElasticContactsAreHertzs) {
  const auto result = press::press(case_of<press::Hydrostatic>(material::Elastic{100, 0.3}, 0.012, 5000));
  ASSERT_FALSE(result.failure);
  // F/F_Hertz = intercept + c sqrt(delta_bar)
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& p : result.curve.points) {
    if (p.delta_bar < 0.002) continue;
    const double s = std::sqrt(p.delta_bar);
    const double ratio = p.force_N / (4.0 / 3 * 100 / (1 - 0.09) * std::pow(p.delta_bar, 1.5));
    n += 1, x += s, y += ratio, xx += s * s, xy += s * ratio;
  }
  const double slope = (n * xy - x * y) / (n * xx - x * x), intercept = (y - slope * x) / n;
  RecordProperty("intercept", std::to_string(intercept));
  EXPECT_NEAR(intercept, 1, 0.02);
  EXPECT_GT(slope, 1); // six contacts stiffen each other more than two
}

TEST(ConfinedPress, BeyondZeroPorosityTheCellIsAsStiffAsTheMaterial) {
  // Mean Kirchhoff stress over the particle's volume, tau = p V/V_0, with p the mean stress of the cell; the
  // material has tau_m = K ln J. On 1,300 elements the cell of the die is 4 % too stiff, on 2,600 2 %.
  const double K = 100 / (3 * 0.4);
  for (const std::string experiment : {"hydrostatic", "die"}) {
    const bool die = experiment == "die";
    const auto result = press::press(die ? case_of<press::Die>(metal, 0.5287, 2600)
                                         : case_of<press::Hydrostatic>(metal, 0.2218, 2600));
    ASSERT_FALSE(result.failure);
    const std::array<double, 5> volumes{1, 0.975, 0.95, 0.925, 0.901};
    std::vector<double> stress;
    double last_V = 0, last_tau = 0;
    for (const auto& p : result.curve.points) {
      const double z = 1 - p.delta_bar, x = die ? 1 : z;
      const double V = 8 * x * x * z / (4 * std::numbers::pi / 3);
      const double tau = V * (p.force_N / (4 * x * x) + 2 * p.side[0].force_N / (4 * x * z)) / 3;
      while (stress.size() < volumes.size() && V <= volumes[stress.size()])
        stress.push_back(last_tau + (tau - last_tau) * (last_V - volumes[stress.size()]) / (last_V - V));
      last_V = V;
      last_tau = tau;
    }
    ASSERT_EQ(stress.size(), volumes.size());
    double slope = 0; // over K
    for (std::size_t i = 1; i < stress.size(); ++i) {
      const double next = (stress[i] - stress[i - 1]) / std::log(volumes[i - 1] / volumes[i]) / K;
      RecordProperty(experiment + std::to_string(volumes[i]).substr(0, 5), std::to_string(next));
      EXPECT_GT(next, slope - 0.01) << volumes[i]; // up to the scatter of the steps
      slope = next;
    }
    EXPECT_NEAR(slope, 1, 0.03) << experiment;
    EXPECT_GT(result.curve.points.back().mesh_quality, 0.05) << experiment;
  }
}

TEST(ConfinedPress, DefaultMeshIsNearTheLimitOfThree) {
  // The limit of 1,300, 2,600 and 5,000 hexahedra, in least squares linear in N^(-2/3), the square of an
  // edge.
  const auto limit_error = [](const std::array<double, 3>& value) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const std::array<double, 3> elements{1300, 2600, 5000};
    for (int i = 0; i < 3; ++i) {
      const double x = std::pow(elements[i], -2.0 / 3);
      sx += x, sy += value[i], sxx += x * x, sxy += x * value[i];
    }
    const double slope = (3 * sxy - sx * sy) / (3 * sxx - sx * sx);
    return value[2] / ((sy - slope * sx) / 3) - 1;
  };
  struct Range {
    const char* experiment;
    bool die;
    double first, last, step, force, radius;
  };
  // In a die scallops take single points further: the smoothed curve is within 1.4 % and 1.8 %.
  for (const Range& range : {Range{"hydrostatic", false, 0.05, 0.186, 0.015, 0.02, 0.03},
                             Range{"die", true, 0.05, 0.451, 0.05, 0.025, 0.045}}) {
    std::array<press::Curve, 3> curves;
    int i = 0;
    for (const int elements : {1300, 2600, 5000}) {
      auto result = press::press(range.die ? case_of<press::Die>(metal, range.last, elements)
                                           : case_of<press::Hydrostatic>(metal, range.last, elements));
      ASSERT_FALSE(result.failure);
      for (const auto& p : result.curve.points) {
        if (p.delta_bar < 0.02) continue;
        const double balance = elements == 5000 ? 0.003 : elements == 2600 ? 0.006 : 0.012;
        EXPECT_NEAR(p.stored_J + p.dissipated_J, p.work_J, balance * p.work_J)
            << range.experiment << ' ' << elements << ' ' << p.delta_bar;
      }
      curves[i++] = std::move(result.curve);
    }
    for (double x = range.first; x < range.last; x += range.step) {
      const auto error = [&](double press::CurvePoint::*what) {
        return limit_error({at(curves[0], x, what), at(curves[1], x, what), at(curves[2], x, what)});
      };
      const double F = error(&press::CurvePoint::force_N), a = error(&press::CurvePoint::contact_radius_m);
      RecordProperty(range.experiment + std::to_string(x).substr(0, 5),
                     std::to_string(F) + " " + std::to_string(a));
      EXPECT_LT(std::abs(F), range.force) << range.experiment << ' ' << x;
      EXPECT_LT(std::abs(a), range.radius) << range.experiment << ' ' << x;
    }
  }
}

TEST(ConfinedPress, PorousGranulesGetDenser) {
  // MCC PH-200, porosity 60 %: in a die it compacts where a metal would be full.
  const material::Model granule =
      material::Vmdc{0.4, 8.61, 441.7, 0.1472, 11.63, 0.857, 0.147, 6.11, 5.25, 5.43, 6.28, 0.443, 2.007};
  const auto result = press::press(case_of<press::Die>(granule, 0.4764, 600));
  ASSERT_FALSE(result.failure) << *result.failure;
  const auto& end = result.curve.points.back();
  EXPECT_GT(end.rho_r_mean, 0.42);
  EXPECT_NEAR((end.stored_J + end.dissipated_J) / end.work_J, 1, 0.003);
}
