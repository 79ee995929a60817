#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "fit/comparison.hpp"
#include "material/card.hpp"
#include "plot/compare_picture.hpp"
#include "plot/gnuplot.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
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

/// "LAW", "LAW/VARIANT", "LAW,key=value,label=words": a comma without a key after it belongs to the value.
fit::LawItem law_of(const std::string& item) {
  LawArguments law;
  std::string label = item;
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
    if (p.starts_with("label=")) label = p.substr(6);
    return p.starts_with("label=");
  });
  return {card_of(law), parameters_of(law), label};
}

bool is_curve(const std::string& item) { return item.ends_with(".csv"); }

std::vector<double> ends_of(const std::string& ranges) {
  std::vector<double> ends;
  if (!ranges.empty())
    for (const auto& part : law::detail::split(ranges, ',')) {
      const auto end = core::number_from(part);
      if (!end || !(*end > (ends.empty() ? 0 : ends.back())))
        throw InvalidInput(
            fmt::format("--ranges {}: '{}' is not a number above the one before it", ranges, part));
      ends.push_back(*end);
    }
  return ends;
}

nlohmann::ordered_json number_or_null(double v) {
  return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const fit::Comparison& c) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& range : c.ranges)
    for (std::size_t k = 0; k < c.traces.size(); ++k) {
      const fit::Deviation& d = range.deviations[k];
      list.push_back({{"above_delta_bar", range.above},
                      {"to_delta_bar", range.to},
                      {"law", c.traces[k].name},
                      {"rank", d.rank},
                      {"force", number_or_null(d.force)},
                      {"radius", number_or_null(d.radius)},
                      {"stiffness", number_or_null(d.stiffness)},
                      {"lost_work", number_or_null(d.lost_work)},
                      {"in_range", d.in_range}});
    }
  return list;
}

/// --radius_m is of the curves that do not say theirs.
press::Curve curve_of(const std::string& file, const Options& o) {
  const bool says = !core::read_csv(file).note("radius_m").empty();
  return press::read_curve(file, says ? std::nullopt : o.radius_m);
}

fit::Question question_of(const Options& o) {
  const auto first = std::ranges::find_if(o.items, is_curve);
  if (first == o.items.end())
    throw InvalidInput(
        "compare needs a curve to compare with: a CSV of `platen press`, or a measured one with "
        "delta_m and force_N; the first one named is the reference");
  fit::Question q;
  q.reference = {curve_of(*first, o), *first};
  for (auto item = o.items.begin(); item != o.items.end(); ++item) {
    if (item == first) continue;
    if (is_curve(*item)) q.items.push_back(fit::CurveItem{curve_of(*item, o), *item});
    else q.items.push_back(law_of(*item));
  }
  if (!o.material.empty()) q.material = material::read_card(o.material).material;
  LawArguments given;
  given.parameters = o.parameters;
  q.parameters = parameters_of(given);
  q.ends = ends_of(o.ranges);
  return q;
}

void compare(const Options& o) {
  if (!o.picture.empty()) plot::format_of(o.picture); // before any work
  const auto q = question_of(o);
  const auto c = fit::compare(q);
  for (const auto& warning : c.warnings) core::say_line("platen: warning: " + warning);
  if (!o.picture.empty()) plot::compare_picture(q, c, o.title, o.picture);
  const std::string text = o.json ? json_of(c).dump(2) + "\n" : words_of(c, q.reference.curve.material);
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
  command.add_option("--radius_m", o->radius_m,
                     "radius of the particle of measured curves that do not say theirs");
  command.add_option("--title", o->title, "title of the picture");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer(
      "Laws press the curve's sphere on a rigid plane.\n"
      "Example: platen compare out/press/curve.csv agarwal jackson-green thornton-ning,p_y_Pa=2.8e8 "
      "--material von-mises-100 --ranges 0.01,0.1 -o compare.svg");
  command.callback([o] { compare(*o); });
}

} // namespace platen::app
