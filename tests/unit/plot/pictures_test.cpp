#include "core/error.hpp"
#include "core/file.hpp"
#include "material/card.hpp"
#include "plot/compare_picture.hpp"
#include "plot/confined_picture.hpp"
#include "plot/curve_picture.hpp"
#include "plot/energy_picture.hpp"
#include "plot/field_map.hpp"
#include "plot/local_picture.hpp"
#include "plot/zone_map.hpp"
#include "section.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h>

namespace platen {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class Pictures : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("platen-" + std::to_string(::getpid()) + "-" + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(Pictures, OfManyLawsNameThemAllInsideThePicture) {
  const std::vector<double> x{1e-5, 1e-4, 5e-4}, F{1, 10, 50}, a{1e-4, 3e-4, 7e-4};
  fit::Reference reference;
  reference.delta = x;
  reference.trace = {"press", F, a, {true, true, true}, {}};
  reference.radius_m = 1e-3;
  for (const int laws : {1, 14, 25}) {
    std::vector<fit::Trace> traces;
    for (int k = 0; k < laws; ++k)
      traces.push_back({"law number " + std::to_string(k), F, a, {true, true, false}, {}});
    const fs::path file = folder_ / "laws.svg";
    plot::compare_picture(reference, traces, "many", file);
    const std::string svg = core::read_file(file);
    int named = 0;
    for (auto at = svg.find("<text>"); at != std::string::npos; at = svg.find("<text>", at + 1)) {
      // <g transform="translate(x,y)" ...> \n <text>words
      const auto place = svg.rfind("translate(", at);
      const double across = std::stod(svg.substr(place + 10));
      if (svg.compare(at + 6, 11, "law number ") == 0 && across < 950) ++named;
    }
    EXPECT_EQ(named, laws);
  }
}

bool has_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

press::Curve curve() {
  press::Curve curve;
  curve.radius_m = 1e-3;
  curve.sigma_ref_Pa = 150e6;
  curve.experiment = "simple";
  curve.material = "a \"quoted\" name with `backticks` and_subscript";
  for (int i = 0; i <= 50; ++i) {
    press::CurvePoint point;
    point.delta_bar = 0.01 * i;
    point.F_bar = 2 * point.delta_bar;
    curve.points.push_back(point);
  }
  return curve;
}

const std::vector<double> overlap = {0, 0.25, 0.5}, force = {0, 0.6, 0.9};

press::Zone by_radius(double r, double z) {
  const double radius = std::hypot(r, z);
  return radius < 0.3   ? press::Zone::shear
         : radius < 0.6 ? press::Zone::tension
         : radius < 0.8 ? press::Zone::compaction
                        : press::Zone::elastic;
}

TEST_F(Pictures, AZoneMapNamesAllZonesAndEveryOverlap) {
  plot::zone_map({test::quarter_disc(12, 0.1, by_radius), test::quarter_disc(12, 0.35, by_radius)},
                 "A < B & \"C\"", folder_ / "zones.svg");
  const std::string svg = core::read_file(folder_ / "zones.svg");
  for (const char* word :
       {"compaction", "shear", "tension", "elastic", "δ̄ = 0.1<", "δ̄ = 0.35<", "A &lt; B &amp; &quot;C&quot;"})
    EXPECT_NE(svg.find(word), std::string::npos) << word;
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(files(), 1u); // nothing half-written beside it
}

// The size that a picture in a README or a run folder may have; the bound is the project's own.
TEST_F(Pictures, AZoneMapOfFiveThousandElementsStaysBelow600kBAPanel) {
  const auto chequered = [](double r, double z) {
    return std::sin(60 * r) * std::sin(50 * z) > 0.6 ? press::Zone::tension : press::Zone::elastic;
  };
  plot::zone_map({test::quarter_disc(71, 0.3, chequered)}, "many small patches", folder_ / "zones.svg");
  EXPECT_LT(fs::file_size(folder_ / "zones.svg"), 600'000u);
}

TEST_F(Pictures, EqualInputGivesEqualFiles) {
  const std::vector snapshots = {test::quarter_disc(12, 0.1, by_radius)};
  plot::zone_map(snapshots, "title", folder_ / "one.svg");
  plot::zone_map(snapshots, "title", folder_ / "two.svg");
  EXPECT_EQ(core::read_file(folder_ / "one.svg"), core::read_file(folder_ / "two.svg"));
}

TEST_F(Pictures, AFieldMapShowsTheEndsOfItsScale) {
  auto snapshot = test::quarter_disc(12, 0.5, by_radius);
  for (std::size_t i = 0; i < snapshot.rho_r.size(); ++i) snapshot.rho_r[i] = i < 72 ? 0.7 : 0.8;
  plot::field_map({snapshot}, plot::relative_density(), "density", folder_ / "rho.svg");
  const std::string svg = core::read_file(folder_ / "rho.svg");
  EXPECT_NE(svg.find(">0.7<"), std::string::npos);
  EXPECT_NE(svg.find(">0.8<"), std::string::npos);
  EXPECT_NE(svg.find("relative density"), std::string::npos);
}

TEST_F(Pictures, AConstantFieldIsDrawnAsWell) {
  auto snapshot = test::quarter_disc(6, 0.1, by_radius);
  snapshot.rho_r.assign(snapshot.rho_r.size(), 0.7);
  plot::field_map({snapshot}, plot::relative_density(), "", folder_ / "rho.svg");
  EXPECT_NE(core::read_file(folder_ / "rho.svg").find(">0.7<"), std::string::npos);
}

TEST_F(Pictures, RefuseSnapshotsThatDoNotFitTogether) {
  auto snapshot = test::quarter_disc(6, 0.1, by_radius);
  EXPECT_THROW(plot::zone_map({}, "", folder_ / "z.svg"), core::InvalidInput);
  EXPECT_THROW(plot::zone_map({snapshot}, "", folder_ / "z.gif"), core::InvalidInput);
  snapshot.zones.pop_back();
  EXPECT_THROW(plot::zone_map({snapshot}, "", folder_ / "z.svg"), core::InvalidInput);
  snapshot = test::quarter_disc(6, 0.1, by_radius);
  snapshot.elements[3][2] = 4711;
  EXPECT_THROW(plot::field_map({snapshot}, plot::relative_density(), "", folder_ / "z.svg"),
               core::InvalidInput);
  EXPECT_EQ(files(), 0u);
}

TEST_F(Pictures, AFolderThatIsNotThereIsSaid) {
  EXPECT_THROW(plot::zone_map({test::quarter_disc(4, 0.1, by_radius)}, "", folder_ / "no" / "z.svg"),
               core::IoError);
  EXPECT_THROW(plot::curve_with_law(curve(), overlap, force, "law", folder_ / "no" / "c.svg"), core::IoError);
}

TEST_F(Pictures, ACurveWithItsLawIsDrawnAsSvgAndPng) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  plot::curve_with_law(curve(), overlap, force, "edmans-sinka", folder_ / "curve.svg");
  plot::curve_with_law(curve(), overlap, force, "edmans-sinka", folder_ / "curve.png");
  const std::string svg = core::read_file(folder_ / "curve.svg"),
                    png = core::read_file(folder_ / "curve.png");
  EXPECT_NE(svg.find("edmans-sinka"), std::string::npos);
  EXPECT_NE(svg.find("µm"), std::string::npos);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(files(), 2u);
}

TEST_F(Pictures, AZoneMapIsDrawnAsPng) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  plot::zone_map({test::quarter_disc(6, 0.1, by_radius)}, "it's a title", folder_ / "zones.png");
  EXPECT_EQ(core::read_file(folder_ / "zones.png").substr(1, 3), "PNG");
}

TEST_F(Pictures, OfALocalPressNameLoadsAndUnits) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  press::Result result;
  EXPECT_THROW(plot::approach_picture(result, folder_ / "approach.svg"), core::InvalidInput);
  EXPECT_THROW(plot::plastic_zone_picture(result, folder_ / "zones.svg"), core::InvalidInput);
  result.curve = curve();
  result.curve.E_Pa = 1e9;
  result.curve.nu = 0.3;
  for (auto& point : result.curve.points) {
    point.force_N = point.F_bar;
    point.hertz_delta_m = point.delta_bar * 1e-3;
  }
  auto snapshot = test::quarter_disc(12, 0.1, by_radius);
  for (const auto& zone : snapshot.zones) {
    snapshot.plastic_strain_v.push_back(0);
    snapshot.plastic_strain_q.push_back(zone[0] == press::Zone::shear ? 3e-4 : 0);
  }
  result.snapshots = {snapshot, snapshot};
  result.profiles = {{0.5, 3e-4, {{0, 1e6}, {2e-4, 0}}}, {0.75, 5e-4, {{0, 1e6}, {4e-4, 0}}}};
  plot::approach_picture(result, folder_ / "approach.svg");
  plot::peaks_picture(result, folder_ / "peaks.svg");
  plot::pressure_picture(result, folder_ / "pressure.svg");
  plot::plastic_zone_picture(result, folder_ / "zones.svg");
  const auto has = [&](const char* file, const char* words) {
    EXPECT_NE(core::read_file(folder_ / file).find(words), std::string::npos) << file << ": " << words;
  };
  has("approach.svg", "(µm)");
  has("approach.svg", "Hertz");
  has("peaks.svg", "(MPa)");
  has("pressure.svg", "750 mN");
  has("pressure.svg", "(µm)");
  has("zones.svg", "750 mN, a = 500 µm");
  has("zones.svg", "from 0.0002");
  EXPECT_EQ(files(), 4u);
}

/// A coarse ball between planes that move one after the other.
press::Result squeezed() {
  press::Triaxial e;
  e.elements = 200;
  e.delta_bar_z = {0.02, 0.02};
  e.delta_bar_x = {0, 0.01};
  e.fields_at = {0.02, 0.03};
  return press::press({material::read_card("von-mises-100").material, 1e-3, e});
}

TEST_F(Pictures, OfAConfinedPressNamePlanesAndOverlaps) {
  const auto result = squeezed();
  ASSERT_EQ(result.spatial.size(), 2U);
  plot::particle_picture(result.spatial, "ball", folder_ / "particle.svg");
  plot::faces_picture(result.spatial, 200e6, "ball", folder_ / "faces.svg");
  for (const char* name : {"particle.svg", "faces.svg"}) {
    const std::string svg = core::read_file(folder_ / name);
    for (const char* words : {"δ/R₀ = 0.02<", "δz/R₀ = 0.02, δx/R₀ = 0.01<"})
      EXPECT_NE(svg.find(words), std::string::npos) << name << ' ' << words;
  }
  const std::string faces = core::read_file(folder_ / "faces.svg");
  for (const char* words : {"plane z, ", "plane x, ", "contact pressure/σ_ref", "x/R₀"})
    EXPECT_NE(faces.find(words), std::string::npos) << words;
  EXPECT_EQ(faces.find("plane y, "), std::string::npos); // there is none
}

TEST_F(Pictures, OfEnergiesNameRegimesAndUnits) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  auto c = curve();
  for (auto& point : c.points) {
    const double x = point.delta_bar;
    point.work_J = x * x;
    point.dissipated_J = x > 0.05 ? 0.8 * (x - 0.05) * x : 0;
    point.stored_J = point.work_J - point.dissipated_J;
    point.mean_pressure_Pa = 1e8 * (x < 0.1 ? x * 10 : 1.1 - x);
  }
  plot::energy_picture(c, folder_ / "energy.svg");
  const std::string svg = core::read_file(folder_ / "energy.svg");
  for (const char* words :
       {"work", "stored", "dissipated", "elastic-plastic", "energy of one side", "mean pressure", "δ/R"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  for (auto& point : c.points) point.work_J = 0;
  EXPECT_THROW(plot::energy_picture(c, folder_ / "none.svg"), core::InvalidInput);
  EXPECT_EQ(files(), 1U);
}

TEST_F(Pictures, WithoutGnuplotOneSentenceSaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  std::string said;
  try {
    plot::curve_with_law(curve(), overlap, force, "law", folder_ / "curve.svg");
  } catch (const core::IoError& error) { said = error.what(); }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(said.find("install the package gnuplot-nox"), std::string::npos) << said;
  EXPECT_EQ(files(), 0u);
}

TEST_F(Pictures, RefuseLawsAndCurvesThatCannotBeDrawn) {
  EXPECT_THROW(plot::curve_with_law(curve(), {0, 0.5}, {0}, "law", folder_ / "c.svg"), core::InvalidInput);
  EXPECT_THROW(plot::curve_with_law(curve(), {0, 0.5, 0.4}, force, "law", folder_ / "c.svg"),
               core::InvalidInput);
  EXPECT_THROW(plot::curve_with_law(press::Curve{}, overlap, force, "law", folder_ / "c.svg"),
               core::InvalidInput);
  auto broken = curve();
  broken.points[3].F_bar = std::numeric_limits<double>::infinity();
  EXPECT_THROW(plot::curve_with_law(broken, overlap, force, "law", folder_ / "c.svg"), core::InvalidInput);
}

} // namespace
} // namespace platen
