#include "contact_laws.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::dem {
namespace {

using core::InvalidInput;

constexpr std::pair<const char*, const char*> sides[] = {{"E_Pa", "E2_Pa"},
                                                         {"nu", "nu2"},
                                                         {"sigma_y_Pa", "sigma_y2_Pa"},
                                                         {"p_y_Pa", "p_y2_Pa"},
                                                         {"kappa_Pa", "kappa2_Pa"}};

const char* second_key(const std::string& key) {
  for (const auto& [one, two] : sides)
    if (key == one) return two;
  return nullptr;
}

/// Bisection: both laws and cards are in range up to one overlap.
double valid_overlap(const law::AnyLaw& law, const fit::LawCard& card) {
  return std::visit(
      [&](const auto& l) {
        double good = 0, bad = l.gamma_limit;
        if (card.delta_bar) bad = std::min(bad, (*card.delta_bar)[1] * (1 + 1e-12) / l.pair.x_per_gamma);
        if (l.in_range(bad)) return bad;
        for (int i = 0; i < 100; ++i) {
          const double middle = (good + bad) / 2;
          (l.in_range(middle) ? good : bad) = middle;
        }
        return good;
      },
      law);
}

double eight_G(const law::Pair& pair) {
  double compliance = 0; // 1/G* = sum (2 - nu)/G
  for (const auto& side : pair.body) compliance += (2 - side.nu) * 2 * (1 + side.nu) * side.compliance;
  return compliance > 0 ? 8 / compliance : 0;
}

void check_side(const fit::LawCard& card, bool on_plane) {
  const auto against = card.parameters.find("against");
  if (!on_plane && against != card.parameters.end() && against->second == "plane")
    throw InvalidInput(
        fmt::format("{}: the card is for a sphere against a plane, not between spheres", card.file));
  for (const auto& [key, value] : card.parameters)
    if (key == "radius2_m" || key.find("2_Pa") != std::string::npos || key == "nu2")
      throw InvalidInput(fmt::format(
          "{}: the card is for one pair of unlike spheres ({} = {}); give a card for each material",
          card.file, key, value));
}

} // namespace

void check(const Contact& contact) {
  check_side(contact.one, contact.on_plane);
  if (!contact.on_plane) check_side(contact.two, false);
  if (!(contact.restitution > 0 && contact.restitution <= 1))
    throw InvalidInput(
        fmt::format("damping {} is not a restitution coefficient in (0, 1]", contact.restitution));
  if (!(contact.friction >= 0 && std::isfinite(contact.friction)))
    throw InvalidInput(fmt::format("friction {} is not a coefficient of 0 or more", contact.friction));
  if (contact.on_plane) return;
  if (contact.one.law != contact.two.law || contact.one.variant != contact.two.variant)
    throw InvalidInput(
        fmt::format("{} and {} are cards of two laws ({}, {}); the two sides of a contact need the same",
                    contact.one.file, contact.two.file, contact.one.law, contact.two.law));
  auto keys = contact.one.parameters;
  keys.insert(contact.two.parameters.begin(), contact.two.parameters.end());
  for (const auto& [key, value] : keys) {
    const auto a = contact.one.parameters.find(key), b = contact.two.parameters.find(key);
    const bool same =
        a != contact.one.parameters.end() && b != contact.two.parameters.end() && a->second == b->second;
    if (!same && !second_key(key) && key != "radius_m")
      throw InvalidInput(
          fmt::format("{} and {} differ in {}, which the law {} takes once for both sides; give the "
                      "card of the softer material for this pair",
                      contact.one.file, contact.two.file, key, contact.one.law));
  }
}

law::ParameterTexts parameters(const Contact& contact, double R1, double R2) {
  law::ParameterTexts texts = contact.one.parameters;
  const auto radius = [](const fit::LawCard& card, double R) {
    const auto fixed = card.parameters.find("radius_m");
    if (fixed == card.parameters.end()) return core::number_text(R);
    const auto own = core::number_from(fixed->second);
    if (!own || std::abs(*own - R) > 1e-9 * R)
      throw InvalidInput(
          fmt::format("{}: the card is for radius_m = {}, and does not cover a particle of radius {} m",
                      card.file, fixed->second, R));
    return fixed->second;
  };
  texts["radius_m"] = radius(contact.one, R1);
  if (contact.on_plane) {
    texts["against"] = "plane";
    return texts;
  }
  texts["radius2_m"] = radius(contact.two, R2);
  for (const auto& [key, value] : contact.two.parameters)
    if (const char* second = second_key(key)) texts[second] = value;
  return texts;
}

double damping_of(double restitution) {
  const double l = std::log(restitution);
  return 2 * std::sqrt(5.0 / 6) * -l / std::hypot(l, std::numbers::pi);
}

std::unique_ptr<Prepared> prepare(const Contact& contact, int index, double R1, double R2,
                                  const Units& units) {
  auto made =
      std::make_unique<Prepared>(Prepared{fit::make_law(contact.one, parameters(contact, R1, R2)), {}});
  Terms& t = made->terms;
  t.law = &made->law;
  t.shear =
      std::visit([&](const auto& l) { return eight_G(l.pair); }, made->law) * units.length / units.force;
  if (contact.friction > 0 && !(t.shear > 0 && std::isfinite(t.shear)))
    throw InvalidInput(
        fmt::format("{}: friction needs Young's modulus and Poisson's ratio, which the law {} does not "
                    "have",
                    contact.one.file, contact.one.law));
  t.damping = damping_of(contact.restitution);
  t.friction = contact.friction;
  t.gamma_valid = valid_overlap(made->law, contact.one);
  if (!contact.on_plane) t.gamma_valid = std::min(t.gamma_valid, valid_overlap(made->law, contact.two));
  t.contact = index;
  return made;
}

void LawTable::reset(int types, std::vector<Contact> contacts, std::vector<int> contact_of_types,
                     Units units) {
  types_ = types;
  units_ = units;
  contacts_ = std::move(contacts);
  contact_of_types_ = std::move(contact_of_types);
  classes_.clear();
  laws_.clear();
  terms_.clear();
  only_kind_ = -1;
}

int LawTable::class_of(int type, double radius) {
  for (std::size_t c = 0; c < classes_.size(); ++c)
    if (classes_[c].type == type && classes_[c].radius == radius) return static_cast<int>(c);
  return add(type, radius);
}

int LawTable::add(int type, double radius) {
  if (classes() == most_classes)
    throw InvalidInput(
        fmt::format("there are more than {} different radii (type {}, radius {}): a law is prepared for "
                    "each pair of radii, so give classes of radii",
                    most_classes, type, radius));
  const std::size_t old = classes_.size(), n = old + 1;
  std::vector<Terms> terms(n * n);
  for (std::size_t a = 0; a < old; ++a)
    for (std::size_t b = 0; b < old; ++b) terms[a * n + b] = terms_[a * old + b];
  classes_.push_back({type, radius});
  for (std::size_t a = 0; a < n; ++a) {
    Class one = classes_[a], two = classes_[old];
    if (one.type > two.type) std::swap(one, two);
    const int contact = contact_of_types_[static_cast<std::size_t>(one.type * (types_ + 1) + two.type)];
    if (contact < 0) continue;
    laws_.push_back(prepare(contacts_[static_cast<std::size_t>(contact)], contact, one.radius * units_.length,
                            two.radius * units_.length, units_));
    terms[a * n + old] = terms[old * n + a] = laws_.back()->terms;
  }
  terms_ = std::move(terms);
  only_kind_ = laws_.empty() ? -1 : static_cast<int>(laws_.front()->law.index());
  for (const auto& made : laws_)
    if (static_cast<int>(made->law.index()) != only_kind_) only_kind_ = -1;
  return static_cast<int>(old);
}

} // namespace platen::dem
