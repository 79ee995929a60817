// Whatever stands in a card or a curve, the answer is a result or InvalidInput: no crash, no hang.

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "material/card.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <random>

using namespace platen;

namespace {

constexpr int mutants = 1000;

class Mutator {
 public:
  std::string operator()(std::string text) {
    for (int edits = below(4) + 1; edits > 0; --edits) edit(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random() % n; }

  void edit(std::string& text) {
    static const std::vector<std::string> nasty = {"nan",
                                                   "inf",
                                                   "-1",
                                                   "0",
                                                   "1e999",
                                                   "1e-320",
                                                   "-0.0",
                                                   "99999999999999999999",
                                                   "\"",
                                                   "[",
                                                   "]]",
                                                   "{",
                                                   "=",
                                                   "#",
                                                   ",",
                                                   "\n",
                                                   "\r",
                                                   "\t",
                                                   "true",
                                                   "1979-05-27",
                                                   "'''",
                                                   "[a.b]\n",
                                                   std::string(1, '\0'),
                                                   "\xff\xfe",
                                                   "0x1F",
                                                   std::string(300, '['),
                                                   std::string(300, 'x'),
                                                   "platen = 1\n",
                                                   "[parameters]\n"};
    const std::size_t at = below(text.size()), length = below(12);
    switch (below(7)) {
    case 0:
      text.insert(at, nasty[below(nasty.size())]);
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(below(text.size()), text.substr(at, 3 * length));
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      replace_value(text, at, nasty[below(nasty.size())]);
      break;
    case 5:
      replace_value(text, at, std::to_string(static_cast<int>(below(2000)) - 1000));
      break;
    default:
      if (!text.empty()) text[at] = static_cast<char>(below(256));
    }
  }

  /// The rest of a line after its "=" or ",".
  static void replace_value(std::string& text, std::size_t at, const std::string& value) {
    const auto from = text.find_first_of("=,", at);
    if (from == std::string::npos) return;
    const auto to = std::min(text.find_first_of(",\n", from + 1), text.size());
    text.replace(from + 1, to - from - 1, value);
  }

  std::mt19937 random{7};
};

/// How many mutants were refused; anything but InvalidInput fails the test.
template <class Action> int refused(const std::string& text, Action action) {
  Mutator mutate;
  int count = 0;
  for (int i = 0; i < mutants; ++i) {
    const std::string mutant = mutate(text);
    try {
      action(mutant);
    } catch (const core::InvalidInput& error) {
      ++count;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    } catch (const std::exception& error) { ADD_FAILURE() << error.what() << "\nfor:\n" << mutant; }
  }
  return count;
}

std::string case_text() {
  return "platen = 1\nexperiment = \"simple\"\nmaterial = \"base-case\"\nradius_m = "
         "1e-3\n[path]\ndelta_bar_max = 0.5\n"
         "unload_from = [0.1, 0.3]\nreload = true\n[mesh]\nelements = 5000\n[output]\nfields_at = [0.1, "
         "0.5]\n";
}

press::Curve curve() {
  press::Curve c{1e-3, 1e6, 1e8, 0.3, "simple", "x", "0.1.0", 1, {}};
  for (int i = 0; i <= 60; ++i) {
    press::CurvePoint p;
    p.delta_bar = 0.5 * i / 60;
    p.delta_m = p.delta_bar * c.radius_m;
    p.force_N = 3 * p.delta_bar * (1 + p.delta_bar);
    c.points.push_back(p);
  }
  press::CurvePoint top = c.points.back();
  for (int i = 0; i <= 12; ++i) {
    press::CurvePoint p = top;
    p.branch = press::Branch::unloading;
    p.branch_id = 1;
    p.delta_bar = 0.5 - 0.005 * i;
    p.delta_m = p.delta_bar * c.radius_m;
    p.force_N = top.force_N * std::pow(1 - i / 12.0, 1.3);
    c.points.push_back(p);
  }
  press::set_reference_stress(c, 1e6);
  return c;
}

} // namespace

TEST(MutatedInput, MaterialCardsAreReadOrRefused) {
  const std::string text = core::read_file(core::find_card("materials", "mcc-ph-200"));
  EXPECT_GT(
      refused(text, [](const std::string& t) { (void)material::read_card(core::parse_toml(t, "m.toml")); }),
      100);
}

TEST(MutatedInput, CaseCardsAreReadOrRefused) {
  EXPECT_GT(refused(case_text(),
                    [](const std::string& t) { (void)press::read_case(core::parse_toml(t, "c.toml")); }),
            100);
}

TEST(MutatedInput, WhatIsReadFromACaseCardIsWrittenAsOne) {
  refused(case_text(), [](const std::string& t) {
    const auto c = press::read_case(core::parse_toml(t, "c.toml"));
    EXPECT_NO_THROW(press::validate(c)) << press::case_text(c);
  });
}

TEST(MutatedInput, LawCardsAreReadOrRefused) {
  const auto c = curve();
  const std::string text =
      fit::text_of(fit::law_card(c, fit::fit_law(c, "published", [](const auto&) {}), ""));
  const auto file =
      std::filesystem::temp_directory_path() / fmt::format("platen-mutated-law-{}.toml", ::getpid());
  EXPECT_GT(refused(text,
                    [&](const std::string& t) {
                      core::write_file(file, t);
                      const auto card = fit::read_law_card(file.string());
                      const auto law = fit::make_law(card, {{"radius_m", "1e-3"}});
                      const auto loaded = law::evaluate(law, {}, 4e-4);
                      (void)law::evaluate(law, loaded.state, 3.9e-4);
                    }),
            100);
  std::filesystem::remove(file);
}

TEST(MutatedInput, CurvesAreReadAndFittedOrRefused) {
  EXPECT_GT(refused(press::curve_csv(curve()),
                    [](const std::string& t) {
                      const auto read = press::parse_curve(t, "c.csv");
                      const auto fitted = fit::fit_law(read, "published", [](const auto&) {});
                      (void)fit::text_of(fit::law_card(read, fitted, t));
                    }),
            100);
  EXPECT_GT(refused("delta_m,force_N\n0,0\n1e-5,0.1\n2e-5,0.2\n3e-5,0.3\n4e-5,0.4\n5e-5,0.5\n6e-5,0.7\n7e-5,"
                    "0.9\n8e-5,1\n",
                    [](const std::string& t) { (void)press::parse_curve(t, "c.csv", 1e-3); }),
            100);
}
