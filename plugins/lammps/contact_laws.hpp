#pragma once
// Law cards as a DEM code needs them: for each pair of particle types a material pair with friction and
// damping, for each pair of (type, radius) classes the prepared law. Knows nothing of LAMMPS.

#include "fit/law_card.hpp"

#include <memory>
#include <string>
#include <vector>

namespace platen::dem {

/// What a host's length, force, mass and time are in SI.
struct Units {
  double length = 1; ///< [m]
  double force = 1;  ///< [N]
};

/// One pair_coeff, or one wall.
struct Contact {
  fit::LawCard one, two; ///< the second side; of a wall unused
  bool on_plane = false;
  double restitution = 1; ///< of an elastic contact: viscous damping gives it, plastic loss comes on top
  double friction = 0;    ///< Coulomb's coefficient
};

/// A law for two radii, and what the contact loop needs beside it; in units of the host where not said
/// otherwise.
struct Terms {
  const law::AnyLaw* law = nullptr; ///< SI; null: not given by the user
  double shear = 0;   ///< 8 G*: tangential stiffness over contact radius (Mindlin) [force/length/m]
  double damping = 0; ///< c = damping sqrt(dF/dgamma m_eff) [-]
  double friction = 0;
  double gamma_valid = 0; ///< the card holds up to here [m]
  int contact = -1;       ///< whose it is
};

/// Checks a card for what a DEM code can do with it. Throws core::InvalidInput.
void check(const Contact&);

/// Contact between cards: parameters of the second card beside those of the first.
law::ParameterTexts parameters(const Contact&, double R1, double R2);

/// `damping` for a restitution coefficient: 2 sqrt(5/6) |ln e|/sqrt(ln^2 e + pi^2), which returns e for
/// Hertz's contact at any velocity (Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011).
double damping_of(double restitution);

/// One prepared law with its terms.
struct Prepared {
  law::AnyLaw law;
  Terms terms;
};
std::unique_ptr<Prepared> prepare(const Contact&, int index, double R1, double R2, const Units&);

/// Laws of all pairs of radius classes.
class LawTable {
 public:
  static constexpr int most_classes = 32; // a law and its table are about 25 kB

  void reset(int types, std::vector<Contact> contacts, std::vector<int> contact_of_types, Units);
  /// The class of a particle; a new one prepares its laws with all others. Throws core::InvalidInput.
  int class_of(int type, double radius);
  [[nodiscard]] int classes() const { return static_cast<int>(classes_.size()); }
  /// Row-major over classes.
  [[nodiscard]] const Terms* terms() const { return terms_.data(); }
  [[nodiscard]] const law::AnyLaw& law_of(int a, int b) const { return *terms_[index(a, b)].law; }
  /// Index of the law that all pairs have, or -1.
  [[nodiscard]] int only_kind() const { return only_kind_; }
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  struct Class {
    int type;
    double radius;
  };
  [[nodiscard]] std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * classes_.size() + static_cast<std::size_t>(b);
  }
  int add(int type, double radius);

  int types_ = 0, only_kind_ = -1;
  Units units_;
  std::vector<Contact> contacts_;
  std::vector<int> contact_of_types_; // [type1 * (types + 1) + type2], -1: none
  std::vector<Class> classes_;
  std::vector<std::unique_ptr<Prepared>> laws_;
  std::vector<Terms> terms_;
};

} // namespace platen::dem
