#include "material/elastic.hpp"

#include "material/card_section.hpp"

namespace platen::material {

const CardSection<Elastic>& Elastic::card() {
  static const auto section = section_of<Elastic>({
      {"E_Pa", &Elastic::E, "Young's modulus", core::positive},
      {"nu", &Elastic::nu, "Poisson's ratio", core::right_open(0, 0.5)},
  });
  return section;
}

} // namespace platen::material
