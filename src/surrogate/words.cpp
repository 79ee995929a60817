#include "surrogate/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

std::string row(const char* what, const Quantiles& q) {
  return fmt::format("  {:<44} {:>7.2f}% {:>7.2f}% {:>7.2f}%\n", what, 100 * q.median, 100 * q.p95,
                     100 * q.worst);
}

std::string title(const std::string& whose) {
  return fmt::format("  {:<44} {:>8} {:>8} {:>8}\n", whose, "median", "95 %", "worst");
}

std::string errors(const std::string& whose, const LeaveOneOut& e) {
  std::string text = title(whose) + row("force over the loading, relative L2", e.force) +
                     row("contact radius, likewise", e.radius) + row("work given back in unloading", e.work) +
                     row("overlap left after unloading, of the largest", e.residual) +
                     fmt::format("  {:.1f} % of their points lie in the 90 % band", 100 * e.coverage);
  if (e.locked > 0) text += fmt::format("; without {} of {} that are said to lock", e.locked, e.materials);
  return text + "\n";
}

std::string errors(const std::string& whose, const RockErrors& e) {
  std::string text = title(whose);
  for (std::size_t k = 0; k < 4; ++k) text += row(coefficient_names[k], e.of[k]);
  return text + row("force over the loading, relative L2", e.force) +
         row("work given back in unloading", e.work);
}

std::string band(double deviations) {
  return fmt::format("  the 90 % band is {:.2f} standard deviations wide to either side\n", deviations);
}

std::string cells(const Quantiles& q) {
  return fmt::format("  {:>6.2f} {:>6.2f} {:>6.2f}", 100 * q.median, 100 * q.p95, 100 * q.worst);
}

std::string form_text(const ClosedForm& form) {
  std::string text = form.of + " =";
  for (std::size_t k = 0; k < form.terms.size(); ++k) {
    const double c = form.coefficients[k];
    text += fmt::format(" {} {:.5g}", c < 0 ? "-" : k > 0 ? "+" : "", std::abs(c));
    if (form.terms[k] != "1") text += " " + form.terms[k];
  }
  return text;
}

} // namespace

std::string words_of(const Surrogate& s, const std::string& file, const Pools* pools) {
  const bool coarse = s.layers.size() > 1;
  std::string text =
      fmt::format("{}: {} of {} materials{}, {} coordinates: {}\n", s.pool, s.fine, s.asked,
                  coarse ? fmt::format(", {} on {}", s.runs.size(),
                                       pools ? "the mesh of " + pools->coarse->name : "a coarse mesh")
                         : "",
                  s.layers.front().inputs.dimensions, file);
  for (const auto& layer : s.layers)
    text += fmt::format(
        "  components: {} of the force, {} of the radius, {} of the work given back, {} of its exponents\n",
        layer.force.basis.size(), layer.radius.basis.size(), layer.work.basis.size(),
        layer.exponent.basis.size());
  if (const auto* first = pools ? coarse ? pools->coarse : &pools->fine : nullptr;
      first && first->not_unloaded + first->locked > 0)
    text += fmt::format(
        "  left aside: {} of which an unloading ends early or is too steep to be fitted, {} that lock\n",
        first->not_unloaded, first->locked);
  text += errors("left out one by one", s.left_out) + band(s.band);
  if (s.guide)
    text += errors(fmt::format("each pressed on {} elements first", s.guide->elements), s.guide->left_out) +
            band(s.guide->band);
  return text;
}

std::string words_of(const Rock& rock, const std::string& file) {
  return fmt::format("{}: {} grains: {}\n", rock.pool, rock.grains.size(), file) +
         errors(fmt::format("{} of them left out one by one", rock.left_out.materials), rock.left_out);
}

std::string words_beside(const Rock& rock, const Rock& other) {
  const auto e = errors_beside(rock, other);
  return errors(fmt::format("{} of {} grains of {}", e.materials, other.grains.size(), other.pool), e);
}

std::string words_beside(const Surrogate& s, const PoolData& other) {
  std::string text;
  for (const bool guided : {false, true}) {
    if (guided && !s.guide) break;
    const auto beside = errors_beside(s, other, guided);
    text +=
        errors(fmt::format("{} materials of {}{}", other.runs.size(), other.name, guided ? ", guided" : ""),
               summary_of(beside, guided ? s.guide->band : s.band));
    for (std::size_t i = 0; i < beside.size(); ++i)
      text += fmt::format("  {:<44} {:>7.2f}% expected {:.2f}%{}\n",
                          fmt::format("{}, force", other.runs[i].material.name), 100 * beside[i].force,
                          100 * beside[i].expected, beside[i].locks ? ", locks" : "");
  }
  return text;
}

std::string words_of(const Methods& m, const std::string& pool) {
  std::string text = fmt::format(
      "{}: granules with E_bar of 4.5 and more, each predicted from the others; errors in per cent\n"
      "  {:<46} {:>8}  {:^20}\n",
      pool, "loading", "granules", "F, relative L2");
  for (const auto& one : m.loading)
    text += fmt::format("  {:<46} {:>8}{}\n", one.name, one.materials, cells(one.force));
  text += fmt::format("  {:<46} {:>8}  {:^20}  {:^20}\n", "unloading, the force as pressed", "",
                      "work given back", "overlap left");
  for (const auto& one : m.unloading)
    text +=
        fmt::format("  {:<46} {:>8}{}{}\n", one.name, one.materials, cells(one.work), cells(one.residual));
  text += "  (median, 95 %, worst); closed form, x = ln(delta_bar), y = ln(E_bar/Gamma_bar):\n";
  for (const auto& form : m.forms) text += fmt::format("  {}\n", form_text(form));
  return text;
}

std::string words_of(const Rock& rock, const std::vector<RockMethod>& methods) {
  std::string text = fmt::format(
      "{}: {} grains, each predicted from the others; errors in per cent: median, 95 %, worst\n  {:<48} "
      "{:>6}",
      rock.pool, rock.grains.size(), "", "grains");
  for (const char* what : {"a", "b", "m", "n", "F, relative L2", "work given back"})
    text += fmt::format("  {:^20}", what);
  text += "\n";
  for (const auto& [name, e] : methods) {
    text += fmt::format("  {:<48} {:>6}", name, e.materials);
    for (const auto& q : e.of) text += cells(q);
    text += cells(e.force) + cells(e.work) + "\n";
  }
  return text;
}

std::string words_of(const Sensitivity& s, const std::string& material, double within) {
  std::string text =
      fmt::format("{}: Sobol indices through the surrogate of pool {}, each number within {:.3g} of itself; "
                  "alone, and with others\n  {:<33}",
                  material, s.pool, within, "");
  for (const auto& output : s.outputs) text += fmt::format("  {:>24}", output);
  text += fmt::format("\n  {:<33}", "deviation");
  for (const double deviation : s.deviation) text += fmt::format("  {:>22.1f} %", 100 * deviation);
  text += "\n";
  for (const auto& n : s.numbers) {
    text += fmt::format("  {:<12} {:>20}", n.key, fmt::format("{:.3g} to {:.3g}", n.low, n.high));
    for (std::size_t k = 0; k < s.outputs.size(); ++k)
      text += fmt::format("  {:>24}", fmt::format("{:.2f}  {:.2f}", std::max(0.0, n.alone[k]), n.total[k]));
    text += "\n";
  }
  return text;
}

} // namespace platen::surrogate
