#include "material/von_mises.hpp"

#include "core/error.hpp"
#include "material/hardening_card.hpp"

#include <fmt/format.h>

namespace platen::material {
namespace {

using core::Field, core::positive, core::right_open;

/// `own`: of a hardening law that knows its yield stress.
const std::vector<Field<VonMises>>& fields(bool own) {
  static const Field<VonMises> E{"E_Pa", &VonMises::E, "Young's modulus", positive},
      nu{"nu", &VonMises::nu, "Poisson's ratio", right_open(0, 0.5)};
  static const std::vector<Field<VonMises>> alone{E, nu},
      beside_sigma_y{{"sigma_y_Pa", &VonMises::sigma_y, "uniaxial yield stress", positive},
                     Field<VonMises>(E).or_ratio("E_bar", "sigma_y_Pa"),
                     nu};
  return own ? alone : beside_sigma_y;
}

VonMises read(const core::Table& table, std::span<const std::string> others) {
  const Hardening hardening = read_hardening(table);
  const bool own = has_own_yield_stress(hardening);
  for (const char* key : {"sigma_y_Pa", "E_bar"})
    if (own && table.find(key))
      throw core::InvalidInput(
          fmt::format("{}: this hardening has its own yield stress; leave it out, and give E_Pa",
                      core::place(table, key)));
  std::vector<std::string> known(others.begin(), others.end());
  known.push_back("hardening");
  VonMises m = core::read_fields<VonMises>(table, fields(own), {0, 0, 0, hardening}, known);
  m.sigma_y = initial_yield_stress(hardening, m.E, m.sigma_y);
  check_hardening(table, hardening, m.E, m.moduli(0).G, m.sigma_y);
  return m;
}

} // namespace

const CardSection<VonMises>& VonMises::card() {
  static const CardSection<VonMises> section{core::infos<VonMises>(fields(false)), read,
                                             [](const VonMises& m) {
                                               auto entries =
                                                   entries_of(fields(has_own_yield_stress(m.hardening)), m);
                                               for (auto& entry : hardening_entries(m.hardening))
                                                 entries.push_back(std::move(entry));
                                               return entries;
                                             },
                                             hardening_reference()};
  return section;
}

} // namespace platen::material
