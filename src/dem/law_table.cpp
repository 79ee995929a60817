#include "dem/law_table.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <iterator>

namespace platen::dem {

std::string law_table(const fit::LawCard& card, const law::Law& law, const std::vector<double>& overlaps) {
  std::string text =
      fmt::format("# law = {}\n# variant = {}\n", card.law, card.variant.empty() ? "default" : card.variant);
  for (const auto& [key, value] : card.parameters) text += fmt::format("# {} = {}\n", key, value);
  text += "# unloading: F = force_N (1 - unloading_rate_per_m (overlap_max - overlap))^unloading_exponent\n"
          "overlap_m,force_N,stiffness_N_per_m,contact_radius_m,unloading_rate_per_m,unloading_exponent,in_"
          "range\n";
  if (overlaps.empty()) throw core::InvalidInput("a table needs at least one overlap");
  if (overlaps.front() > overlaps.back())
    throw core::InvalidInput("a table rises: --overlap FROM:TO:COUNT needs FROM < TO");
  for (double overlap : overlaps) {
    if (!(overlap > 0)) throw core::InvalidInput("a table needs overlaps above 0; at 0 the force is 0");
    if (const double last = law::TableView::x_limit / law.scale.x_per_gamma; !(overlap <= last))
      throw core::InvalidInput(
          fmt::format("overlap {} m: beyond {} m laws are held constant; end the table before",
                      core::number_text(overlap), core::number_text(last)));
    const auto r = law::evaluate(law, {}, overlap);
    const auto end = law::unloading_at(law, overlap);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", core::number_text(overlap),
                   core::number_text(r.force), core::number_text(r.stiffness),
                   core::number_text(r.contact_radius), core::number_text(end.rate),
                   core::number_text(end.alpha), r.in_range ? "true" : "false");
  }
  return text;
}

} // namespace platen::dem
