#include "calibrate/compaction_files.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/toml.hpp"
#include "core/unit.hpp"
#include "core/version.hpp"
#include "material/card.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace platen::calibrate {
namespace {

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

} // namespace

Compaction compaction(const CompactionFiles& f) {
  if (f.model != "vmdc" && f.model != "dpc")
    throw core::InvalidInput(fmt::format("--model {}: it must be vmdc or dpc", f.model));
  if (!(f.rho_r0 > 0 && f.rho_r0 <= 1)) throw core::InvalidInput("--rho_r0 must be in (0, 1]");
  const auto test = core::read_csv(f.test), tablets = core::read_csv(f.strengths);
  const auto rho = densities(test), axial = column(test, "axial_stress"),
             radial = column(test, "radial_stress");
  std::vector<CompactionRow> rows;
  for (std::size_t i = 0; i < rho.size(); ++i) rows.push_back({rho[i], axial[i], radial[i]});
  const auto at = densities(tablets), compressive = column(tablets, "compressive_strength"),
             tensile = column(tablets, "tensile_strength");
  std::vector<StrengthRow> strengths;
  for (std::size_t i = 0; i < at.size(); ++i) strengths.push_back({at[i], compressive[i], tensile[i]});
  return compaction(rows, strengths, f.rho_r0, f.model, f.name.empty() ? "powder of " + f.test : f.name);
}

std::string words_of(const Compaction& c, const CompactionFiles& f) {
  std::string text =
      fmt::format("material {}, from {} rows of loading and {} {}, rho_r0 = {:.4g}\n", f.model,
                  c.loading_rows, c.unloadings, c.unloadings == 1 ? "unloading" : "unloadings", f.rho_r0);
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

std::string card_of(const Compaction& c, const CompactionFiles& f) {
  std::string text = card_text(c.material) + "\n[source]\n";
  std::string all = fmt::format("die compaction {} and strengths {}, by platen (engine {})", f.test,
                                f.strengths, core::engine);
  for (const auto& sentence : c.said) all += "; " + sentence;
  text += fmt::format("default = {}\n", core::in_quotes(all));
  for (const auto& t : c.trends)
    text += fmt::format(
        "{} = {}\n", t.key,
        core::in_quotes(fmt::format("regression of {} points over rho_r {:.3g} to {:.3g}, R2 = {:.4f}",
                                    t.points, t.low, t.high, t.R2)));
  return text;
}

} // namespace platen::calibrate
