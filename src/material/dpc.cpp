#include "material/dpc.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "material/porous_card.hpp"

#include <fmt/format.h>

namespace platen::material {
namespace {

Dpc checked(const core::Table& table, const Dpc& m) {
  if (m.cap_fits()) return m;
  throw core::InvalidInput(fmt::format(
      "{}: the cap would begin inside the failure line; epsilon Gamma = {} must be less than sigma_y = {}",
      core::place(table, "epsilon"), core::number_text(m.epsilon * m.Gamma), core::number_text(m.sigma_y)));
}

} // namespace

const CardSection<Dpc>& Dpc::card() {
  static const auto section = [] {
    auto fields = porous_fields<Dpc>();
    fields.push_back(core::Field<Dpc>{"published_flow", &Dpc::published_flow,
                                      "the paper's potential, whose plastic power can be negative"}
                         .optional());
    return section_of<Dpc>(fields, checked, std::identity{}, "epsilon Gamma must be less than sigma_y.\n");
  }();
  return section;
}

} // namespace platen::material
