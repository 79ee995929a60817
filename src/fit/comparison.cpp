#include "fit/comparison.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/law_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace platen::fit {
namespace {

using core::InvalidInput;

bool knows(const law::LawInfo& info, const std::string& key) {
  return std::ranges::any_of(info.parameters, [&](const auto& p) { return p.key == key; }) ||
         std::ranges::any_of(info.words, [&](const auto& w) { return w.key == key; });
}

std::vector<double> ends_of(const std::vector<double>& given, double last) {
  std::vector<double> ends{0};
  for (const double end : given) {
    if (!(end > ends.back()) || !std::isfinite(end))
      throw InvalidInput(
          fmt::format("ranges: '{}' is not a number above the one before it", core::number_text(end)));
    ends.push_back(end);
  }
  if (ends.back() < last) ends.push_back(last);
  return ends;
}

/// What curve, material and the question say of the parameters, the last word last.
law::ParameterTexts shared_of(const Question& q) {
  law::ParameterTexts shared;
  const press::Curve& curve = q.reference.curve;
  if (curve.E_Pa > 0) {
    shared["E_Pa"] = core::number_text(curve.E_Pa);
    shared["nu"] = core::number_text(curve.nu);
  }
  if (curve.sigma_c_Pa > 0) {
    shared["phi_deg"] = core::number_text(curve.phi_deg);
    shared["sigma_c_Pa"] = core::number_text(curve.sigma_c_Pa);
  }
  if (q.material)
    for (const auto& [key, text] : law_words(*q.material)) shared[key] = text;
  for (const auto& [key, text] : q.parameters) shared[key] = text;
  return shared;
}

Trace trace_of(const LawItem& item, const law::ParameterTexts& shared, const Question& q,
               Comparison& comparison) {
  const Reference& reference = comparison.reference;
  const law::LawInfo& info = law::find_law(item.card.law);
  law::ParameterTexts texts{{"radius_m", core::number_text(reference.radius_m)}, {"against", "plane"}};
  for (const auto& [key, text] : shared)
    if (knows(info, key) && (!item.card.parameters.contains(key) || q.parameters.contains(key)))
      texts[key] = text;
  for (const auto& [key, text] : item.parameters) texts[key] = text;
  const law::Law law = make_law(item.card, texts);
  const Validity validity = validity_of(item.card, law);
  Trace trace = trace_of(law, reference, item.label);
  for (std::size_t i = 0; i < reference.delta.size(); ++i)
    trace.in_range[i] = trace.in_range[i] && validity.holds(reference.delta[i]);
  if (const auto outside = std::ranges::count(trace.in_range, false); outside > 0)
    comparison.warnings.push_back(fmt::format("{}: {} of {} points are outside its validity ({})", item.label,
                                              outside, reference.delta.size(), info.validity));
  return trace;
}

std::string percent(double v) {
  if (!std::isfinite(v)) return "–";
  return v < 0.0995 ? fmt::format("{:.1f}", 100 * v) : fmt::format("{:.0f}", 100 * v);
}

const char* validity(double fraction) { return fraction == 1 ? "yes" : fraction == 0 ? "no" : "partly"; }

std::string table(const std::vector<Trace>& traces, const RangeOfOverlap& range) {
  std::string text =
      fmt::format("\n{} < δ/R ≤ {}\n\n| rank | law or curve | force % | radius % | stiffness % | "
                  "lost work % | in range |\n|---|---|---|---|---|---|---|\n",
                  core::number_text(range.above), core::number_text(range.to));
  std::vector<std::size_t> order(traces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    const int rank = range.deviations[i].rank;
    return rank == 0 ? std::numeric_limits<int>::max() : rank;
  });
  for (const std::size_t i : order) {
    const Deviation& d = range.deviations[i];
    fmt::format_to(std::back_inserter(text), "| {} | {} | {} | {} | {} | {} | {} |\n",
                   d.rank == 0 ? "–" : std::to_string(d.rank), traces[i].name, percent(d.force),
                   percent(d.radius), percent(d.stiffness), percent(d.lost_work), validity(d.in_range));
  }
  return text;
}

} // namespace

Comparison compare(const Question& q) {
  Comparison c{reference_of(q.reference.curve, q.reference.label), {}, {}, {}};
  const auto shared = shared_of(q);
  law::ParameterTexts unused = q.parameters;
  for (const auto& item : q.items) {
    if (const auto* curve = std::get_if<CurveItem>(&item)) {
      c.traces.push_back(trace_of(curve->curve, c.reference, curve->label));
      continue;
    }
    const auto& one = std::get<LawItem>(item);
    c.traces.push_back(trace_of(one, shared, q, c));
    std::erase_if(unused, [&](const auto& p) { return knows(law::find_law(one.card.law), p.first); });
  }
  if (!unused.empty())
    throw InvalidInput(fmt::format("{}: none of the laws has this parameter", unused.begin()->first));
  if (c.traces.empty())
    throw InvalidInput("compare needs a law or a second curve beside " + q.reference.label);
  const auto ends = ends_of(q.ends, c.reference.delta.back() / c.reference.radius_m);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    c.ranges.push_back({ends[i], ends[i + 1], deviations(c.reference, c.traces, ends[i], ends[i + 1])});
  return c;
}

std::string words_of(const Comparison& c, const std::string& material) {
  std::string text =
      fmt::format("Reference: {}{}, to δ/R = {}. Deviations are relative L2 over δ; lost work: |difference| "
                  "over the work spent.\n",
                  c.reference.trace.name, material.empty() ? "" : " (" + material + ")",
                  core::number_text(c.reference.delta.back() / c.reference.radius_m));
  for (const auto& range : c.ranges) text += table(c.traces, range);
  return text;
}

} // namespace platen::fit
