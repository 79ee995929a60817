#pragma once
// A stub of MercuryDPM: of its interface those names that plugins/mercurydpm asks for.
#include <cmath>
#include <iostream>
#include <string>

using Mdouble = double;

struct Vec3D {
  double X = 0, Y = 0, Z = 0;
  Vec3D() = default;
  Vec3D(double x, double y, double z) : X(x), Y(y), Z(z) {}
  static double dot(const Vec3D& a, const Vec3D& b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
  Vec3D operator*(double s) const { return {X * s, Y * s, Z * s}; }
  Vec3D operator-(const Vec3D& o) const { return {X - o.X, Y - o.Y, Z - o.Z}; }
};

enum Level { ERROR };
template <class... Args> void logger(Level, const char*, Args...) {}

class BaseSpecies {
 public:
  virtual ~BaseSpecies() = default;
  virtual void read(std::istream&) {}
  virtual void write(std::ostream&) const {}
};

class BaseInteractable {
 public:
  virtual ~BaseInteractable() = default;
  Vec3D getVelocityAtContact(const Vec3D&) const { return velocity; }
  Vec3D velocity;
};
class BaseParticle : public BaseInteractable {
 public:
  double getRadius() const { return radius; }
  double radius = 0;
};

class BaseInteraction {
 public:
  BaseInteraction() = default;
  BaseInteraction(BaseInteractable* P, BaseInteractable* I, unsigned) : P_(P), I_(I) {}
  virtual ~BaseInteraction() = default;
  virtual void read(std::istream&) {}
  virtual void write(std::ostream&) const {}
  virtual Mdouble getElasticEnergy() const { return 0; }
  virtual Mdouble getElasticEnergyAtEquilibrium(Mdouble) const { return 0; }
  BaseInteractable* getP() { return P_; }
  BaseInteractable* getI() { return I_; }
  const BaseInteractable* getP() const { return P_; }
  const BaseInteractable* getI() const { return I_; }
  Mdouble getOverlap() const { return overlap; }
  const Vec3D& getNormal() const { return normal; }
  const Vec3D& getContactPoint() const { return point; }
  const Vec3D& getRelativeVelocity() const { return velocity; }
  Mdouble getNormalRelativeVelocity() const { return along; }
  const BaseSpecies* getBaseSpecies() const { return species; }
  void setRelativeVelocity(Vec3D v) { velocity = v; }
  void setNormalRelativeVelocity(Mdouble v) { along = v; }
  void setAbsoluteNormalForce(Mdouble F) { size = F; }
  void setForce(Vec3D F) { force = F; }
  void setTorque(Vec3D) {}
  Mdouble getEffectiveMass() const { return 1e-6; }

  Mdouble overlap = 0, along = 0, size = 0;
  Vec3D normal, point, velocity, force;
  const BaseSpecies* species = nullptr;

 private:
  BaseInteractable *P_ = nullptr, *I_ = nullptr;
};
