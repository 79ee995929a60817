#include "material/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <set>

using namespace platen;
using material::Vmdc, material::VonMises, material::Elastic;

namespace {

const std::string von_mises = R"(platen = 1
name = "x"
model = "von-mises"
[parameters]
sigma_y_Pa = 1e6
)";

material::Material read(const std::string& text) {
  return material::read_card(core::parse_toml(text, "m.toml")).material;
}

std::string refusal(const std::string& text) {
  try {
    (void)read(text);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(Catalogue, HasTheBaseCaseOfTable6) {
  const auto card = material::read_card("base-case");
  const auto& m = std::get<Vmdc>(card.material.model);
  EXPECT_EQ(m.rho_r0, 0.7);
  EXPECT_EQ(m.sigma_y, 150e6);
  EXPECT_EQ(m.E, 100 * 150e6);
  EXPECT_EQ(m.Gamma, 150e6);
  EXPECT_EQ(m.Lambda, 0.01 * 150e6);
  EXPECT_EQ(m.nu, 0.3);
  EXPECT_EQ(m.epsilon, 0.7);
  EXPECT_EQ(m.eta, 10);
  EXPECT_EQ(m.xi, 7.5);
  EXPECT_EQ(m.zeta, 10);
  EXPECT_EQ(m.omega, 10);
  EXPECT_EQ(m.xi_1, 0.4);
  EXPECT_EQ(m.xi_2, 1.5);
  EXPECT_EQ(card.sources.at(0).first, "default");
}

TEST(Catalogue, HasOnlyCardsThatCanBeReadAndSayWhereTheyAreFrom) {
  const auto names = core::card_names("materials");
  EXPECT_GE(names.size(), 8u);
  for (const auto& name : names) {
    const auto card = material::read_card(name);
    EXPECT_FALSE(card.sources.empty()) << name;
  }
}

TEST(Catalogue, NamesTheNearestCard) {
  try {
    (void)material::read_card("mcc-ph200");
    FAIL();
  } catch (const core::InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'mcc-ph-200'?"), std::string::npos)
        << error.what();
  }
}

TEST(MaterialCard, ReadsEachModel) {
  EXPECT_EQ(std::get<VonMises>(read(von_mises + "E_bar = 100\nnu = 0.3").model).E, 1e8);
  EXPECT_EQ(std::get<VonMises>(read(von_mises + "E_Pa = 2e8\nnu = 0").model).E, 2e8);
  const auto elastic =
      read("platen = 1\nname = \"e\"\nmodel = \"elastic\"\n[parameters]\nE_Pa = 1e9\nnu = 0.3");
  EXPECT_EQ(std::get<Elastic>(elastic.model).E, 1e9);
}

TEST(MaterialCard, RefusesWhatCannotBeAMaterial) {
  EXPECT_EQ(refusal(von_mises + "E_bar = 0\nnu = 0.3"),
            "m.toml, line 6: [parameters] E_bar = 0 is not allowed; it must be a number > 0");
  EXPECT_EQ(refusal(von_mises + "E_bar = 1\nnu = 0.5"),
            "m.toml, line 7: [parameters] nu = 0.5 is not allowed; it must be a number in [0, 0.5)");
  EXPECT_EQ(refusal(von_mises + "E_MPa = 100\nnu = 0.3"),
            "m.toml, line 6: [parameters] E_MPa = 100 is not in SI units; write E_Pa = 1e8");
}

TEST(MaterialCard, RefusesAVmdcOutsideItsRangeAtTheReferenceDensity) {
  const std::string base = material::card_text(material::read_card("base-case").material);
  EXPECT_NE(refusal(with(base, "epsilon = 0.7", "epsilon = -0.0783")).find("it must be a number > 0"),
            std::string::npos);
  EXPECT_NE(refusal(with(base, "rho_r0 = 0.7", "rho_r0 = 1.01")).find("it must be a number in (0, 1]"),
            std::string::npos);
  EXPECT_NE(refusal(with(base, "rho_r0 = 0.7", "rho_r0 = 0")).find("it must be a number in (0, 1]"),
            std::string::npos);
}

TEST(MaterialCard, RefusesAnUnknownModelFormatOrSection) {
  EXPECT_EQ(refusal(with(von_mises, "von-mises", "von-mise")),
            "m.toml, line 3: model = \"von-mise\": there is no such model; did you mean 'von-mises'?");
  EXPECT_EQ(refusal(with(von_mises, "platen = 1", "platen = 2")),
            "m.toml, line 1: platen = 2 is not allowed; it must be a whole number equal to 1");
  EXPECT_NE(refusal(with(von_mises, "[parameters]", "[parameter]")).find("did you mean 'parameters'?"),
            std::string::npos);
  EXPECT_EQ(refusal(von_mises + "E_bar = 1\nnu = 0.3\n[source]\nE_bar = 3"),
            "m.toml, line 9: [source] E_bar = 3 is a whole number; it must be text");
}

TEST(MaterialCard, IsWrittenAsItIsRead) {
  for (const auto& name : core::card_names("materials")) {
    const auto material = material::read_card(name).material;
    const auto again = read(material::card_text(material));
    EXPECT_EQ(again.name, material.name);
    const auto before = material::parameters(material.model), after = material::parameters(again.model);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(after[i].value, before[i].value) << before[i].key;
  }
}

TEST(MaterialCard, KeepsATensileStrengthBesideEachModel) {
  for (const std::string model : {"base-case", "von-mises-100", "elastic", "lead-hollomon", "wang-type-1",
                                  "sandstone-wang-3-4-mohr-coulomb"}) {
    const std::string text = material::card_text(material::read_card(model).material);
    EXPECT_FALSE(read(text).tensile_strength) << model;
    const auto strong = read(text + "tensile_strength_Pa = 2e6\n");
    EXPECT_EQ(strong.tensile_strength, 2e6) << model;
    EXPECT_EQ(read(material::card_text(strong)).tensile_strength, 2e6) << model;
    EXPECT_EQ(material::parameters(strong).back().key, "tensile_strength_Pa") << model;
    EXPECT_NE(refusal(text + "tensile_strength_Pa = 0\n").find("must be a number > 0"), std::string::npos)
        << model;
    EXPECT_NE(refusal(text + "tensile_strength_MPa = 2\n").find("write tensile_strength_Pa = 2e6"),
              std::string::npos)
        << refusal(text + "tensile_strength_MPa = 2\n");
  }
}

TEST(MaterialCard, KeepsADensityForExports) {
  const std::string text = von_mises + "E_bar = 100\nnu = 0.3\n";
  EXPECT_FALSE(read(text).density);
  const auto heavy = read(text + "density_kg_per_m3 = 7800\n");
  EXPECT_EQ(heavy.density, 7800);
  EXPECT_EQ(read(material::card_text(heavy)).density, 7800);
  EXPECT_EQ(material::parameters(heavy).back().key, "density_kg_per_m3");
  EXPECT_NE(refusal(text + "density_kg_per_m3 = -1\n").find("must be a number > 0"), std::string::npos);
}

TEST(MaterialCard, KnowsEveryModelOfTheListByNameAndTellsWhatKindItIs) {
  const std::string page = material::card_reference();
  std::set<std::string_view> names;
  material::for_each_model([&]<class M>() {
    EXPECT_TRUE(names.insert(M::name).second) << M::name;
    EXPECT_NE(page.find(fmt::format("\"{}\"", M::name)), std::string::npos) << M::name;
    const auto text = fmt::format("platen = 1\nname = \"x\"\nmodel = \"{}\"\n[parameters]", M::name);
    EXPECT_NE(refusal(text).find(" is missing"), std::string::npos) << M::name << " asks for nothing";
    if constexpr (material::InvariantModel<M> && material::PrincipalModel<M>)
      static_assert(requires(const M& m) { m.circular(); });
  });
  EXPECT_EQ(names.size(), std::variant_size_v<material::Model>);
}

TEST(MaterialCard, HasAReferencePageWithEveryKey) {
  const std::string page = material::card_reference();
  for (const auto& parameter : material::parameters(Vmdc{}))
    EXPECT_NE(page.find("`" + parameter.key + "`"), std::string::npos) << parameter.key;
}
