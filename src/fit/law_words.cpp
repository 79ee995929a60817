#include "fit/law_words.hpp"

#include "core/number.hpp"
#include "material/card.hpp"
#include "press/strength.hpp"

namespace platen::fit {

law::ParameterTexts law_words(const material::Material& m) {
  law::ParameterTexts texts;
  for (const auto& p : material::parameters(m.model)) {
    const auto dot = p.key.rfind('.');
    texts[dot == std::string::npos ? p.key : p.key.substr(dot + 1)] = core::number_text(p.value);
  }
  if (const auto gamma = texts.find("Gamma_Pa"); gamma != texts.end()) texts["sigma_y_Pa"] = gamma->second;
  if (const auto sigma_c = texts.find("sigma_c_Pa"); sigma_c != texts.end())
    texts["sigma_y_Pa"] = sigma_c->second;
  texts["E_Pa"] = core::number_text(material::initial_E(m.model));
  texts["nu"] = core::number_text(material::initial_nu(m.model));
  if (const auto [phi_deg, sigma_c] = press::drucker_prager_strength(m.model); sigma_c > 0)
    texts["phi_deg"] = core::number_text(phi_deg), texts["sigma_c_Pa"] = core::number_text(sigma_c);
  return texts;
}

} // namespace platen::fit
