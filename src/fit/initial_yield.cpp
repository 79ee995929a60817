#include "fit/initial_yield.hpp"

#include "core/number.hpp"
#include "fit/law_card.hpp"
#include "platen/law/wang.hpp"

namespace platen::fit {

InitialYield initial_yield(const law::ParameterTexts& texts) {
  (void)make_law(find_law_card("wang"), texts); // refuses what is no geometry or material
  const law::LawInfo& info = law::find_law("wang");
  law::ParameterTexts second = texts;
  if (texts.contains("E2_Pa")) second["E_Pa"] = texts.at("E2_Pa");
  if (texts.contains("nu2")) second["nu"] = texts.at("nu2");
  const law::Reader a(info, texts, "generic"), b(info, second, "generic");
  const double R = a("radius_m"), R2 = a.given("radius2_m") ? a("radius2_m") : R;
  const auto law = a.word("against") == "plane"
                       ? law::prepare_on_rigid_plane(law::WangMaterial::read(a), R)
                       : law::prepare(law::WangMaterial::read(a), R, law::WangMaterial::read(b), R2);
  const auto number = [&](const std::string& key) { return core::number_from(texts.at(key)).value(); };
  const auto yield_of = [&](const std::string& nu) {
    return law::drucker_prager_yield(number(nu), number("phi_deg"), number("sigma_c_Pa"));
  };
  auto yield = yield_of("nu");
  if (texts.contains("nu2"))
    if (const auto other = yield_of("nu2"); other.p0 < yield.p0) yield = other;
  return {law.F_y, law.gamma_y, yield.u, yield.p0, law.F_y_edge};
}

} // namespace platen::fit
