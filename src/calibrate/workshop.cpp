#include "calibrate/workshop.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <algorithm>
#include <cmath>

namespace platen::calibrate {

double Coordinates::inside(std::size_t k, double value) const {
  return task.free[k].logarithmic ? std::log(value / unit(k)) : value;
}
double Coordinates::outside(std::size_t k, double theta) const {
  return task.free[k].logarithmic ? unit(k) * std::exp(theta) : theta;
}
double Coordinates::slope(std::size_t k, double theta) const {
  return task.free[k].logarithmic ? outside(k, theta) : 1;
}

law::ParameterTexts Workshop::texts_of(const double* theta) const {
  const Coordinates c{task_};
  law::ParameterTexts texts;
  for (std::size_t k = 0; k < task_.free.size(); ++k) { // differences at a bound must not step over it
    const double value =
        std::clamp(c.outside(k, theta[k]) / c.unit(k), task_.free[k].low, task_.free[k].high);
    texts[task_.free[k].key] = core::number_text(value * c.unit(k));
  }
  return texts;
}

double Workshop::ratio(const law::ParameterTexts& texts) const {
  const auto value = [&](const std::string& key) {
    const auto found = texts.find(key);
    if (found != texts.end()) return core::number_from(found->second).value_or(0);
    const auto given = task_.card.parameters.find(key);
    return given == task_.card.parameters.end() ? 0 : core::number_from(given->second).value_or(0);
  };
  const double strength = value(task_.strength);
  return strength > 0 ? value("E_Pa") / strength : 0;
}

std::shared_ptr<const AnyLaw> Workshop::law(const double* theta, double radius_m) {
  std::vector<double> key(theta, theta + task_.free.size());
  key.push_back(radius_m);
  for (const auto& [known, made] : made_)
    if (known == key) return made;
  std::shared_ptr<const AnyLaw> made;
  const auto texts = texts_of(theta);
  try {
    if (!(ratio(texts) > task_.ratio_most))
      made = std::make_shared<const AnyLaw>(task_.make(texts, radius_m));
  } catch (const core::InvalidInput&) { made = nullptr; } // no such material
  constexpr std::size_t kept = 64;
  if (made_.size() < kept) made_.emplace_back(std::move(key), made);
  else made_[next_++ % kept] = {std::move(key), made};
  return made;
}

std::vector<AnyLaw> Workshop::astray(const double* theta) const {
  return task_.astray ? task_.astray(texts_of(theta), 1) : std::vector<AnyLaw>();
}

bool Workshop::predicted(const Samples& s, const double* theta, double contact_m, std::vector<double>& force,
                         std::vector<double>* stiffness) {
  const auto made = law(theta, made_for(s));
  if (!made) return false;
  std::visit([&](const auto& one) { predict(one, made_for(s), s, contact_m, force, stiffness); }, *made);
  return std::ranges::all_of(force, [](double F) { return std::isfinite(F); });
}

} // namespace platen::calibrate
