#include "calibrate/compaction.hpp"
#include "app/commands.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/toml.hpp"
#include "core/unit.hpp"
#include "core/version.hpp"
#include "material/card.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string test, strengths, card, model = "vmdc", name;
  double rho_r0 = 0;
  bool json = false;
};

/// A column of numbers; of a stress under any unit at its end, in Pa.
std::vector<double> column(const core::Csv& csv, const std::string& name) {
  std::size_t at = csv.columns.size();
  double in_si = 1;
  for (std::size_t k = 0; k < csv.columns.size(); ++k) {
    const auto& head = csv.columns[k];
    if (head == name) at = k;
    else if (head.starts_with(name + "_")) at = k, in_si = core::in_units_of(name + "_Pa", head);
  }
  if (at == csv.columns.size())
    throw core::InvalidInput(fmt::format("{}: there is no column {}{}; it has {}", csv.file, name,
                                         name == "rho_r" ? "" : " with its unit, as " + name + "_MPa",
                                         fmt::join(csv.columns, ", ")));
  std::vector<double> values;
  for (const auto& row : csv.rows) values.push_back(in_si * csv.number(row, at));
  return values;
}

std::vector<double> densities(const core::Csv& csv) {
  auto rho = column(csv, "rho_r");
  for (std::size_t i = 0; i < rho.size(); ++i)
    if (!(rho[i] > 0 && rho[i] <= 1.05))
      throw core::InvalidInput(
          fmt::format("{}, line {}: rho_r = {:.6g} is no relative density, which is in (0, 1]: "
                      "density over that of the solid",
                      csv.file, csv.rows[i].line, rho[i]));
  return rho;
}

std::string words_of(const calibrate::Compaction& c, const Options& o) {
  std::string text =
      fmt::format("material {}, from {} rows of loading and {} {}, rho_r0 = {:.4g}\n", o.model,
                  c.loading_rows, c.unloadings, c.unloadings == 1 ? "unloading" : "unloadings", o.rho_r0);
  for (const auto& t : c.trends)
    text += fmt::format("  {:<11} {:<10.4g} {:<6} {:<9.4g} R2 = {:.4f}, {} points, rho_r {:.3g} to {:.3g}\n",
                        t.key, t.value, t.growth_key, t.growth, t.R2, t.points, t.low, t.high);
  if (c.axial_l2 > 0)
    text += fmt::format(
        "  a material point reproduces the loading within {:.2g} % in axial and {:.2g} % in radial stress "
        "(relative L2)\n",
        100 * c.axial_l2, 100 * c.radial_l2);
  for (const auto& sentence : c.said) text += sentence + "\n";
  return text;
}

std::string json_of(const calibrate::Compaction& c, const Options& o) {
  nlohmann::ordered_json trends = nlohmann::ordered_json::array();
  for (const auto& t : c.trends)
    trends.push_back({{"key", t.key},
                      {"value", t.value},
                      {"growth", t.growth_key},
                      {"of_growth", t.growth},
                      {"R2", t.R2},
                      {"points", t.points},
                      {"rho_r", {t.low, t.high}}});
  return nlohmann::ordered_json{{"model", o.model},
                                {"rho_r0", o.rho_r0},
                                {"trends", trends},
                                {"axial_relative_l2", c.axial_l2},
                                {"radial_relative_l2", c.radial_l2},
                                {"remarks", c.said}}
             .dump(2) +
         "\n";
}

std::string card_of(const calibrate::Compaction& c, const Options& o) {
  std::string text = card_text(c.material) + "\n[source]\n";
  std::string all = fmt::format("die compaction {} and strengths {}, by platen (engine {})", o.test,
                                o.strengths, core::engine);
  for (const auto& sentence : c.said) all += "; " + sentence;
  text += fmt::format("default = {}\n", core::in_quotes(all));
  for (const auto& t : c.trends)
    text += fmt::format(
        "{} = {}\n", t.key,
        core::in_quotes(fmt::format("regression of {} points over rho_r {:.3g} to {:.3g}, R2 = {:.4f}",
                                    t.points, t.low, t.high, t.R2)));
  return text;
}

void run_compaction(const Options& o) {
  if (o.model != "vmdc" && o.model != "dpc")
    throw core::InvalidInput(fmt::format("--model {}: it must be vmdc or dpc", o.model));
  if (!(o.rho_r0 > 0 && o.rho_r0 <= 1)) throw core::InvalidInput("--rho_r0 must be in (0, 1]");
  const auto test = core::read_csv(o.test), tablets = core::read_csv(o.strengths);
  const auto rho = densities(test), axial = column(test, "axial_stress"),
             radial = column(test, "radial_stress");
  std::vector<calibrate::CompactionRow> rows;
  for (std::size_t i = 0; i < rho.size(); ++i) rows.push_back({rho[i], axial[i], radial[i]});
  const auto at = densities(tablets), compressive = column(tablets, "compressive_strength"),
             tensile = column(tablets, "tensile_strength");
  std::vector<calibrate::StrengthRow> strengths;
  for (std::size_t i = 0; i < at.size(); ++i) strengths.push_back({at[i], compressive[i], tensile[i]});
  const auto c = calibrate::compaction(rows, strengths, o.rho_r0, o.model,
                                       o.name.empty() ? "powder of " + o.test : o.name);
  if (!o.card.empty()) core::write_file(o.card, card_of(c, o));
  fmt::print(report_stream(o.card), "{}", o.json ? json_of(c, o) : words_of(c, o));
}

} // namespace

void add_compaction(Command program) {
  auto command =
      program.add_subcommand("compaction", "a porous material from die compaction and tablet strengths");
  auto o = std::make_shared<Options>();
  command
      .add_option("TEST.csv", o->test,
                  "rho_r, axial_stress_MPa, radial_stress_MPa (or _Pa, _kPa), in the order of the test")
      .required();
  command
      .add_option("--strengths", o->strengths,
                  "rho_r, compressive_strength_MPa (uniaxial), tensile_strength_MPa (diametral) of tablets")
      .required()
      .type_name("TABLETS.csv");
  command.add_option("--rho_r0", o->rho_r0, "relative density of the granules that will be pressed")
      .required()
      .type_name("NUMBER");
  command.add_option("--model", o->model, "vmdc or dpc").type_name("NAME").capture_default_str();
  command.add_option("--name", o->name, "name of the material").type_name("TEXT");
  command.add_option("-o", o->card, "write the material card here").type_name("CARD.toml");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Example: platen compaction die.csv --strengths tablets.csv --rho_r0 0.5 -o powder.toml");
  command.callback([o] { run_compaction(*o); });
}

} // namespace platen::app
