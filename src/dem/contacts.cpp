#include "dem/contacts.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "dem/damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::dem {
namespace {

using core::InvalidInput;

double eight_G(const law::Pair& pair) {
  double compliance = 0; // 1/G* = sum (2 - nu)/G
  for (const auto& side : pair.body) compliance += (2 - side.nu) * 2 * (1 + side.nu) * side.compliance;
  return compliance > 0 ? 8 / compliance : 0;
}

bool has_elasticity(const fit::LawCard& card) {
  const auto& parameters = law::find_law(card.law).parameters;
  return std::ranges::any_of(parameters, [](const auto& p) { return p.key == "E_Pa"; });
}

} // namespace

void check(const Contact& contact) {
  (void)fit::body_of(*contact.one, contact.on_plane);
  if (!contact.on_plane) (void)fit::body_of(*contact.two);
  if (!(contact.restitution > 0 && contact.restitution <= 1))
    throw InvalidInput(
        fmt::format("damping {} is not a restitution coefficient in (0, 1]", contact.restitution));
  if (!(contact.friction >= 0 && std::isfinite(contact.friction)))
    throw InvalidInput(fmt::format("friction {} is not a coefficient of 0 or more", contact.friction));
}

Laws::Laws(Contact contact_, int index_, const Units& units)
    : contact(std::move(contact_)), index(index_), damping(platen_damping_of(contact.restitution)),
      length(units.length), alike(contact.on_plane || contact.one->file == contact.two->file) {
  nodes_ = alike ? 512 : 1024;
  for (const Card& side : {contact.one, contact.on_plane ? contact.one : contact.two}) {
    const fit::LawCard* const card = &*side;
    fixed = fixed || card->parameters.contains("radius_m");
    if (card->delta_bar) x_valid = std::min(x_valid, (*card->delta_bar)[1] * (1 + 1e-12));
    if (contact.friction > 0 && !has_elasticity(*card))
      throw InvalidInput(
          fmt::format("{}: friction needs Young's modulus and Poisson's ratio, which the law {} does not "
                      "have",
                      card->file, card->law));
  }
  // Makes the first table: what cannot be is said before anything moves.
  try {
    const law::LawChoice one = fit::body_of(*contact.one, contact.on_plane);
    const law::Law law = contact.on_plane ? law::make_law_on_plane(one, 1)
                                          : law::make_law(one, 1, fit::body_of(*contact.two), 1,
                                                          alike ? law::TableAccuracy{} : law::joined_table);
    shear = eight_G(law.pair) * units.length / units.force;
    of_equal_ = law.table;
    if (contact.on_plane) (void)node(0, false);
    force_power = law.force_power;
    plain_ = !contact.on_plane && !fixed;
  } catch (const law::BadParameter& error) {
    const bool two = !contact.on_plane && !alike;
    throw InvalidInput(
        fmt::format("{}{}: {}", contact.one->file, two ? " with " + contact.two->file : "", error.what()));
  }
}

void Laws::check_radius(const fit::LawCard& card, double R) const {
  const auto own = card.parameters.find("radius_m");
  if (own == card.parameters.end()) return;
  const auto radius = core::number_from(own->second);
  if (!radius || std::abs(*radius - R) > 1e-9 * R)
    throw InvalidInput(
        fmt::format("{}: the card is for radius_m = {}, and does not cover a particle of radius {} m",
                    card.file, own->second, R));
}

const law::Table* Laws::node(std::size_t k, bool first_is_larger) {
  if (k == 0 && of_equal_) {
    made_.push_back(of_equal_);
    for (Tables* tables : {&node_, &mirrored_}) {
      tables->resize(std::max<std::size_t>(tables->size(), 1));
      tables->front() = of_equal_.get();
    }
    of_equal_.reset();
    return node_.front();
  }
  auto& tables = first_is_larger && !alike ? mirrored_ : node_;
  if (tables.size() <= k) tables.resize(k + 1);
  if (tables[k]) return tables[k];
  if (!alike) of_equal_.reset(); // spheres of many radii have few equals
  const double t = static_cast<double>(k) / nodes_, small = t == 1 ? 1 : 1 - t,
               large = t == 1 ? law::infinity : 1 + t;
  const law::LawChoice one = fit::body_of(*contact.one), two = fit::body_of(*contact.two);
  // The ratio of the radii is rounded, which is a tenth of a per cent of the force: a coarse table will do.
  const law::TableAccuracy& accuracy = alike ? law::coarse_table : law::joined_table;
  made_.push_back((first_is_larger ? law::make_law(one, large, two, small, accuracy)
                                   : law::make_law(one, small, two, large, accuracy))
                      .table);
  return tables[k] = made_.back().get();
}

Laws::At Laws::between(double R1, double R2) {
  At at;
  if (fixed) {
    check_radius(*contact.one, R1 * length);
    if (!contact.on_plane) check_radius(*contact.two, R2 * length);
  }
  if (contact.on_plane) {
    const double R = R1 * length, F = force_of(R);
    at.table = node_[0];
    at.scale = {R, 1 / R, F, F * R, F / (R * R)};
    return at;
  }
  const double s = R1 + R2, t = (R1 - R2) / s;
  at.scale = scale_of(s * length, t);
  if (force_power != 2) {
    const double R_e = at.scale.R_e, F = force_of(R_e);
    at.scale.force = F, at.scale.work = F / at.scale.x_per_gamma, at.scale.pressure = F / (R_e * R_e);
  }
  at.table = table(t);
  return at;
}

std::size_t Laws::bytes() const {
  std::size_t sum = sizeof(Laws) + (node_.size() + mirrored_.size()) * sizeof(node_[0]);
  if (of_equal_) sum += of_equal_->bytes();
  for (const Made& table : made_) sum += sizeof(table) + table->bytes();
  return sum;
}

} // namespace platen::dem
