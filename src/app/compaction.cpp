#include "app/commands.hpp"
#include "calibrate/compaction_files.hpp"
#include "core/file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  calibrate::CompactionFiles files;
  std::string card;
  bool json = false;
};

std::string json_of(const calibrate::Compaction& c, const calibrate::CompactionFiles& f) {
  nlohmann::ordered_json trends = nlohmann::ordered_json::array();
  for (const auto& t : c.trends)
    trends.push_back({{"key", t.key},
                      {"value", t.value},
                      {"growth", t.growth_key},
                      {"of_growth", t.growth},
                      {"R2", t.R2},
                      {"points", t.points},
                      {"rho_r", {t.low, t.high}}});
  return nlohmann::ordered_json{{"model", f.model},
                                {"rho_r0", f.rho_r0},
                                {"trends", trends},
                                {"axial_relative_l2", c.axial_l2},
                                {"radial_relative_l2", c.radial_l2},
                                {"remarks", c.said}}
             .dump(2) +
         "\n";
}

void run_compaction(const Options& o) {
  const auto c = calibrate::compaction(o.files);
  if (!o.card.empty()) core::write_file(o.card, card_of(c, o.files));
  fmt::print(report_stream(o.card), "{}", o.json ? json_of(c, o.files) : words_of(c, o.files));
}

} // namespace

void add_compaction(Command program) {
  auto command =
      program.add_subcommand("compaction", "a porous material from die compaction and tablet strengths");
  auto o = std::make_shared<Options>();
  command
      .add_option("TEST.csv", o->files.test,
                  "rho_r, axial_stress_MPa, radial_stress_MPa (or _Pa, _kPa), in the order of the test")
      .required();
  command
      .add_option("--strengths", o->files.strengths,
                  "rho_r, compressive_strength_MPa (uniaxial), tensile_strength_MPa (diametral) of tablets")
      .required()
      .type_name("TABLETS.csv");
  command.add_option("--rho_r0", o->files.rho_r0, "relative density of the granules that will be pressed")
      .required()
      .type_name("NUMBER");
  command.add_option("--model", o->files.model, "vmdc or dpc").type_name("NAME").capture_default_str();
  command.add_option("--name", o->files.name, "name of the material").type_name("TEXT");
  command.add_option("-o", o->card, "write the material card here").type_name("CARD.toml");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Example: platen compaction die.csv --strengths tablets.csv --rho_r0 0.5 -o powder.toml");
  command.callback([o] { run_compaction(*o); });
}

} // namespace platen::app
