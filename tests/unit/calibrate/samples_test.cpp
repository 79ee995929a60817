#include "calibrate/free_parameters.hpp"
#include "calibrate/samples.hpp"
#include "core/error.hpp"
#include "fit/law_card.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen;
using measure::Stage;

calibrate::Samples loading_and_unloading(double R) {
  calibrate::Samples s;
  s.radius_m = R;
  for (int i = 0; i <= 60; ++i) {
    const double delta = 0.2 * R * (i <= 40 ? i / 40.0 : 1 - 0.004 * (i - 40));
    s.travel_m.push_back(2 * delta);
    s.stage.push_back(i <= 40 ? Stage::loading : Stage::unloading);
    s.force_N.push_back(0);
    s.compliance.push_back(0);
  }
  return s;
}

const std::map<std::string, law::ParameterTexts> materials = {
    {"hertz", {{"E_Pa", "1e9"}, {"nu", "0.3"}}},
    {"shahin", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"kappa_Pa", "1e7"}, {"inverse_m", "0.4"}}},
    {"similarity", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"kappa_Pa", "1e7"}, {"inverse_m", "0.4"}}},
    {"agarwal", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_y_Pa", "1e7"}}},
    {"thornton-ning", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"p_y_Pa", "2e7"}}},
    {"mdr", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_y_Pa", "1e7"}}},
    {"kogut-etsion", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_y_Pa", "1e7"}}},
    {"etsion-unloading", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_y_Pa", "1e7"}}},
    {"jackson-green", {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_y_Pa", "1e7"}}},
    {"wang", {{"E_Pa", "1e10"}, {"nu", "0.3"}, {"phi_deg", "30"}, {"sigma_c_Pa", "1e7"}}},
    {"edmans-sinka",
     {{"E_Pa", "1e9"}, {"nu", "0.3"}, {"sigma_ref_Pa", "1e7"}, {"k", "4"}, {"delta_t", "0.1"}, {"a", "3"}}},
};

TEST(Samples, OneLawServesParticlesOfAllSizes) {
  const double R = 0.37e-3;
  const auto samples = loading_and_unloading(R);
  for (const auto& name : calibrate::calibrated_laws()) {
    if (!calibrate::free_law(name).scales) continue;
    ASSERT_TRUE(materials.contains(name)) << name;
    fit::LawCard card;
    card.law = name;
    card.parameters = materials.at(name);
    const auto own = fit::make_law(card, {{"radius_m", "0.37e-3"}, {"against", "plane"}});
    const auto unit = fit::make_law(card, {{"radius_m", "1"}, {"against", "plane"}});
    std::vector<double> of_own, of_unit, k_own, k_unit;
    predict(own, R, samples, 0, of_own, &k_own);
    predict(unit, 1, samples, 0, of_unit, &k_unit);
    for (std::size_t i = 1; i < of_own.size(); ++i) {
      EXPECT_NEAR(of_unit[i], of_own[i], 1e-5 * of_own[40]) << name << " row " << i;
      EXPECT_NEAR(k_unit[i], k_own[i], 1e-4 * k_own[45]) << name << " row " << i;
    }
  }
}

TEST(Samples, TheMachineGivesWayUnderTheForceOfTheLaw) {
  const double R = 1e-3, c = 5e-6;
  auto samples = loading_and_unloading(R);
  fit::LawCard card;
  card.law = "agarwal";
  card.parameters = materials.at("agarwal");
  const auto law = fit::make_law(card, {{"radius_m", "1"}, {"against", "plane"}});
  std::vector<double> force;
  predict(law, 1, samples, 0, force);
  // The same travel with the frame in it, and noise in the force that was measured, gives the same forces.
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double measured = force[i] + (i % 2 ? 0.1 : -0.1);
    samples.force_N[i] = measured;
    samples.travel_m[i] += c * force[i] - c * measured;
    samples.compliance[i] = c;
  }
  std::vector<double> again;
  predict(law, 1, samples, 0, again);
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_NEAR(again[i], force[i], 2e-4 * force[40]) << i;
}

TEST(FreeLaws, AnUnknownOneIsRefusedWithTheNearest) {
  EXPECT_THROW((void)calibrate::free_law("shain"), core::InvalidInput);
}

} // namespace
