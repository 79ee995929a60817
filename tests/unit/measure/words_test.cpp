#include "measure/particle_words.hpp"
#include "measure/quantity.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen::measure;

TEST(Words, HeadingsComeApartAsInstrumentsWriteThem) {
  for (const auto& [text, name, unit] :
       {std::tuple{"Kraft in N", "Kraft", "N"}, std::tuple{"Force[mN]", "Force", "mN"},
        std::tuple{"travel_um", "travel", "um"}, std::tuple{"Load (N)", "Load", "N"},
        std::tuple{"Standardweg", "Standardweg", ""}, std::tuple{"Weg / mm", "Weg", "mm"},
        std::tuple{"Displacement, mm", "Displacement", "mm"},
        std::tuple{"Durchmesser [mm]:", "Durchmesser", "mm"}}) {
    const Heading heading = heading_of(text);
    EXPECT_EQ(heading.name, name) << text;
    EXPECT_EQ(heading.unit, unit) << text;
  }
}

TEST(Words, QuantitiesInSeveralLanguages) {
  for (const auto* name :
       {"Force", "Load", "Compressive load", "Standardkraft", "Prüfkraft", "Kraft", "試験力", "F"})
    EXPECT_EQ(quantity_named(name), Quantity::force) << name;
  for (const auto* name :
       {"Distance", "Extension", "Compressive extension", "Displacement", "Stroke", "Standardweg",
        "Wegaufnehmer Platten", "Traverse abs.", "Position", "Depth", "変位", "s"})
    EXPECT_EQ(quantity_named(name), Quantity::displacement) << name;
  for (const auto* name : {"Time", "Prüfzeit", "Laufzeit", "Zeit  1 - Standardmessrate"})
    EXPECT_EQ(quantity_named(name), Quantity::time) << name;
  for (const auto* name : {"Compressive stress", "Dehnung", "Prüfgeschwindigkeit", "MX840_0_CH 6"})
    EXPECT_EQ(quantity_named(name), Quantity::other) << name;
}

TEST(Words, UnitsOfForceAndLength) {
  EXPECT_DOUBLE_EQ(unit_named("g")->in_SI, 9.80665e-3); // gram-force, standard gravity
  EXPECT_DOUBLE_EQ(unit_named("lbf")->in_SI, 4.4482216152605);
  EXPECT_DOUBLE_EQ(unit_named("mN")->in_SI, 1e-3);
  EXPECT_DOUBLE_EQ(unit_named("MN")->in_SI, 1e6);
  EXPECT_DOUBLE_EQ(unit_named("KN")->in_SI, 1e3);
  EXPECT_DOUBLE_EQ(unit_named("µm")->in_SI, 1e-6);
  EXPECT_DOUBLE_EQ(unit_named("inch")->in_SI, 0.0254);
  EXPECT_FALSE(unit_named("°C"));
}

TEST(Words, TheDiameterIsTheParticlesNotTheTools) {
  const Dialect point{',', false}, comma{';', true};
  EXPECT_DOUBLE_EQ(diameter_in("granule 1, height 1.20 mm", point).value_or(0), 1.2e-3);
  EXPECT_DOUBLE_EQ(diameter_in("Probendurchmesser 1,00 mm", comma).value_or(0), 1e-3);
  EXPECT_DOUBLE_EQ(diameter_in("Durchmesser [mm]: 10,00", comma).value_or(0), 10e-3);
  EXPECT_NEAR(diameter_in("Particle diameter[um] 52.4", point).value_or(0), 52.4e-6, 1e-18);
  EXPECT_DOUBLE_EQ(diameter_in("# radius_m = 1e-3", point).value_or(0), 2e-3);
  EXPECT_FALSE(diameter_in("Upper platen: flat 100 um", point));
  EXPECT_FALSE(diameter_in("Platen diameter 50 mm", point));
  EXPECT_FALSE(diameter_in("Diameter 50", point)) << "no unit";
}

} // namespace
