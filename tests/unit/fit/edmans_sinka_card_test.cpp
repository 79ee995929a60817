#include "fit/edmans_sinka_card.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/sha256.hpp"
#include "curves.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

namespace platen {
namespace {

press::Curve curve(int branches) {
  const auto law = test::edmans_sinka(4, 0.1, 3, law::EdmansSinkaVariant::published);
  auto curve = test::loading_curve([&](double x) { return law.F_bar(x); });
  curve.material = "12e3"; // a name that looks like a number stays a name
  curve.engine = 7;
  for (int i = 1; i <= branches; ++i) {
    const double x = 0.5 * i / branches;
    test::add_unloading(curve, i, x, law.F_bar(x), 1.2 + 0.02 * i, 0.9 * x);
  }
  return curve;
}

fit::LawCard card_of(const press::Curve& curve) {
  return fit::law_card(curve, fit::fit_law(curve, "published", [](const auto&) {}), "the text");
}

fit::LawCard read_back(const fit::LawCard& card) {
  const auto file = std::filesystem::temp_directory_path() /
                    (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
  core::write_file(file, fit::text_of(card));
  const auto again = fit::read_law_card(file.string());
  std::filesystem::remove(file);
  return again;
}

void expect_same(const fit::LawCard& one, const fit::LawCard& other) {
  EXPECT_EQ(one.law, other.law);
  EXPECT_EQ(one.variant, other.variant);
  EXPECT_EQ(one.parameters, other.parameters);
  EXPECT_EQ(one.delta_bar, other.delta_bar);
  EXPECT_EQ(one.errors, other.errors);
  EXPECT_EQ(one.provenance, other.provenance);
}

TEST(EdmansSinkaCard, IsReadAsItIsWritten) {
  for (const int branches : {0, 1, 5, 8}) {
    const auto card = card_of(curve(branches));
    expect_same(card, read_back(card));
    EXPECT_EQ(fit::value_of(card.provenance, "material"), core::FieldValue(std::string("12e3")));
    EXPECT_EQ(fit::value_of(card.provenance, "curve_sha256"), core::FieldValue(core::sha256("the text")));
    EXPECT_EQ(fit::value_of(card.provenance, "engine"), core::FieldValue(7));
  }
}

TEST(EdmansSinkaCard, UnloadsAsTheBranchesDid) {
  // Against a plane gamma = delta; 2 % of the way down the force must be that of (13).
  const auto pressed = curve(5);
  const auto unloading = fit::fit_unloading(pressed);
  const auto card = read_back(card_of(pressed));
  const auto law = fit::make_law(card, {{"radius_m", "1e-3"}, {"against", "plane"}});
  const double F_ref = std::numbers::pi * 1e-6 * pressed.sigma_ref_Pa;
  ASSERT_EQ(unloading.fits.size(), 5u);
  for (const auto& branch : unloading.fits) {
    const double top = branch.delta_bar_max, below = top - 0.2 * (top - branch.delta_bar_0);
    const auto loaded = law::evaluate(law, {}, top * 1e-3);
    const auto now = law::evaluate(law, loaded.state, below * 1e-3);
    EXPECT_NEAR(now.force / F_ref, branch.F_bar(below), 1e-3 * branch.F_bar_max) << top;
  }
}

TEST(EdmansSinkaCard, CarriesTheContactRadiusOfThePress) {
  auto pressed = curve(0);
  const auto a_bar = [](double x) {
    return x < 0.1 ? 1.45 * std::sqrt(x) : 1.45 * std::sqrt(0.1) * std::pow(x / 0.1, 0.4);
  };
  for (auto& point : pressed.points) point.contact_radius_m = pressed.radius_m * a_bar(point.delta_bar);
  const auto card = read_back(card_of(pressed));
  const auto law = fit::make_law(card, {{"radius_m", "1e-3"}, {"against", "plane"}});
  for (const double x : {0.002, 0.02, 0.1, 0.25, 0.5})
    EXPECT_NEAR(law::evaluate(law, {}, x * 1e-3).contact_radius, 1e-3 * a_bar(x),
                1e-6 * 1e-3 + 1e-4 * 1e-3 * a_bar(x))
        << x;
  EXPECT_LT(std::get<double>(fit::value_of(card.errors, "radius_l2")), 1e-6);
  EXPECT_EQ(card_of(curve(0)).parameters.count("a_bar"), 0u); // measured without
}

TEST(EdmansSinkaCard, SaysHowWellTheBranchesAreFollowed) {
  const auto card = card_of(curve(2));
  const auto r_squared = std::get<std::vector<double>>(fit::value_of(card.errors, "unload_R2"));
  ASSERT_EQ(r_squared.size(), 2u);
  for (const double value : r_squared) EXPECT_GT(value, 0.999999);
  EXPECT_EQ(card_of(curve(0)).parameters.count("alpha"), 0u);
}

TEST(EdmansSinkaCard, RefusesBranchesThatNoCardHolds) {
  EXPECT_THROW(card_of(curve(9)), core::InvalidInput);
  auto twice = curve(1);
  test::add_unloading(twice, 2, 0.5, 1.0, 1.4, 0.4);
  EXPECT_THROW(card_of(twice), core::InvalidInput);
}

} // namespace
} // namespace platen
