#include "study/card.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "material/models.hpp"
#include "study/derived.hpp"
#include "study/store.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

using namespace platen;
namespace fs = std::filesystem;

namespace {

const std::string source = PLATEN_SOURCE_DIR;

class StudyCard : public testing::Test {
 protected:
  StudyCard() : folder_(fs::temp_directory_path() / ("platen-card-test-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~StudyCard() override { fs::remove_all(folder_); }

  study::Study read(const std::string& rest, const std::string& material = "\"von-mises-100\"") const {
    core::write_file(folder_ / "s.toml",
                     "platen = 1\nname = \"s\"\n[case]\nplaten = 1\nexperiment = \"simple\"\n"
                     "radius_m = 1e-3\nmaterial = " +
                         material + "\n" + rest);
    return study::read_study((folder_ / "s.toml").string());
  }
  std::string refusal(const std::string& rest) const {
    try {
      (void)read(rest);
    } catch (const core::InvalidInput& error) { return error.what(); }
    return "nothing was refused";
  }
  void table(const std::string& text) const { core::write_file(folder_ / "t.csv", text); }

  fs::path folder_;
};

#define EXPECT_REFUSED(rest, words) EXPECT_NE(refusal(rest).find(words), std::string::npos) << refusal(rest)

} // namespace

TEST_F(StudyCard, OfTableA1GivesThePrintedLambda) {
  const auto s = study::read_study(source + "/examples/shahin-a1.toml");
  const auto table = core::read_csv(source + "/catalogue/tables/shahin-table-a1.csv");
  ASSERT_EQ(s.runs.size(), 51u);
  const auto column = table.column("lambda_printed");
  for (std::size_t i = 0; i < s.runs.size(); ++i) {
    const double printed = table.number(table.rows[i], column);
    // nu is printed to four digits, sigma_y to 0.01 MPa, which is 0.25 % of the least, 2.01 MPa
    EXPECT_NEAR(study::lambda_of(s.runs[i].press_case) / printed, 1, 3e-3) << "row " << i + 1;
  }
  EXPECT_EQ(name_of(s.runs[0].press_case.experiment), "simple");
  EXPECT_EQ(name_of(s.runs[17].press_case.experiment), "die");
  EXPECT_EQ(name_of(s.runs[34].press_case.experiment), "hydrostatic");
  EXPECT_EQ(material::initial_E(s.runs[0].press_case.material.model), 36961.79e6);
}

TEST_F(StudyCard, OfTableE1ReachesIntoTheHardening) {
  const auto s = read(
      "[design]\nkind = \"table\"\nfile = \"shahin-table-e1.csv\"\nonly = { loading = \"die\" }\n[factors]\n"
      "\"material.hardening.kappa_Pa\" = { column = \"kappa_MPa\" }\n"
      "\"material.hardening.inverse_m\" = { column = \"inverse_m\" }\n",
      "\"lead-hollomon\"");
  ASSERT_EQ(s.runs.size(), 20u);
  EXPECT_EQ(material::reference_stress(s.runs[1].press_case.material.model), 107.55e6); // kappa
}

TEST_F(StudyCard, SpaceFillingDesignHoldsItsBounds) {
  const auto s = study::read_study(source + "/examples/space-filling.toml");
  ASSERT_EQ(s.runs.size(), 51u);
  for (const auto& run : s.runs) {
    const double lambda = study::lambda_of(run.press_case);
    EXPECT_TRUE(lambda >= 100 && lambda <= 6000) << lambda;
  }
}

TEST_F(StudyCard, ColumnsNamedAsFactorsNeedNoMore) {
  table("radius_m,material.E_Pa\n1e-3,1e9\n2e-3,2e9\n");
  const auto s = read(
      "[design]\nkind = \"table\"\nfile = \"t.csv\"\n[factors]\nradius_m = {}\n\"material.E_Pa\" = {}\n");
  ASSERT_EQ(s.runs.size(), 2u);
  EXPECT_EQ(s.runs[1].press_case.radius_m, 2e-3);
}

TEST_F(StudyCard, MaterialMayBeAFactor) {
  const auto s = read(
      "[design]\nkind = \"factorial\"\n[factors]\nmaterial = { values = [\"elastic\", \"lead-ludwik\"] }\n");
  ASSERT_EQ(s.runs.size(), 2u);
  EXPECT_EQ(s.runs[1].press_case.material.name, "Lead, Ludwik hardening");
}

TEST_F(StudyCard, AFactorTakesAKeyAwayThoughItsSourceIsKnown) {
  const std::string parameters = "E_Pa = 1e9\nsigma_y_Pa = 1e8\nnu = 0.3\n", of_E = "E_Pa = \"a book\"\n";
  core::write_file(folder_ / "m.toml", "platen = 1\nname = \"m\"\nmodel = \"von-mises\"\n[parameters]\n" +
                                           parameters + "[source]\n" + of_E);
  const std::string factor =
      "[design]\nkind = \"factorial\"\n[factors]\n\"material.E_bar\" = { values = [50] }\n";
  const auto modulus = [](const study::Study& s) {
    return material::initial_E(s.runs.at(0).press_case.material.model);
  };
  EXPECT_EQ(modulus(read(factor, "\"m.toml\"")), 5e9);
  EXPECT_EQ(
      modulus(read(factor, "{ platen = 1, name = \"m\", model = \"von-mises\", parameters = { E_Pa = 1e9, "
                           "sigma_y_Pa = 1e8, nu = 0.3 }, source = { E_Pa = \"a book\" } }")),
      5e9);
}

TEST_F(StudyCard, LevelsMayCarryTheirUnits) {
  const auto s =
      read("[design]\nkind = \"factorial\"\n[factors]\n"
           "\"material.E\" = { values = [\"10 GPa\", \"20 GPa\"] }\nradius = { values = [\"0.5 mm\"] }\n",
           "{ platen = 1, name = \"m\", model = \"von-mises\", parameters = { E = \"1 GPa\", nu = 0.3, "
           "sigma_y = \"100 MPa\" } }");
  ASSERT_EQ(s.runs.size(), 2u);
  EXPECT_EQ(s.factors[0].name, "material.E_Pa");
  EXPECT_EQ(std::get<double>(s.runs[1].inputs[0]), 20e9);
  EXPECT_EQ(material::initial_E(s.runs[1].press_case.material.model), 20e9);
  EXPECT_EQ(s.runs[1].press_case.radius_m, 0.5e-3);
  const auto range = read("[design]\nkind = \"latin-hypercube\"\nruns = 4\n[factors]\n"
                          "\"material.sigma_y\" = { min = \"100 MPa\", max = \"1 GPa\", scale = \"log\" }\n");
  EXPECT_EQ(range.factors[0].name, "material.sigma_y_Pa");
  EXPECT_EQ(range.factors[0].min, 1e8);
  EXPECT_EQ(range.factors[0].max, 1e9);
}

TEST_F(StudyCard, KeysAreThoseOfTheStoresThatAreThere) {
  // As engine 6 named them: a new key with a default must not name them otherwise.
  const auto s = study::read_study(source + "/catalogue/pools/edmans-sinka/study.toml");
  ASSERT_EQ(s.runs.size(), 160u);
  EXPECT_EQ(study::key_of(s.runs[0].press_case, 6), "7a593d016b74167cad07b05842f62acf");
  EXPECT_EQ(study::key_of(s.runs[12].press_case, 6), "c10801cacb3f870ad3372a70fd142266");
}

TEST_F(StudyCard, RefusesDesignsThatAreNone) {
  const std::string factors = "[factors]\nradius_m = { min = 1e-3, max = 2e-3 }\n";
  EXPECT_REFUSED("[design]\nkind = \"latin\"\n" + factors, "there is no such design");
  EXPECT_REFUSED("[design]\nkind = \"latin-hypercube\"\n" + factors, "[design] runs is missing");
  EXPECT_REFUSED("[design]\nkind = \"latin-hypercube\"\nruns = 4\nfile = \"t.csv\"\n" + factors,
                 "file is not for");
  EXPECT_REFUSED("[design]\nkind = \"factorial\"\n" + factors, "is not for a design of kind \"factorial\"");
  EXPECT_REFUSED("[design]\nkind = \"factorial\"\n[factors]\n", "the design is empty");
  std::string thousands;
  for (const auto* key : {"radius_m", "path.delta_bar_max", "material.nu"}) {
    thousands += "\"" + std::string(key) + "\" = { values = [0.1";
    for (int i = 1; i < 200; ++i) thousands += ", 0.1" + std::to_string(i);
    thousands += "] }\n";
  }
  EXPECT_REFUSED("[design]\nkind = \"factorial\"\n[factors]\n" + thousands,
                 "8e+06 combinations; a study may have 1000000 runs");
  EXPECT_REFUSED("[design]\nkind = \"factorial\"\n[factors]\nradius_m = { values = [] }\n",
                 "the design is empty");
  EXPECT_REFUSED("[design]\nkind = \"table\"\nfile = \"t.csv\"\n[factors]\nradius_m = {}\n",
                 "there is no such file");
  table("radius_m,kind\n1,a\n");
  EXPECT_REFUSED(
      "[design]\nkind = \"table\"\nfile = \"t.csv\"\nonly = { kind = \"b\" }\n[factors]\nradius_m = {}\n",
      "the design is empty");
  EXPECT_REFUSED("[design]\nkind = \"space-filling\"\nruns = 6\n[factors]\nradius_m = { values = [1, 2] }\n",
                 "has ranges");
  EXPECT_REFUSED(
      "[design]\nkind = \"latin-hypercube\"\nruns = 6\n[factors]\nradius_m = { min = 2, max = 1 }\n",
      "must be above min");
  EXPECT_REFUSED(
      "[design]\nkind = \"latin-hypercube\"\nruns = 6\n[factors]\nradius_m = { min = 0, max = 1, scale = "
      "\"log\" }\n",
      "needs min > 0");
  EXPECT_REFUSED("[design]\nkind = \"latin-hypercube\"\nruns = 6\n" + factors + "[bounds]\nlambda = [1, 2]\n",
                 "[bounds] are for");
  EXPECT_REFUSED("[design]\nkind = \"space-filling\"\nruns = 6\n" + factors + "[bounds]\nlamda = [1, 2]\n",
                 "did you mean 'lambda'");
  EXPECT_REFUSED("[design]\nkind = \"space-filling\"\nruns = 6\n" + factors + "[bounds]\nlambda = [1, 2]\n",
                 "less than a thousandth");
}

TEST_F(StudyCard, RefusesFactorsThatAreNone) {
  const std::string design = "[design]\nkind = \"factorial\"\n[factors]\n";
  EXPECT_REFUSED(design + "\"material.E_bra\" = { values = [3] }\n", "did you mean 'E_bar'");
  EXPECT_REFUSED(design + "\"pth.delta_bar_max\" = { values = [0.1] }\n", "pth");
  EXPECT_REFUSED(design + "\"radius_m.x\" = { values = [0.1] }\n", "radius_m is no table");
  EXPECT_REFUSED(design + "\"mesh.elements\" = { values = [100.5] }\n", "a whole number");
  EXPECT_REFUSED(design + "experiment = { values = [\"dye\"] }\n", "the run with experiment = dye");
  EXPECT_REFUSED(design + "radius_m = { value = [1] }\n", "did you mean 'values'");
  EXPECT_REFUSED(design + "\"material.E\" = { values = [\"1 GPa\", \"2 mm\"] }\n", "is a length");
  EXPECT_REFUSED(design + "\"material.E\" = { values = [\"1 GPa\", 2] }\n", "2\" is no number with a unit");
  EXPECT_REFUSED(design + "\"material.E_Pa\" = { values = [\"1 GPa\"] }\n", "write \"material.E\"");
}
