#include "app/study_surrogate.hpp"

#include "core/file.hpp"
#include "study/card.hpp"
#include "surrogate/rock.hpp"
#include "surrogate/surrogate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::string pool, coarse, guide, output;
  std::vector<std::string> with, beside;
};

std::string row(const char* what, const surrogate::Quantiles& q) {
  return fmt::format("  {:<44} {:>7.2f}% {:>7.2f}% {:>7.2f}%\n", what, 100 * q.median, 100 * q.p95,
                     100 * q.worst);
}

void print_errors(const std::string& whose, const surrogate::LeaveOneOut& e) {
  fmt::print("  {:<44} {:>8} {:>8} {:>8}\n", whose, "median", "95 %", "worst");
  fmt::print("{}{}{}{}", row("force over the loading, relative L2", e.force),
             row("contact radius, likewise", e.radius), row("work given back in unloading", e.work),
             row("overlap left after unloading, of the largest", e.residual));
  fmt::print("  {:.1f} % of their points lie in the 90 % band", 100 * e.coverage);
  if (e.locked > 0) fmt::print("; without {} of {} that are said to lock", e.locked, e.materials);
  fmt::print("\n");
}

void print_beside(const surrogate::Surrogate& s, const surrogate::PoolData& other) {
  for (const bool guided : {false, true}) {
    if (guided && !s.guide) break;
    const auto errors = surrogate::errors_beside(s, other, guided);
    print_errors(fmt::format("{} materials of {}{}", other.runs.size(), other.name, guided ? ", guided" : ""),
                 surrogate::summary_of(errors, guided ? s.guide->band : s.band));
    for (std::size_t i = 0; i < errors.size(); ++i)
      fmt::print("  {:<44} {:>7.2f}% expected {:.2f}%{}\n",
                 fmt::format("{}, force", other.runs[i].material.name), 100 * errors[i].force,
                 100 * errors[i].expected, errors[i].locks ? ", locks" : "");
  }
}

void make_rock(const Options& o) {
  const auto rock = surrogate::rock_of_pool(o.pool);
  const auto file =
      o.output.empty() ? std::filesystem::path(o.pool) / "grains.csv" : std::filesystem::path(o.output);
  core::write_file(file, surrogate::text_of(rock));
  const auto& e = rock.left_out;
  fmt::print("{}: {} grains: {}\n  {:<44} {:>8} {:>8} {:>8}\n", rock.pool, rock.grains.size(), file.string(),
             fmt::format("{} of them left out one by one", e.materials), "median", "95 %", "worst");
  for (std::size_t k = 0; k < 4; ++k) fmt::print("{}", row(surrogate::coefficient_names[k], e.of[k]));
  fmt::print("{}{}", row("force over the loading, relative L2", e.force),
             row("work given back in unloading", e.work));
}

void make(const Options& o) {
  const auto study = study::read_study((std::filesystem::path(o.pool) / "study.toml").string());
  if (std::ranges::find(study.laws, "wang") != study.laws.end()) return make_rock(o);
  auto data = surrogate::read_pool_data(o.pool);
  for (const auto& pool : o.with) surrogate::append(data, surrogate::read_pool_data(pool));
  std::optional<surrogate::PoolData> coarse, guide;
  if (!o.coarse.empty()) coarse = surrogate::read_pool_data(o.coarse);
  if (!o.guide.empty()) guide = surrogate::read_pool_data(o.guide);
  const auto s = surrogate::fit_surrogate({data, coarse ? &*coarse : nullptr, guide ? &*guide : nullptr});
  const auto file =
      o.output.empty() ? std::filesystem::path(o.pool) / "surrogate.txt" : std::filesystem::path(o.output);
  core::write_file(file, surrogate::text_of(s));
  fmt::print("{}: {} of {} materials{}, {} coordinates: {}\n", s.pool, s.fine, s.asked,
             coarse ? fmt::format(", {} on the mesh of {}", s.runs.size(), coarse->name) : "",
             s.layers.front().inputs.dimensions, file.string());
  for (const auto& layer : s.layers)
    fmt::print(
        "  components: {} of the force, {} of the radius, {} of the work given back, {} of its exponents\n",
        layer.force.basis.size(), layer.radius.basis.size(), layer.work.basis.size(),
        layer.exponent.basis.size());
  const auto& first = coarse ? *coarse : data;
  if (first.too_steep + first.locked > 0)
    fmt::print("  left aside: {} that unload too steeply for alpha and beta to be fitted, {} that lock\n",
               first.too_steep, first.locked);
  print_errors("left out one by one", s.left_out);
  fmt::print("  the 90 % band is {:.2f} standard deviations wide to either side\n", s.band);
  if (s.guide) {
    print_errors(fmt::format("each with a press on {} elements first", s.guide->elements), s.guide->left_out);
    fmt::print("  the 90 % band is {:.2f} standard deviations wide to either side\n", s.guide->band);
  }
  for (const auto& pool : o.beside) print_beside(s, surrogate::read_pool_data(pool, surrogate::Take::all));
}

} // namespace

void add_study_surrogate(Command study) {
  auto command = study.add_subcommand("surrogate", "interpolate a data pool, for `platen predict`");
  auto o = std::make_shared<Options>();
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv").required();
  command.add_option("--with", o->with, "pools of other materials that were pressed alike").type_name("POOL");
  command.add_option("--coarse", o->coarse, "pool of the same study, and more of it, on fewer elements")
      .type_name("POOL");
  command
      .add_option("--guide", o->guide,
                  "likewise, on so few elements that a material may be pressed before it is "
                  "predicted")
      .type_name("POOL");
  command.add_option("-o", o->output, "the file; default surrogate.txt in its folder, of rock grains.csv")
      .type_name("FILE");
  command
      .add_option("--beside", o->beside, "pools that it is not made of: how well it says what they pressed")
      .type_name("POOL");
  command.footer("Example: platen study surrogate catalogue/pools/von-mises -o out/von-mises.txt");
  command.callback([o] { make(*o); });
}

} // namespace platen::app
