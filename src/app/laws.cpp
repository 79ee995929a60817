#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "fit/initial_yield.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>

namespace platen::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string name;
  std::vector<std::string> parameters;
  bool json = false;
};

Json json_of(const law::LawInfo& info) {
  Json parameters = Json::array();
  for (const auto& p : info.parameters)
    parameters.push_back({{"key", p.key},
                          {"meaning", p.meaning},
                          {"range", law::text(p.range)},
                          {"required", std::isnan(p.fallback)}});
  for (const auto& w : info.words)
    parameters.push_back({{"key", w.key}, {"meaning", w.meaning}, {"values", w.values}, {"required", false}});
  return {{"name", info.name},
          {"title", info.title},
          {"source", info.source},
          {"validity", info.validity},
          {"variants", law::detail::split(info.variants, '|')},
          {"parameters", parameters}};
}

const law::LawInfo& named(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& info : law::laws()) {
    if (info.name == name) return info;
    known.emplace_back(info.name);
  }
  throw core::InvalidInput(fmt::format("there is no law '{}'{}", name, core::suggestion(name, known)));
}

void print_law(const law::LawInfo& info) {
  fmt::print("{}: {}\n  source    {}\n  valid     {}\n  variants  {} (first is the default)\n\n", info.name,
             info.title, info.source, info.validity, fmt::join(law::detail::split(info.variants, '|'), ", "));
  for (const auto& p : info.parameters)
    fmt::print("  {:<17} {:<14} {}{}\n", p.key, law::text(p.range), p.meaning,
               std::isnan(p.fallback) ? "" : " (optional)");
  for (const auto& w : info.words)
    fmt::print("  {:<17} {} {}(optional)\n", w.key, w.meaning,
               w.values.empty() ? "" : fmt::format("({}) ", w.values));
  fmt::print("\n  A second body that is not described is like the first.\n");
}

void print_initial_yield(const Options& options, bool as_json) {
  LawArguments arguments;
  arguments.law = "wang";
  arguments.parameters = options.parameters;
  const auto y = fit::initial_yield(parameters_of(arguments));
  if (as_json) {
    fmt::print("{}\n", Json{{"F_y_N", y.F_y_N},
                            {"gamma_y_m", y.gamma_y_m},
                            {"depth_over_a", y.depth_over_a},
                            {"p0_Pa", y.p0_Pa},
                            {"F_y_edge_N", y.F_y_edge_N}}
                           .dump(2));
    return;
  }
  fmt::print("initial yield\n  F_y      {} N   on the axis; the law's unit of force\n"
             "  gamma_y  {} m   whole approach of the centres\n"
             "  u        {}   depth of first yield over the contact radius\n"
             "  p0       {} Pa   peak pressure there\n"
             "  edge     {} N   the edge of the contact yields{}\n",
             core::number_text(y.F_y_N), core::number_text(y.gamma_y_m), core::number_text(y.depth_over_a),
             core::number_text(y.p0_Pa), core::number_text(y.F_y_edge_N),
             y.F_y_edge_N < y.F_y_N ? ", before the axis does" : "");
}

void laws(const Options& options) {
  if (options.name.empty()) {
    Json list = Json::array();
    for (const auto& info : law::laws())
      if (options.json) list.push_back(json_of(info));
      else fmt::print("{:<14} {}\n", info.name, info.title);
    if (options.json) fmt::print("{}\n", list.dump(2));
    return;
  }
  const law::LawInfo& info = named(options.name);
  if (!options.parameters.empty()) {
    if (info.name != "wang")
      throw core::InvalidInput("-p is for `platen laws wang`, which prints its initial yield");
    return print_initial_yield(options, options.json);
  }
  if (options.json) fmt::print("{}\n", json_of(info).dump(2));
  else print_law(info);
}

} // namespace

void add_laws(Command program) {
  auto command = program.add_subcommand("laws", "list the contact laws, or the parameters of one");
  auto options = std::make_shared<Options>();
  command.add_option("NAME", options->name, "name of a law");
  command.add_option("-p", options->parameters,
                     "key=value; with `wang`, prints where the material first yields");
  command.add_flag("--json", options->json, "for a machine to read");
  command.footer(
      "Example: platen laws wang -p radius_m=0.1 -p E_Pa=1e10 -p nu=0.15 -p phi_deg=25 -p sigma_c_Pa=15e6");
  command.callback([options] { laws(*options); });
}

} // namespace platen::app
