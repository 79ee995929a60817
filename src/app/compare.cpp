#include "fit/compare.hpp"
#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "material/card.hpp"
#include "plot/compare_picture.hpp"
#include "plot/gnuplot.hpp"
#include "press/curve_csv.hpp"
#include "press/yield_watch.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

namespace platen::app {
namespace {

using core::InvalidInput;

struct Options {
  std::vector<std::string> items, parameters;
  std::string material, ranges, output, picture, title;
  std::optional<double> radius_m;
  bool json = false;
};

/// A law of the comparison and the name it goes by.
struct Named {
  LawArguments law;
  std::string label;
};

/// "LAW", "LAW/VARIANT", "LAW,key=value,label=words": a comma without a key after it belongs to the value.
Named law_of(const std::string& item) {
  Named named{{}, item};
  LawArguments& law = named.law;
  const auto parts = law::detail::split(item, ',');
  law.law = parts.front();
  if (!core::is_there(law.law))
    if (const auto slash = law.law.find('/'); slash != std::string::npos && !law.law.ends_with(".toml")) {
      law.variant = law.law.substr(slash + 1);
      law.law.resize(slash);
    }
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    if (part->find('=') != std::string::npos || law.parameters.empty()) law.parameters.push_back(*part);
    else law.parameters.back() += "," + *part;
  }
  std::erase_if(law.parameters, [&](const std::string& p) {
    if (p.starts_with("label=")) named.label = p.substr(6);
    return p.starts_with("label=");
  });
  law.against = "plane";
  return named;
}

bool is_curve(const std::string& item) { return item.ends_with(".csv"); }

/// What a material card says in the words of the laws. A model with its strength under another name gives
/// that.
law::ParameterTexts texts_of(const material::Material& m) {
  law::ParameterTexts texts;
  for (const auto& p : material::parameters(m.model)) {
    const auto dot = p.key.rfind('.');
    texts[dot == std::string::npos ? p.key : p.key.substr(dot + 1)] = core::number_text(p.value);
  }
  if (const auto gamma = texts.find("Gamma_Pa"); gamma != texts.end()) texts["sigma_y_Pa"] = gamma->second;
  if (const auto sigma_c = texts.find("sigma_c_Pa"); sigma_c != texts.end())
    texts["sigma_y_Pa"] = sigma_c->second;
  texts["E_Pa"] = core::number_text(material::initial_E(m.model));
  texts["nu"] = core::number_text(material::initial_nu(m.model));
  if (const auto [phi_deg, sigma_c] = press::drucker_prager_strength(m.model); sigma_c > 0)
    texts["phi_deg"] = core::number_text(phi_deg), texts["sigma_c_Pa"] = core::number_text(sigma_c);
  return texts;
}

bool knows(const law::LawInfo& info, const std::string& key) {
  return std::ranges::any_of(info.parameters, [&](const auto& p) { return p.key == key; }) ||
         std::ranges::any_of(info.words, [&](const auto& w) { return w.key == key; });
}

std::vector<double> ends_of(const std::string& ranges, double last) {
  std::vector<double> ends{0};
  if (!ranges.empty())
    for (const auto& part : law::detail::split(ranges, ',')) {
      const auto end = core::number_from(part);
      if (!end || !(*end > ends.back()))
        throw InvalidInput(
            fmt::format("--ranges {}: '{}' is not a number above the one before it", ranges, part));
      ends.push_back(*end);
    }
  if (ends.back() < last) ends.push_back(last);
  return ends;
}

std::string percent(double v) {
  if (!std::isfinite(v)) return "–";
  return v < 0.0995 ? fmt::format("{:.1f}", 100 * v) : fmt::format("{:.0f}", 100 * v);
}

const char* validity(double fraction) { return fraction == 1 ? "yes" : fraction == 0 ? "no" : "partly"; }

/// A Markdown table for one range, nearest first.
std::string table(const std::vector<fit::Trace>& traces, const std::vector<fit::Deviation>& deviations,
                  double low, double high) {
  std::string text =
      fmt::format("\n{} < δ/R ≤ {}\n\n| rank | law or curve | force % | radius % | stiffness % | "
                  "lost work % | in range |\n|---|---|---|---|---|---|---|\n",
                  core::number_text(low), core::number_text(high));
  std::vector<std::size_t> order(traces.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return deviations[i].rank == 0 ? std::numeric_limits<int>::max() : deviations[i].rank;
  });
  for (std::size_t i : order) {
    const fit::Deviation& d = deviations[i];
    fmt::format_to(std::back_inserter(text), "| {} | {} | {} | {} | {} | {} | {} |\n",
                   d.rank == 0 ? "–" : std::to_string(d.rank), traces[i].name, percent(d.force),
                   percent(d.radius), percent(d.stiffness), percent(d.lost_work), validity(d.in_range));
  }
  return text;
}

nlohmann::ordered_json number_or_null(double v) {
  return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}

/// The laws, with what the curve, the material and -p say; a law takes of these what it knows.
std::vector<fit::Trace> traces_of(const Options& o, const fit::Reference& reference,
                                  const press::Curve& first) {
  law::ParameterTexts shared;
  if (first.E_Pa > 0) {
    shared["E_Pa"] = core::number_text(first.E_Pa);
    shared["nu"] = core::number_text(first.nu);
  }
  if (first.sigma_c_Pa > 0) {
    shared["phi_deg"] = core::number_text(first.phi_deg);
    shared["sigma_c_Pa"] = core::number_text(first.sigma_c_Pa);
  }
  if (!o.material.empty())
    for (const auto& [key, text] : texts_of(material::read_card(o.material).material)) shared[key] = text;
  LawArguments given;
  given.parameters = o.parameters;
  const auto asked = parameters_of(given);
  for (const auto& [key, text] : asked) shared[key] = text;
  std::vector<std::string> unused;
  for (const auto& [key, text] : asked) unused.push_back(key);

  std::vector<fit::Trace> traces;
  std::string warnings;
  bool reference_met = false;
  for (const std::string& item : o.items) {
    if (is_curve(item)) {
      if (reference_met)
        traces.push_back(fit::trace_of(press::read_curve(item, o.radius_m), reference, item));
      reference_met = true;
      continue;
    }
    const auto [arguments, label] = law_of(item);
    fit::LawCard card = card_of(arguments);
    const law::LawInfo& info = law::find_law(card.law);
    law::ParameterTexts texts{{"radius_m", core::number_text(reference.radius_m)}};
    for (const auto& [key, text] : shared)
      if (knows(info, key) && (!card.parameters.contains(key) || asked.contains(key))) texts[key] = text;
    std::erase_if(unused, [&](const std::string& key) { return knows(info, key); });
    for (const auto& [key, text] : parameters_of(arguments)) texts[key] = text;
    fit::Trace trace = fit::trace_of(fit::make_law(card, texts), reference, label);
    if (card.delta_bar)
      for (std::size_t i = 0; i < reference.delta.size(); ++i)
        trace.in_range[i] = trace.in_range[i] &&
                            reference.delta[i] <= (*card.delta_bar)[1] * reference.radius_m * (1 + 1e-12);
    const auto outside = std::ranges::count(trace.in_range, false);
    if (outside > 0)
      warnings += fmt::format("platen: warning: {}: {} of {} points are outside its validity ({})\n", label,
                              outside, reference.delta.size(), info.validity);
    traces.push_back(std::move(trace));
  }
  if (!unused.empty())
    throw InvalidInput(fmt::format("-p {}: none of the laws has this parameter", unused.front()));
  core::say(warnings);
  return traces;
}

void compare(const Options& o) {
  const auto first = std::ranges::find_if(o.items, is_curve);
  if (first == o.items.end())
    throw InvalidInput(
        "compare needs a curve to compare with: a CSV of `platen press`, or a measured one with "
        "delta_m and force_N; the first one named is the reference");
  if (!o.picture.empty()) plot::format_of(o.picture); // before any work
  const press::Curve curve = press::read_curve(*first, o.radius_m);
  const fit::Reference reference = fit::reference_of(curve, *first);
  const std::vector<fit::Trace> traces = traces_of(o, reference, curve);
  if (traces.empty()) throw InvalidInput("compare needs a law or a second curve beside " + *first);

  const double last = reference.delta.back() / reference.radius_m;
  const auto ends = ends_of(o.ranges, last);
  std::string text =
      fmt::format("Reference: {}{}, to δ/R = {}. Deviations are relative L2 over δ; lost work: |difference| "
                  "over the work spent.\n",
                  *first, curve.material.empty() ? "" : " (" + curve.material + ")", core::number_text(last));
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const auto deviations = fit::deviations(reference, traces, ends[i], ends[i + 1]);
    text += table(traces, deviations, ends[i], ends[i + 1]);
    for (std::size_t k = 0; k < traces.size(); ++k)
      list.push_back({{"above_delta_bar", ends[i]},
                      {"to_delta_bar", ends[i + 1]},
                      {"law", traces[k].name},
                      {"rank", deviations[k].rank},
                      {"force", number_or_null(deviations[k].force)},
                      {"radius", number_or_null(deviations[k].radius)},
                      {"stiffness", number_or_null(deviations[k].stiffness)},
                      {"lost_work", number_or_null(deviations[k].lost_work)},
                      {"in_range", deviations[k].in_range}});
  }
  if (o.json) text = list.dump(2) + "\n";
  if (!o.picture.empty()) {
    fit::Reference named = reference;
    named.trace.name = curve.experiment.empty() ? *first : "press";
    plot::compare_picture(named, traces,
                          o.title.empty() ? (curve.material.empty() ? *first : curve.material) : o.title,
                          o.picture);
  }
  if (o.output.empty()) fmt::print("{}", text);
  else core::write_file(o.output, text);
}

} // namespace

void add_compare(Command program) {
  auto command = program.add_subcommand("compare", "laws and curves in one picture and one table");
  auto o = std::make_shared<Options>();
  command
      .add_option(
          "ITEMS", o->items,
          "curves (.csv; the first is the reference) and laws: LAW, LAW/VARIANT, LAW,key=value,label=words")
      .required();
  command.add_option("-o", o->picture, "picture, .svg or .png");
  command.add_option("--table", o->output, "file for the table instead of printing it");
  command.add_option("--material", o->material, "material card that gives the laws their parameters");
  command.add_option("-p", o->parameters, "key=value for every law that has the parameter");
  command.add_option("--ranges", o->ranges, "ends of ranges of delta/R, ranked one by one: 0.01,0.1");
  command.add_option("--radius_m", o->radius_m, "radius of the particle of measured curves");
  command.add_option("--title", o->title, "title of the picture");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer(
      "Laws press the curve's sphere on a rigid plane.\n"
      "Example: platen compare out/press/curve.csv agarwal jackson-green thornton-ning,p_y_Pa=2.8e8 "
      "--material von-mises-100 --ranges 0.01,0.1 -o compare.svg");
  command.callback([o] { compare(*o); });
}

} // namespace platen::app
