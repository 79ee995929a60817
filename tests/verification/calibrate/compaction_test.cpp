// A powder that is known, led through a die as a material point, comes back from its stresses and from the
// strengths that its own surface has.

#include "calibrate/compaction.hpp"
#include "core/error.hpp"
#include "material/card.hpp"
#include "material/point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace platen;

/// An excipient of the usual size: tests/data/measured/s11_excipient_cap.inp, as vmdc.
material::Material excipient() {
  return material::read_card(
             core::parse_toml("platen = 1\nname = \"excipient\"\nmodel = \"vmdc\"\n[parameters]\n"
                              "rho_r0 = 0.45\nsigma_y_Pa = 9e6\nE_Pa = 520e6\nnu = 0.12\nGamma_Pa = "
                              "7.2e6\nLambda_Pa = 1.1e6\nepsilon = 0.42\neta = 6.4\nxi = 5.1\nzeta = "
                              "5.6\nomega = 6\nxi_1 = 0.35\nxi_2 = 0.5\n",
                              "excipient"))
      .material;
}

/// To each density in turn, each followed by an unloading to 0.65 of the axial stress.
std::vector<calibrate::CompactionRow> die_test(const material::Model& model, double rho_r0,
                                               const std::vector<double>& to, double noise,
                                               std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<calibrate::CompactionRow> rows;
  material::MaterialPoint point;
  const auto step = [&](double by) {
    point = strained(model, point, {by, 0, 0});
    ASSERT_FALSE(material::is_refused(point.last.status));
  };
  const auto row = [&] {
    const double rho = rho_r0 * std::exp(-(point.total[0] + point.total[1] + point.total[2]));
    const double a = -point.last.sigma[0], r = -point.last.sigma[1];
    rows.push_back({rho, a * (1 + noise * normal(random)), r * (1 + noise * normal(random))});
  };
  for (const double rho : to) {
    const double end = -std::log(rho / rho_r0);
    while (point.total[0] > end) step(-1e-3), row();
    const auto loaded = point;
    const double peak = -point.last.sigma[0];
    double by = 2e-5;
    for (int i = 0; i < 400 && -point.last.sigma[0] > 0.65 * peak; ++i) step(by), row();
    point = loaded; // and on along the loading
  }
  return rows;
}

/// Of the line of shear failure of dpc: q = d + p tan beta through (0 at p = -Lambda) and (Gamma at pi_3).
std::vector<calibrate::StrengthRow> tablets(const material::Porous& m, double low, double high) {
  std::vector<calibrate::StrengthRow> rows;
  for (const double rho : {low, (low + high) / 2, high}) {
    const auto s = m.strengths(std::log(rho / m.rho_r0));
    const double tangent = s.Gamma / (s.Lambda + s.pi_3), d = s.Lambda * tangent;
    rows.push_back({rho, d / (1 - tangent / 3), d / (std::sqrt(13.0) - 2 * tangent / 3)});
  }
  return rows;
}

double relative(const calibrate::Trend& t, double expected, double growth, double rho_r0, double rho) {
  const double truth =
      t.exponential ? expected * std::exp(growth * (rho - rho_r0)) : expected + growth * (rho - rho_r0);
  return std::abs(t.at(rho, rho_r0) / truth - 1);
}

const calibrate::Trend& of(const calibrate::Compaction& c, const std::string& key) {
  return *std::find_if(c.trends.begin(), c.trends.end(), [&](const auto& t) { return t.key == key; });
}

/// How much denser tablets can be made whose strengths lie on its surface: beyond, the line of shear failure
/// is steeper than uniaxial compression.
double span_of(const material::Porous& m) {
  double span = 0.4;
  const auto steep = [&] {
    const auto s = m.strengths(std::log((m.rho_r0 + span) / m.rho_r0));
    return s.Gamma > 2.5 * (s.Lambda + s.pi_3);
  };
  while (steep()) span -= 0.05;
  return span;
}

struct Bounds {
  double flow, shear, tension, cap; ///< sigma_y, E, nu and stresses; Gamma; Lambda; epsilon
};
void expect_back(const material::Material& material, double noise, const Bounds& within) {
  SCOPED_TRACE(material.name);
  const auto m = std::get<material::Vmdc>(material.model);
  const double first = m.rho_r0, span = span_of(m);
  ASSERT_GT(span, 0.08);
  const auto c = calibrate::compaction(
      die_test(material.model, first,
               {first + span / 4, first + span / 2, first + 3 * span / 4, first + span}, noise, 3),
      tablets(m, first + span / 8, first + span), first, "vmdc", "powder");
  for (const double rho : {first + span / 8, first + 3 * span / 4}) { // where it was measured
    EXPECT_LT(relative(of(c, "sigma_y_Pa"), m.sigma_y, m.eta, m.rho_r0, rho), within.flow) << rho;
    EXPECT_LT(relative(of(c, "E_Pa"), m.E, m.xi, m.rho_r0, rho), within.flow) << rho;
    EXPECT_LT(relative(of(c, "Gamma_Pa"), m.Gamma, m.zeta, m.rho_r0, rho), within.shear) << rho;
    EXPECT_LT(relative(of(c, "Lambda_Pa"), m.Lambda, m.omega, m.rho_r0, rho), within.tension) << rho;
    EXPECT_LT(std::abs(of(c, "nu").at(rho, m.rho_r0) - (m.nu + m.xi_1 * (rho - m.rho_r0))), within.flow)
        << rho;
    EXPECT_LT(std::abs(of(c, "epsilon").at(rho, m.rho_r0) - (m.epsilon + m.xi_2 * (rho - m.rho_r0))),
              within.cap)
        << rho;
  }
  EXPECT_LT(c.axial_l2, within.flow);
  EXPECT_LT(c.radial_l2, within.flow);
  EXPECT_EQ(c.unloadings, 4);
}

TEST(Compaction, OfAKnownPowderComesBack) { expect_back(excipient(), 0, {0.03, 0.06, 0.06, 0.03}); }
TEST(Compaction, OfANoisyTestComesBack) { expect_back(excipient(), 0.005, {0.08, 0.16, 0.16, 0.08}); }
// Of the others of Table 4, Lactose 310 NF and Dical Emcompress, no tablet has strengths on their surface: it
// is too steep.
TEST(Compaction, OfThePowdersOfEdmansAndSinkaComesBack) {
  for (const char* name : {"mcc-ph-200", "lactose-dt", "dical-fujicalin"})
    expect_back(material::read_card(name).material, 0, {0.03, 0.08, 0.2, 0.1});
}

TEST(Compaction, SaysWhatItCannotSee) {
  const auto material = excipient();
  const auto m = std::get<material::Vmdc>(material.model);
  const auto rows = die_test(material.model, m.rho_r0, {0.6}, 0, 1);
  const auto strengths = tablets(m, 0.5, 0.6);
  const auto refused = [&](auto rows_, auto strengths_) -> std::string {
    try {
      (void)calibrate::compaction(rows_, strengths_, 0.45, "vmdc", "powder");
    } catch (const core::InvalidInput& error) { return error.what(); }
    return "taken";
  };
  EXPECT_NE(calibrate::compaction(rows, strengths, 0.45, "dpc", "powder").said.front().find("one unloading"),
            std::string::npos);
  EXPECT_NE(refused(rows, std::vector{strengths.front()}).find("two densities"), std::string::npos);
  auto swapped = strengths;
  for (auto& s : swapped) std::swap(s.compressive_Pa, s.tensile_Pa);
  EXPECT_NE(refused(rows, swapped).find("are the columns right"), std::string::npos);
  auto loading = rows;
  std::erase_if(loading,
                [most = 0.0](const auto& r) mutable { return r.rho_r <= most || (most = r.rho_r, false); });
  EXPECT_NE(refused(loading, strengths).find("no row unloads"), std::string::npos);
  auto pascals = strengths; // MPa taken for Pa
  for (auto& s : pascals) s.compressive_Pa *= 1e6, s.tensile_Pa *= 1e6;
  EXPECT_NE(refused(rows, pascals).find("the same unit"), std::string::npos);
}

} // namespace
