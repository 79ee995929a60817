// A random material of a random law on a random path: the headers, the C interface, and a law whose texts
// took the way through a card, give the same bits; C all at once but for rounding.
#include "fuzz.hpp"

#include "../unit/law/random_material.hpp"
#include "fit/law_card.hpp"
#include "platen_law.h"

#include <cstring>
#include <fstream>

using namespace platen;

namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
void demand(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "differ: %s\n", what.c_str());
  __builtin_trap();
}

} // namespace

PLATEN_FUZZ {
  if (size < 10) return 0;
  std::uint64_t seed = 0;
  std::memcpy(&seed, data, sizeof seed);
  ::setenv("RC_PARAMS", ("seed=" + std::to_string(seed)).c_str(), 1);
  law::testing::Random random;
  const auto& info = law::laws()[data[8] % law::laws().size()];
  auto one = law::testing::random_material(info, random);
  one.parameters["radius_m"] = law::testing::digits(random.log_between(1e-5, 1));
  const double R = std::stod(one.parameters["radius_m"]);
  std::optional<law::Law> plain;
  std::string why;
  try {
    plain = law::make_law(one.name, one.variant, one.parameters);
  } catch (const law::BadParameter& refused) { why = refused.what(); }
  std::string texts;
  for (const auto& [key, value] : one.parameters) texts += " " + key + "=" + value;
  char answer[400] = "";
  platen_law* c = platen_law_new(one.name.c_str(), one.variant.c_str(), texts.c_str(), answer, sizeof answer);
  demand(plain.has_value() == (c != nullptr), one.name + ": " + why + " | " + answer);
  if (!c) {
    demand(why.substr(0, sizeof answer - 1) == answer, why + " | " + answer);
    return 0;
  }
  fit::LawCard card;
  card.law = one.name;
  card.variant = one.variant;
  card.parameters = one.parameters;
  const std::string text = fit::text_of(card);
  const auto read =
      fit::make_law(fit::read_law_card(fuzz::file_of(reinterpret_cast<const std::uint8_t*>(text.data()),
                                                     text.size(), ".toml")),
                    {});

  law::State state, state_of_card;
  double memory[2] = {}, all[2] = {};
  for (std::size_t i = 9; i < size; ++i) {
    const double step = (data[i] - 20) / 235.0; // some are separated
    const double overlap = R * step * std::abs(step) * 1.2;
    const auto a = evaluate(*plain, state, overlap), b = evaluate(read, state_of_card, overlap);
    const auto d = platen_law_evaluate(c, memory, overlap);
    double force = 0, stiffness = 0;
    platen_law_evaluate_all(c, 1, &overlap, all, &force, &stiffness);
    state = a.state;
    state_of_card = b.state;
    const std::string where = law::testing::text_of(one) + " at " + law::testing::digits(overlap);
    demand(same(a.force, d.force_N) && same(a.stiffness, d.stiffness_N_per_m) &&
               same(a.contact_radius, d.contact_radius_m) && same(a.mean_pressure, d.mean_pressure_Pa) &&
               same(a.dissipated_work, d.dissipated_work_J) && static_cast<int>(a.branch) == d.branch,
           where + ": C");
    const auto top = evaluate(*plain, {}, state.gamma_max);
    const auto near = [](double x, double y, double most) {
      return same(x, y) || std::abs(x - y) <= 1e-11 * std::max(std::abs(x), most);
    };
    demand(near(a.force, force, top.force) && near(a.stiffness, stiffness, top.stiffness),
           where + ": C, all at once");
    demand(same(a.force, b.force) && same(a.contact_radius, b.contact_radius), where + ": card");
    demand(std::memcmp(memory, &state, sizeof memory) == 0, where + ": state");
  }
  platen_law_free(c);
  return 0;
}
