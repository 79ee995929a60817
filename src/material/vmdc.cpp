#include "material/vmdc.hpp"

#include "material/porous_card.hpp"

namespace platen::material {

const CardSection<Vmdc>& Vmdc::card() {
  static const auto section = section_of<Vmdc>(porous_fields<Vmdc>());
  return section;
}

} // namespace platen::material
