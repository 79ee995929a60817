#include "app/derive_local.hpp"

#include "app/press_into.hpp"
#include "app/wang_report.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "fit/derivation.hpp"

#include <fmt/format.h>

namespace platen::app {
std::optional<std::vector<double>> unloading_list(const std::string& text) {
  if (text.empty()) return {};
  std::vector<double> list;
  if (text == "none") return list;
  for (const auto& part : law::detail::split(text, ',')) {
    const auto number = core::number_from(part);
    if (!number)
      throw core::InvalidInput(fmt::format(
          "--unload_from {}: '{}' is not a number; write 0.1,0.3 (in units of the radius), or none", text,
          part));
    list.push_back(*number);
  }
  return list;
}

void derive_local(const LocalDerivation& d) {
  const press::Case c = fit::local_derivation(
      d.material, d.radius_m, {d.delta_bar_max, d.force_max_N, unloading_list(d.unload_from)});
  const core::OutputFolder folder(d.folder);
  const press::Result result = press_into(c, folder, plot::Fields::pictures).result;
  print_flags(result);
  const fit::WangFit fit = fit::fit_wang(result.curve);
  for (const auto& sentence : fit.notes) core::say_line(fmt::format("note: {}", sentence));
  plot::write_law(result.curve, fit, folder);
  if (d.json) {
    fmt::print("{}", wang_json(result.curve, fit));
    return;
  }
  const auto& end = *press::loading_end(result.curve);
  fmt::print("{}: pressed to F = {:.4g} N, delta_bar = {:.4g}, contact radius {:.3g} R, in {:.1f} s\n{}",
             c.material.name, end.force_N, end.delta_bar, end.contact_radius_m / c.radius_m,
             result.statistics.total_s, wang_words(fit));
  fmt::print(
      "  law card        {0}/law.toml\n  curve           {0}/curve.csv, with the law {0}/curve.svg, with "
      "Hertz {0}/approach.svg\n  under the load  {0}/pressure.svg, {0}/zones.svg, {0}/peaks.svg\n"
      "  input, summary  {0}/case.toml, {0}/summary.json\n",
      folder.path().string());
}

} // namespace platen::app
