#include "surrogate/predict_law.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/version.hpp"
#include "surrogate/predicted_law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace platen::surrogate {
namespace {

void guide(Answer& answer, const material::Material& material, const Description& description,
           const std::function<void(const std::string&)>& say) {
  const auto& s = answer.surrogate;
  try {
    const auto coarse = press_guide(s, material);
    answer.prediction = predict(s, description, &coarse);
    answer.assessment = assess(s, description, answer.prediction);
    answer.guided = true;
  } catch (const core::ConvergenceError& e) {
    say(fmt::format("note: predicted without a guide: {}", e.what()));
  }
}

/// What else could be done about a material that is not inside.
std::string advice(const PredictOptions& o, const Answer& answer) {
  std::string text = fmt::format("`platen derive {} -o DIR` presses it", o.card);
  if (answer.surrogate.guide && o.quick)
    text +=
        fmt::format("; without --quick a press on {} elements comes first (such curves are {:.2g} % off)",
                    answer.surrogate.guide->elements, 100 * answer.surrogate.guide->left_out.force.median);
  return text;
}

} // namespace

std::string law_to_predict(const material::Material& material, const std::string& asked) {
  const bool rock = std::holds_alternative<material::DruckerPrager>(material.model);
  const std::vector<std::string> laws = {"pressed", "edmans-sinka", "wang"};
  const std::string law = asked.empty() ? (rock ? "wang" : "pressed") : asked;
  if (std::ranges::find(laws, law) == laws.end())
    throw core::InvalidInput(
        fmt::format("--law {}: there is no such law to predict{}", law, core::suggestion(law, laws)));
  if (rock != (law == "wang"))
    throw core::InvalidInput(
        fmt::format("--law {}: {} is {}; of {} it is {} that is predicted", law, material.name,
                    rock ? "rock (drucker-prager)" : "no rock (drucker-prager)", rock ? "rock" : "others",
                    rock ? "wang" : "pressed or edmans-sinka"));
  return law;
}

PredictedLaw predict_law(const material::Material& material, const PredictOptions& o,
                         const std::function<void(const std::string&)>& say) {
  law_to_predict(material, o.law);
  const auto description = describe(material.model);
  auto answer = ask_catalogue(description);
  // a press of what lies far away might take long, and would not bring it inside
  if (answer.surrogate.guide && !o.quick && answer.assessment.in_ranges)
    guide(answer, material, description, say);
  const auto& s = answer.surrogate;
  const bool outside = answer.assessment.verdict == Verdict::outside;
  const std::string why = fmt::format("{} is outside of what was pressed (pool {}): {}", material.name,
                                      s.pool, fmt::join(answer.assessment.reasons, "; "));
  if (outside && !o.extrapolate)
    throw core::InvalidInput(fmt::format("{}; {}, --extrapolate guesses", why, advice(o, answer)));
  auto card =
      o.law == "pressed" ? pressed_card(answer, material) : edmans_sinka_card(answer, material, o.variant);
  if (s.engine != core::engine)
    say(fmt::format("warning: pool {} was pressed by engine {}, this is engine {}", s.pool, s.engine,
                    core::engine));
  if (outside) say(fmt::format("warning: extrapolated, {}", why));
  if (answer.assessment.verdict == Verdict::near_the_edge)
    say(fmt::format("note: {} is near the edge of what is known; {}", material.name, advice(o, answer)));
  auto near = nearest(s, description, 3);
  return {std::move(card), std::move(answer), std::move(near)};
}

} // namespace platen::surrogate
