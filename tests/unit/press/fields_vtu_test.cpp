#include "press/fields_vtu.hpp"

#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

using namespace platen;

namespace {

constexpr double radius_m = 2e-3;

press::Result pressed(const material::Model& model, double delta_bar) {
  press::Simple e;
  e.elements = 100;
  e.delta_bar_max = delta_bar;
  e.fields_at = {delta_bar};
  return press::press({{"x", model}, radius_m, e});
}

/// The numbers of one array of the file.
std::vector<double> array(const std::string& vtu, const std::string& name) {
  const auto tag = vtu.find("Name=\"" + name + "\"");
  EXPECT_NE(tag, std::string::npos) << name;
  const auto start = vtu.find('>', tag) + 1;
  std::istringstream in(vtu.substr(start, vtu.find("</DataArray>", start) - start));
  std::vector<double> numbers;
  for (double number = 0; in >> number;) numbers.push_back(number);
  EXPECT_TRUE(in.eof()) << name << " holds something that is no number";
  return numbers;
}

void expect_near(const std::vector<double>& written, const std::vector<double>& meant, double relative) {
  ASSERT_EQ(written.size(), meant.size());
  double largest = 0;
  for (const double value : meant) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < meant.size(); ++i) ASSERT_NEAR(written[i], meant[i], relative * largest) << i;
}

const material::Vmdc granule{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7,
                             10,  7.5,   10,   10,  0.4,   1.5}; // ES Table 6

} // namespace

TEST(FieldsVtu, SayWhatTheSnapshotHolds) {
  const auto result = pressed(granule, 0.1);
  ASSERT_EQ(result.snapshots.size(), 1u);
  const auto& s = result.snapshots.front();
  const std::string vtu = press::fields_vtu(s, radius_m);
  EXPECT_EQ(array(vtu, "TimeValue"), std::vector{0.1});
  std::vector<double> points, displacements, corners, ends, types;
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    points.insert(points.end(), {s.nodes[i][0] * radius_m, s.nodes[i][1] * radius_m, 0});
    displacements.insert(displacements.end(),
                         {s.displacement[i][0] * radius_m, s.displacement[i][1] * radius_m, 0});
  }
  for (const auto& quad : s.elements) {
    corners.insert(corners.end(), quad.begin(), quad.end());
    ends.push_back(static_cast<double>(corners.size()));
    types.push_back(9); // VTK_QUAD
  }
  expect_near(array(vtu, "Points"), points, 1e-8);
  expect_near(array(vtu, "displacement_m"), displacements, 1e-8);
  EXPECT_EQ(array(vtu, "connectivity"), corners);
  EXPECT_EQ(array(vtu, "offsets"), ends);
  EXPECT_EQ(array(vtu, "types"), types);
  constexpr double seven_digits = 1e-6;
  constexpr std::array<const char*, 4> stresses = {"sigma_rr_Pa", "sigma_zz_Pa", "sigma_rz_Pa",
                                                   "sigma_tt_Pa"};
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> stress;
    for (const auto& sigma : s.stress) stress.push_back(sigma[k]);
    expect_near(array(vtu, stresses[k]), stress, seven_digits);
  }
  expect_near(array(vtu, "p_Pa"), s.p, seven_digits);
  expect_near(array(vtu, "q_Pa"), s.q, seven_digits);
  expect_near(array(vtu, "rho_r"), s.rho_r, seven_digits);
  expect_near(array(vtu, "phi"), s.phi, seven_digits);
  expect_near(array(vtu, "plastic_hencky_strain_v"), s.plastic_strain_v, seven_digits);
  expect_near(array(vtu, "plastic_hencky_strain_q"), s.plastic_strain_q, seven_digits);
  for (const double zone : array(vtu, "zone")) EXPECT_TRUE(zone == 0 || zone == 1 || zone == 2 || zone == 3);
}

TEST(FieldsVtu, HaveTheZoneOfMostGaussPoints) {
  using enum press::Zone;
  press::Snapshot s;
  s.zones = {{elastic, shear, shear, tension},
             {elastic, elastic, elastic, tension},
             {elastic, elastic, shear, shear}};
  EXPECT_EQ(array(press::fields_vtu(s, 1), "zone"), (std::vector{1., 0., 1.}));
}

TEST(FieldsVtu, AreNamedByTheirOverlap) {
  press::Snapshot s;
  s.delta_bar = 0.1;
  EXPECT_EQ(press::fields_name(s.delta_bar), "fields-0.1.vtu");
  EXPECT_NE(press::fields_series(std::vector{s})
                .find("<DataSet timestep=\"0.1\" part=\"0\" file=\"fields-0.1.vtu\"/>"),
            std::string::npos);
}

TEST(Snapshot, LosesPlasticVolumeWhereDensityGrows) {
  // rho_r = rho_r0 exp(-eps_v^p) of the volumetric plastic strain (ES eq. 3a): C_p^-1 and phi must agree.
  const auto result = pressed(granule, 0.1);
  const auto& s = result.snapshots.front();
  for (std::size_t e = 0; e < s.elements.size(); ++e)
    ASSERT_NEAR(s.plastic_strain_v[e], -s.phi[e], 1e-9) << e;
}

TEST(Snapshot, HasNoPlasticStrainInAnElasticSphere) {
  const auto result = pressed(material::Elastic{1e9, 0.3}, 0.02);
  const auto& s = result.snapshots.front();
  for (std::size_t e = 0; e < s.elements.size(); ++e) {
    ASSERT_NEAR(s.plastic_strain_v[e], 0, 1e-13);
    ASSERT_NEAR(s.plastic_strain_q[e], 0, 1e-13);
  }
}

TEST(Snapshot, ShearsAMetalWithoutChangeOfVolume) {
  // The strain of the shape reached is at most the strain accumulated on the way.
  const auto result = pressed(material::VonMises{100e6, 0.3, 1e6}, 0.2);
  const auto& s = result.snapshots.front();
  double largest = 0;
  for (std::size_t e = 0; e < s.elements.size(); ++e) {
    ASSERT_NEAR(s.plastic_strain_v[e], 0, 1e-12);
    ASSERT_LE(s.plastic_strain_q[e], s.phi[e] * (1 + 1e-3) + 1e-9);
    largest = std::max(largest, s.plastic_strain_q[e]);
  }
  EXPECT_GT(largest, 0.1);
}
