#pragma once
// Law cards as a DEM code needs them: for each pair of particle types the laws of the two materials, for
// spheres of any radii, with friction and damping. Knows nothing of a host.

#include "fit/law_card.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace platen::dem {

/// What a host's length and force are in SI.
struct Units {
  double length = 1; ///< [m]
  double force = 1;  ///< [N]
};

/// A law card that contacts share: with its curve as text it is as large as a table.
class Card {
 public:
  Card() = default;
  Card(fit::LawCard card)
      : card_(std::make_shared<const fit::LawCard>(std::move(card))) {} // NOLINT: implicit
  const fit::LawCard& operator*() const { return *card_; }
  const fit::LawCard* operator->() const { return card_.get(); }

 private:
  std::shared_ptr<const fit::LawCard> card_;
};

/// One pair of particle types, or one wall.
struct Contact {
  Card one, two; ///< the second side; of a wall unused
  bool on_plane = false;
  double restitution = 1; ///< of an elastic contact: viscous damping gives it, plastic loss comes on top
  double friction = 0;    ///< Coulomb's coefficient
};

/// Checks a card for what a DEM code can do with it. Throws core::InvalidInput.
void check(const Contact&);

/// Of two spheres (pair.hpp), s = R1 + R2, t = (R1 - R2)/s, with one division: R_e = s (1 - t^2)/(2 root),
/// x_per_gamma = q/((1 - t^2) s).
PLATEN_HOT law::Scale scale_of(double s, double t) {
  const double p_s = (1 - t * t) * s, q = 1 + 3 * t * t, root = std::sqrt(q);
  const double per = 1 / (p_s * root), R_e = 0.5 * p_s * p_s * per, back = p_s * per;
  const double square = R_e * R_e;
  return {R_e, q * root * per, square, square * p_s * back * back, 1};
}

/// The laws of two materials. One table serves all radii of the same ratio, t = |R1 - R2|/(R1 + R2), 0 for
/// equal spheres and 1 against a plane; others take the next of 512 (of unlike bodies 1,024), whose force is
/// right to 0.3 %. Each is made when it is first needed; of unlike bodies they are coarse
/// (law::joined_table).
class Laws {
 public:
  Laws(Contact, int index, const Units&);

  /// Table and scale for radii of the host. May make tables: throws core::InvalidInput where the cards do not
  /// cover them.
  struct At {
    const law::Table* table = nullptr;
    law::Scale scale; ///< SI
  };
  PLATEN_HOT At at(double R1, double R2) {
    if (!plain_ || force_power != 2) [[unlikely]]
      return between(R1, R2);
    const double s = R1 + R2, t = (R1 - R2) / s;
    return {table(t), scale_of(s * length, t)};
  }
  /// Spheres of any radius: `table`, `scale_of` and `force_of` say what `at` does.
  [[nodiscard]] bool plain() const { return plain_; }
  [[nodiscard]] PLATEN_HOT double force_of(double R_e) const {
    return force_power == 2 ? R_e * R_e : force_power == 1 ? R_e : std::pow(R_e, force_power);
  }
  /// Of spheres, t = (R1 - R2)/(R1 + R2).
  PLATEN_HOT const law::Table* table(double t) {
    const auto k = static_cast<std::size_t>(static_cast<int>((t < 0 ? -t : t) * nodes_ + 0.5));
    const Tables& tables = !alike && t > 0 ? mirrored_ : node_; // a guess for each contact costs
    const law::Table* made = k < tables.size() ? tables[k] : nullptr;
    return made ? made : node(k, t > 0);
  }
  /// Whether both cards hold at a largest overlap x of the table.
  [[nodiscard]] PLATEN_HOT bool valid(const law::TableView& table, double x) const {
    return x <= x_valid && table.in_range(x);
  }

  [[nodiscard]] std::size_t bytes() const;

  Contact contact;
  int index = 0;
  double shear = 0;   ///< 8 G*: tangential stiffness over contact radius (Mindlin) [force/length/m]
  double damping = 0; ///< c = damping sqrt(dF/dgamma m_eff) [-]
  double x_valid = law::infinity; ///< the cards hold up to here, delta/R
  double force_power = 2;         ///< the force goes with R_e to this power

 private:
  using Tables = std::vector<const law::Table*>;
  using Made = std::shared_ptr<const law::Table>;
  At between(double R1, double R2);
  const law::Table* node(std::size_t k, bool first_is_larger);
  void check_radius(const fit::LawCard&, double R) const;

  double length = 1;
  bool fixed = false;  ///< a card is for one radius alone
  bool alike = false;  ///< of one card, or a plane
  double nodes_ = 512; ///< t = k/nodes
  bool plain_ = false;
  Tables node_, mirrored_; ///< by k: first sphere smaller; larger. On a plane node_[0]
  std::vector<Made> made_;
  Made of_equal_; ///< made first, if nobody has asked for another
};

/// The response of the laws at an overlap, with the largest overlap so far [m].
PLATEN_HOT law::Response respond(const Laws::At& at, double gamma_max, double overlap_m) {
  return law::evaluate(*at.table, at.scale, law::State{0, gamma_max}, overlap_m);
}

} // namespace platen::dem
