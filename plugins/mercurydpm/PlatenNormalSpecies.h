// A Platen law as a normal force of MercuryDPM: Species<PlatenNormalSpecies>, Species<PlatenNormalSpecies, FrictionSpecies>.
// UNTESTED WITHIN MercuryDPM: it is compiled against a stub of its interface alone (tests/downstream/adapters), where its forces
// are those of `platen eval`.
//
//   platen export dem-engine granule.toml -o granule      # the law as text: functions.cu
//   put that folder and this one on the include path of the driver code, compiled as C++17
//
//   auto species = problem.speciesHandler.copyAndAddObject(Species<PlatenNormalSpecies, FrictionSpecies>());
//   species->setDensity(1500);
//   species->setRestitution(0.5);                         // of an elastic contact; plastic loss comes on top
//   species->setSlidingStiffness(2.0 / 7 * species->getStiffness(R, overlap));
//
// One law for all particles; a wall is a rigid plane. A contact remembers its largest overlap until it ends.
#ifndef PLATEN_NORMAL_SPECIES_H
#define PLATEN_NORMAL_SPECIES_H

#include "functions.cu" // of the export

#include "Interactions/BaseInteraction.h"
#include "Math/ExtendedMath.h"
#include "Particles/BaseParticle.h"
#include "Species/BaseSpecies.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

class PlatenNormalSpecies;

class PlatenInteraction : public virtual BaseInteraction {
 public:
  PlatenInteraction(BaseInteractable* P, BaseInteractable* I, unsigned timeStamp) : BaseInteraction(P, I, timeStamp) {}
  PlatenInteraction() = default;
  PlatenInteraction(const PlatenInteraction&) = default;
  ~PlatenInteraction() override = default;

  void computeNormalForce();
  void computePlatenForce() { computeNormalForce(); }

  void read(std::istream& is) override {
    BaseInteraction::read(is);
    std::string word;
    is >> word >> overlapMax_;
  }
  void write(std::ostream& os) const override {
    BaseInteraction::write(os);
    os << " overlapMax " << overlapMax_;
  }
  std::string getBaseName() const { return "Platen"; }
  /// What unloading would give back, as of a spring of the current stiffness.
  Mdouble getElasticEnergy() const override {
    const PlatenResponse law = response();
    return law.stiffness > 0 ? 0.5 * law.force * law.force / law.stiffness : 0;
  }
  Mdouble getElasticEnergyAtEquilibrium(Mdouble) const override { return 0; }
  Mdouble getOverlapMax() const { return overlapMax_; }
  const PlatenNormalSpecies* getSpecies() const;

 private:
  static Mdouble radius(const BaseInteractable* body) {
    const auto* particle = dynamic_cast<const BaseParticle*>(body);
    return particle ? particle->getRadius() : 1e300;
  }
  PlatenResponse response() const {
    return platen_contact(radius(getP()), radius(getI()), getOverlap(), overlapMax_);
  }

  Mdouble overlapMax_ = 0;
};

class PlatenNormalSpecies : public virtual BaseSpecies {
 public:
  typedef PlatenInteraction InteractionType;

  void read(std::istream& is) override {
    BaseSpecies::read(is);
    std::string word;
    is >> word >> restitution_;
    damping_ = platen_damping_of(restitution_);
  }
  void write(std::ostream& os) const override {
    BaseSpecies::write(os);
    os << " restitution " << restitution_;
  }
  std::string getBaseName() const { return "Platen"; }
  void mix(PlatenNormalSpecies* S, PlatenNormalSpecies* T) {
    setRestitution(0.5 * (S->restitution_ + T->restitution_));
  }

  void setRestitution(Mdouble e) {
    if (!(e > 0 && e <= 1)) logger(ERROR, "setRestitution(%): it is not a restitution coefficient in (0, 1]", e);
    restitution_ = e;
    damping_ = platen_damping_of(e);
  }
  Mdouble getRestitution() const { return restitution_; }
  /// c = damping sqrt(stiffness m): a Hertzian contact returns e at any velocity.
  Mdouble getDamping() const { return damping_; }
  /// Of two spheres of radius R when they begin to unload from this overlap, for time steps and tangential springs.
  static Mdouble getStiffness(Mdouble R, Mdouble overlap) {
    return platen_contact(R, R, overlap * (1 - 1e-9), overlap).stiffness;
  }

 private:
  Mdouble restitution_ = 1, damping_ = 0;
};

inline const PlatenNormalSpecies* PlatenInteraction::getSpecies() const {
  return dynamic_cast<const PlatenNormalSpecies*>(getBaseSpecies());
}

inline void PlatenInteraction::computeNormalForce() {
  setRelativeVelocity(getP()->getVelocityAtContact(getContactPoint()) - getI()->getVelocityAtContact(getContactPoint()));
  setNormalRelativeVelocity(Vec3D::dot(getRelativeVelocity(), getNormal()));
  Mdouble force = 0;
  if (getOverlap() > 0) {
    overlapMax_ = std::max(overlapMax_, getOverlap());
    const PlatenResponse law = response();
    const Mdouble c = getSpecies()->getDamping() * std::sqrt(law.stiffness * getEffectiveMass());
    if (law.force > 0) force = std::max(law.force - c * getNormalRelativeVelocity(), 0.0); // never pulls
  }
  setAbsoluteNormalForce(std::abs(force));
  setForce(getNormal() * force);
  setTorque(Vec3D(0.0, 0.0, 0.0));
}

#endif
