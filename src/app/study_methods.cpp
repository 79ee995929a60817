#include "app/study_methods.hpp"

#include "study/card.hpp"
#include "surrogate/methods.hpp"
#include "surrogate/rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::string pool, file;
  std::vector<std::string> with;
};

std::string cells(const surrogate::Quantiles& q) {
  return fmt::format("  {:>6.2f} {:>6.2f} {:>6.2f}", 100 * q.median, 100 * q.p95, 100 * q.worst);
}

void print_rock(const Options& o) {
  const auto rock = surrogate::rock_of_pool(o.pool);
  fmt::print("{}: {} grains, each predicted from the others; errors in per cent: median, 95 %, worst\n",
             rock.pool, rock.grains.size());
  fmt::print("  {:<48} {:>6}", "", "grains");
  for (const char* what : {"a", "b", "m", "n", "F, relative L2", "work given back"})
    fmt::print("  {:^20}", what);
  fmt::print("\n");
  for (const auto& [name, e] : surrogate::rock_methods(rock)) {
    fmt::print("  {:<48} {:>6}", name, e.materials);
    for (const auto& q : e.of) fmt::print("{}", cells(q));
    fmt::print("{}{}\n", cells(e.force), cells(e.work));
  }
}

std::string form_text(const surrogate::ClosedForm& form) {
  std::string text = form.of + " =";
  for (std::size_t k = 0; k < form.terms.size(); ++k) {
    const double c = form.coefficients[k];
    text += fmt::format(" {} {:.5g}", c < 0 ? "-" : k > 0 ? "+" : "", std::abs(c));
    if (form.terms[k] != "1") text += " " + form.terms[k];
  }
  return text;
}

void print_granules(const Options& o) {
  auto data = surrogate::read_pool_data(o.pool);
  for (const auto& pool : o.with) surrogate::append(data, surrogate::read_pool_data(pool));
  const auto s = o.file.empty() ? surrogate::fit_surrogate({data}) : surrogate::read_surrogate(o.file);
  const auto m = surrogate::methods_side_by_side(s, data);
  fmt::print("{}: granules with E_bar of 4.5 and more, each predicted from the others; errors in per cent\n"
             "  {:<46} {:>8}  {:^20}\n",
             data.name, "loading", "granules", "F, relative L2");
  for (const auto& one : m.loading)
    fmt::print("  {:<46} {:>8}{}\n", one.name, one.materials, cells(one.force));
  fmt::print("  {:<46} {:>8}  {:^20}  {:^20}\n", "unloading, the force as pressed", "", "work given back",
             "overlap left");
  for (const auto& one : m.unloading)
    fmt::print("  {:<46} {:>8}{}{}\n", one.name, one.materials, cells(one.work), cells(one.residual));
  fmt::print("  (median, 95 %, worst); closed form, x = ln(delta_bar), y = ln(E_bar/Gamma_bar):\n");
  for (const auto& form : m.forms) fmt::print("  {}\n", form_text(form));
}

void compare(const Options& o) {
  const auto study = study::read_study((std::filesystem::path(o.pool) / "study.toml").string());
  if (std::ranges::find(study.laws, "wang") != study.laws.end()) print_rock(o);
  else print_granules(o);
}

} // namespace

void add_study_methods(Command study) {
  auto command = study.add_subcommand("methods", "ways to predict the materials of a pool, side by side");
  auto o = std::make_shared<Options>();
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv").required();
  command.add_option("--with", o->with, "pools of other materials that were pressed alike").type_name("POOL");
  command
      .add_option("--surrogate", o->file,
                  "the surrogate of these pools, as `platen study surrogate` wrote it; default: made anew")
      .type_name("FILE");
  command.footer("Example: platen study methods catalogue/pools/wang");
  command.callback([o] { compare(*o); });
}

} // namespace platen::app
