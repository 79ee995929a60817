// The tables of the papers as the catalogue keeps them: complete, consistent in themselves, and what the
// cards say.

#include "core/csv.hpp"
#include "material/card.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <map>

using namespace platen;
using namespace platen::material;

namespace {

core::Csv table(const std::string& name) {
  return core::read_csv(std::string(PLATEN_SOURCE_DIR) + "/catalogue/tables/" + name + ".csv");
}

material::Material card_of(const std::string& model, const std::string& lines) {
  return read_card(core::parse_toml(fmt::format("platen = 1\nname = \"x\"\nmodel = \"{}\"\n[parameters]\n{}",
                                                model, lines),
                                    "row"))
      .material;
}

} // namespace

TEST(CatalogueTables, EdmansSinkaTable4IsWhatItsCardsSay) {
  const auto csv = table("edmans-sinka-table-4");
  ASSERT_EQ(csv.rows.size(), 7u);
  const std::map<std::string, std::string> cards = {
      {"Dical Emcompress", "dical-emcompress"},
      {"Dical Fujicalin", "dical-fujicalin"},
      {"Lactose DT", "lactose-dt"},
      {"Lactose 310 NF", "lactose-310-nf"},
      {"MCC PH-102", "mcc-ph-102-at-half"},
      {"MCC PH-200", "mcc-ph-200"},
      {"Starch 1500", "starch-1500-at-half"},
  };
  for (const auto& row : csv.rows) {
    const auto number = [&](const char* column) { return csv.number(row, csv.column(column)); };
    const std::string& name = row.cells[csv.column("material")];
    const auto m = std::get<Vmdc>(read_card(cards.at(name)).material.model);
    const bool usable = row.cells[csv.column("usable")] == "yes";
    EXPECT_EQ(usable, number("epsilon") > 0) << name;
    EXPECT_EQ(usable, row.cells[csv.column("reason")].empty()) << name;
    EXPECT_EQ(m.rho_r0, usable ? 0.4 : 0.5);
    // Moved by ES (4a)-(5b).
    const double d = m.rho_r0 - 0.4, sigma_y = number("sigma_y_MPa") * 1e6;
    const auto same = [&](double value, double expected) {
      EXPECT_NEAR(value, expected, 1e-8 * std::abs(expected)) << name;
    };
    same(m.sigma_y, sigma_y * std::exp(number("eta") * d));
    same(m.E, sigma_y * number("E_bar") * std::exp(number("xi") * d));
    same(m.Gamma, sigma_y * number("Gamma_bar") * std::exp(number("zeta") * d));
    same(m.Lambda, sigma_y * number("Lambda_bar") * std::exp(number("omega") * d));
    same(m.nu, number("nu") + number("xi_1") * d);
    same(m.epsilon, number("epsilon") + number("xi_2") * d);
    for (const auto& [value, column] : {std::pair{m.eta, "eta"},
                                        {m.xi, "xi"},
                                        {m.zeta, "zeta"},
                                        {m.omega, "omega"},
                                        {m.xi_1, "xi_1"},
                                        {m.xi_2, "xi_2"}})
      same(value, number(column));
  }
}

TEST(CatalogueTables, ShahinTableA1HoldsItsOwnRatio) {
  // The last column is E/((1 - nu^2) sigma_y); the print is good to 0.2 %.
  const auto csv = table("shahin-table-a1");
  ASSERT_EQ(csv.rows.size(), 51u);
  for (const auto& row : csv.rows) {
    const auto number = [&](const char* column) { return csv.number(row, csv.column(column)); };
    const double nu = number("nu"), lambda = number("E_MPa") / ((1 - nu * nu) * number("sigma_y_MPa"));
    EXPECT_NEAR(lambda, number("lambda_printed"), 2e-3 * lambda) << "line " << row.line;
    (void)card_of("von-mises", fmt::format("E_Pa = {}\nnu = {}\nsigma_y_Pa = {}", number("E_MPa") * 1e6, nu,
                                           number("sigma_y_MPa") * 1e6));
  }
}

TEST(CatalogueTables, ShahinTableE1MakesHollomonMaterials) {
  const auto csv = table("shahin-table-e1");
  ASSERT_EQ(csv.rows.size(), 60u);
  for (const auto& row : csv.rows) {
    const double kappa = csv.number(row, csv.column("kappa_MPa")) * 1e6;
    const auto m = card_of(
        "von-mises", fmt::format("E_Pa = {}\nnu = 0.3\nhardening = {{ kind = \"hollomon\", kappa_Pa = {}, "
                                 "inverse_m = {} }}",
                                 1000 * kappa, kappa, csv.number(row, csv.column("inverse_m"))));
    EXPECT_EQ(reference_stress(m.model), kappa);
  }
}

TEST(CatalogueTables, WangTable1IsTheFullFactorial) {
  const auto csv = table("wang-table-1");
  EXPECT_EQ(csv.rows.size(), 162u);
  for (const auto& row : csv.rows) {
    const auto number = [&](const char* column) { return csv.number(row, csv.column(column)); };
    (void)card_of("drucker-prager",
                  fmt::format("E_Pa = {}\nnu = {}\nphi_deg = {}\nsigma_c_Pa = {}", number("E_GPa") * 1e9,
                              number("nu"), number("phi_deg"), number("sigma_c_MPa") * 1e6));
  }
}

TEST(CatalogueTables, EveryNamedCardIsThereAndEveryUnusableRowSaysWhy) {
  for (const char* name : {"wang-table-3", "wang-section-3"}) {
    const auto csv = table(name);
    for (const auto& row : csv.rows)
      if (const auto& card = row.cells[csv.column("card")]; !card.empty()) (void)read_card(card);
  }
  for (const char* name : {"edmans-sinka-table-4", "edmans-sinka-table-5", "wang-section-3"}) {
    const auto csv = table(name);
    for (const auto& row : csv.rows)
      EXPECT_EQ(row.cells[csv.column("usable")] == "no", !row.cells[csv.column("reason")].empty()) << name;
  }
}
