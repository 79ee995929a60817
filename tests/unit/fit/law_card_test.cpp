#include "fit/law_card.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/tabulate.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace platen;

struct LawCardFile : ::testing::Test {
  std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
  ~LawCardFile() override { std::filesystem::remove(file); }
  fit::LawCard read(const std::string& text) const {
    core::write_file(file, text);
    return fit::read_law_card(file.string());
  }
};

// the example of the project's schema
const std::string example =
    "platen = 1\nlaw = \"edmans-sinka\"\nvariant = \"published\"\n[parameters]\n"
    "sigma_ref_Pa = 8.61e6\nE_Pa = 4.417e8\nnu = 0.1472\nk = 4.2\ndelta_t = 0.09\na = 3.5\n"
    "unload_delta_bar = [0.1, 0.3, 0.5]\nalpha = [1.4, 1.3, 1.2]\nbeta = [1.3, 1.5, 1.6]\n"
    "[validity]\ndelta_bar = [0.0, 0.5]\n[error]\nrelative_l2 = 0.03\ne_p = 0.03\n"
    "[provenance]\nmaterial = \"mcc-ph-200\"\nengine = 1\n";

using LawCard = LawCardFile;

TEST_F(LawCard, WrittenAndReadIsTheSameCard) {
  const auto card = read(example);
  const auto again = read(fit::text_of(card));
  EXPECT_EQ(fit::text_of(card), fit::text_of(again));
  EXPECT_EQ(card.parameters, again.parameters);
  EXPECT_EQ(again.errors, card.errors);
  EXPECT_EQ(again.provenance, card.provenance);
  EXPECT_EQ(fit::value_of(again.errors, "relative_l2"), core::FieldValue(0.03));
  EXPECT_EQ(fit::value_of(again.provenance, "material"), core::FieldValue(std::string("mcc-ph-200")));
  EXPECT_EQ(fit::value_of(again.provenance, "engine"), core::FieldValue(1));
}

TEST_F(LawCard, HoldsFromWhereToWhereItSays) {
  std::string text = example;
  text.replace(text.find("[0.0, 0.5]"), 10, "[0.1, 0.5]");
  const auto card = read(text);
  const auto law = fit::make_law(card, {{"radius_m", "1e-3"}, {"against", "plane"}});
  const fit::Validity own = fit::validity_of(card, law);
  EXPECT_FALSE(own.holds(0.99e-4));
  EXPECT_TRUE(own.holds(1e-4) && own.holds(5e-4) && own.holds(0));
  EXPECT_FALSE(own.holds(5.01e-4));
  const fit::Validity both = fit::common(own, {2e-4, 9e-4});
  EXPECT_EQ(both.from, 2e-4);
  EXPECT_EQ(both.to, own.to);
}

TEST_F(LawCard, GivesTheLawThatTheHeadersGive) {
  const auto law = fit::make_law(read(example), {{"radius_m", "1e-3"}});
  law::EdmansSinkaMaterial m;
  m.sigma_ref = 8.61e6, m.E = 4.417e8, m.nu = 0.1472, m.k = 4.2, m.delta_t = 0.09, m.a = 3.5;
  m.unloadings = 3;
  const double x[] = {0.1, 0.3, 0.5}, alpha[] = {1.4, 1.3, 1.2}, beta[] = {1.3, 1.5, 1.6};
  for (int i = 0; i < 3; ++i) m.unload_delta_bar[i] = x[i], m.alpha[i] = alpha[i], m.beta[i] = beta[i];
  const auto direct = law::tabulate(law::prepare(m, 1e-3));
  const law::State top{4e-4, 4e-4};
  EXPECT_EQ(law::evaluate(law, top, 3.9e-4).force, law::evaluate(direct, top, 3.9e-4).force);
}

TEST_F(LawCard, SaysWhatIsWrongAndWhere) {
  const auto refusal = [&](std::string from, const std::string& to) -> std::string {
    std::string text = example;
    text.replace(text.find(from), from.size(), to);
    try {
      (void)fit::make_law(read(text), {{"radius_m", "1e-3"}});
    } catch (const core::InvalidInput& error) { return error.what(); }
    return "accepted";
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(refusal("nu = 0.1472", "nu = 0.6"), "line 7: [parameters] nu = 0.6 is not in [0, 0.5)");
  contains(refusal("delta_t =", "delta_tt ="), "did you mean 'delta_t'");
  contains(refusal("E_Pa = 4.417e8", "E_MPa = 441.7"), "E_Pa = 441700000");
  contains(refusal("edmans-sinka", "edmans-sinca"), "did you mean 'edmans-sinka'");
  contains(refusal("\"published\"", "\"publish\""), "did you mean 'published'");
  contains(refusal("beta = [1.3, 1.5, 1.6]", "beta = [1.3, 1.5]"), "as many values");
  contains(refusal("k = 4.2\n", ""), "k is missing");
  contains(refusal("k = 4.2", "k = \"stiff\""), "not a number");
  contains(refusal("platen = 1", "platen = 2"), "the format of the card is 1");
  contains(refusal("[validity]\ndelta_bar", "[validity]\ndelta_max"), "did you mean 'delta_bar'");
}

} // namespace
