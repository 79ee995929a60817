#pragma once
// What a constitutive model is. Every model is an aggregate of parameters that satisfies ConstitutiveModel; a
// plastic one is of one of two kinds besides:
//
//   InvariantModel   knows p and q alone: it gives its yield surface, and the integrator returns to it
//   PrincipalModel   knows the three principal stresses: it returns by itself
//
// One whose section is a circle for some of its parameters alone is of both; its `circular()` says of which.
//
// A yield surface in p and q is a curve in the (p, q) half-plane q >= 0 (Cauchy stress, tension positive),
// followed by a parameter s from the tensile to the compressive end. A model gives the point and the flow
// direction at s; corners, apices and flat parts are then parts of one curve, and a converged stress lies on
// the surface exactly. The surface and the elastic moduli depend on one state variable phi.
//
//   struct Surface { SurfacePoint at(double s) const; ... };    surface at one phi, with derivatives in phi
//   model.moduli(phi), model.surface(phi), Model::phi_rate      see the concepts below

#include "platen/lanes.hpp"

#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace platen::material {

/// How a material point flowed in its last increment.
enum class Zone : unsigned char { elastic, shear, compaction, tension };

enum class Status : unsigned char {
  elastic,
  plastic,   ///< Newton converged
  bracketed, ///< the bracketing fall-back was needed
  refused,   ///< no admissible state was found: cut the step
  unstable   ///< refused as well: densification raises the elastic stress faster than the surface gives way
};

/// Whether the update has no state to give.
constexpr bool is_refused(Status status) { return status >= Status::refused; }

// What a return computes with is written for a number type T: double, or core::Lanes, eight points at a time.

/// Invariants of a trial elastic Hencky strain.
template <class T> struct TrialInvariantsOf {
  T eps_v; ///< trace
  T eps_q; ///< sqrt(2/3 e:e), e the deviator
};
using TrialInvariants = TrialInvariantsOf<double>;

/// The state after the increment, and the consistent tangent d(p, q)/d(eps_v^tr, eps_q^tr).
template <class T> struct InvariantResponseOf {
  Status status = Status::elastic; ///< of a single point, as is the zone
  Zone zone = Zone::elastic;
  T p{}, q{};         ///< Cauchy (Pa)
  T eps_v{}, eps_q{}; ///< elastic strain
  T exp_v{};          ///< e^{-eps_v}
  T phi{};
  T p_v{}, p_q{}, q_v{}, q_q{}; ///< tangent (Pa)
};
using InvariantResponse = InvariantResponseOf<double>;

/// The same of a model that is returned in principal stresses.
struct PrincipalResponse {
  Status status = Status::elastic;
  Zone zone = Zone::elastic;
  std::array<double, 3> sigma{};            ///< principal Cauchy stresses (Pa), in the order of the trial
  std::array<double, 3> eps{};              ///< elastic strains
  std::array<std::array<double, 3>, 3> D{}; ///< d(sigma_A)/d(eps_B^tr) (Pa)
};

/// Bulk and shear modulus (Pa) with their derivatives in phi.
template <class T> struct ModuliOf {
  T K, G;
  T K_phi{}, G_phi{};
};
using Moduli = ModuliOf<double>;

/// A point of the yield surface and the unit flow direction there, with derivatives in s and phi.
template <class T> struct SurfacePointOf {
  T p, q;         ///< Pa
  T p_s, q_s;     ///< derivatives in s
  T p_phi, q_phi; ///< derivatives in phi at constant s
  T n_p, n_q;     ///< flow direction: d(eps_v^p) : d(eps_q^p) = n_p : n_q, n_p^2 + n_q^2 = 1
  T n_p_s, n_q_s;
  T n_p_phi, n_q_phi;
};
using SurfacePoint = SurfacePointOf<double>;

/// Moduli and yield surface at one phi.
template <class Surface, class T = double> struct Properties {
  ModuliOf<T> moduli;
  Surface surface;
};

/// d(phi) = v d(eps_v^p) + w d(eps_q^p).
struct PhiRate {
  double v, w;
};

/// Which bounds of the material description were active at a state (docs/explanation/porous-materials.md:
/// nothing is clamped in silence).
struct Bounds {
  bool rho_r = false;   ///< properties held at their values for rho_r = 1
  bool nu = false;      ///< Poisson's ratio held in [0, 0.49]
  bool epsilon = false; ///< cap axis ratio held at its minimum
  bool pi_3 = false;    ///< cap centred at p = 0
  bool table = false;   ///< hardening table left behind, its last stress held
};

/// One without ends has `drawn(p_low, p_high)` besides, the stretch of s to draw between two pressures.
template <class S>
concept YieldSurface = requires(const S& surface, double x) {
  { surface.at(x) } -> std::same_as<SurfacePoint>;
  { surface.s_min() } -> std::convertible_to<double>;
  { surface.s_max() } -> std::convertible_to<double>;
  { surface.contains(x, x) } -> std::same_as<bool>; // (p, q) inside or on the surface
  // s near the return of a trial (p, q) outside
  { surface.first_guess(x, x, Moduli{}) } -> std::convertible_to<double>;
  { surface.zone(x) } -> std::same_as<Zone>;
};

/// A yield surface in the (p, q) half-plane, to be drawn.
struct YieldCurve {
  std::string name;                       ///< of a meridian, empty where the surface is one of revolution
  std::vector<std::array<double, 2>> p_q; ///< Pa, tension positive, from the tensile end
};

/// The card of a model, see card_section.hpp.
template <class T> struct CardSection;

/// Beside these a model may have `rho_r(phi)`, its relative density, and `bounds(phi)`, what is active of its
/// Bounds.
template <class M>
concept ConstitutiveModel = requires(const M& model, double phi) {
  { M::name } -> std::convertible_to<std::string_view>; // as cards name it
  { M::card() } -> std::same_as<const CardSection<M>&>;
  { model.E } -> std::convertible_to<double>; // of the undeformed material
  { model.nu } -> std::convertible_to<double>;
  { model.reference_stress() } -> std::convertible_to<double>;
  { model.moduli(phi) } -> std::same_as<Moduli>;
};

/// One whose moduli do not depend on phi may say so by M::fixed_moduli = true, and if its surface does not
/// either, by M::perfectly_plastic = true besides: they are computed once then.
template <class M>
concept InvariantModel = requires(const M& model, double phi) {
  { model.moduli(phi) } -> std::same_as<Moduli>;
  { model.surface(phi) } -> YieldSurface;
  { M::phi_rate } -> std::convertible_to<PhiRate>;
};

template <class M>
concept PrincipalModel = requires(const M& model, const std::array<double, 3>& principal) {
  { model.respond(principal) } -> std::same_as<PrincipalResponse>; // to a trial elastic strain
  { model.excess(principal) } -> std::convertible_to<double>;      // of a stress: not positive inside
  { model.meridians(principal[0]) } -> std::same_as<std::vector<YieldCurve>>; // down to a pressure
  { M::phi_rate } -> std::convertible_to<PhiRate>;
};

/// Whether p and q say all of this material.
template <class M> constexpr bool in_invariants(const M& model) {
  if constexpr (InvariantModel<M> && PrincipalModel<M>) return model.circular();
  else return InvariantModel<M>;
}

/// Both at once: a model may offer them together, where that is cheaper.
template <InvariantModel M, class T> auto properties(const M& model, T phi) {
  if constexpr (requires { model.properties(phi); }) return model.properties(phi);
  else return Properties<decltype(model.surface(phi))>{model.moduli(phi), model.surface(phi)};
}

/// One that offers them, and all that its surface tells, for eight numbers at a time.
template <class M>
concept LaneModel = InvariantModel<M> && requires(const M& model, core::Lanes phi) {
  model.properties(phi);
};

/// K and G of an isotropic material.
template <class T> constexpr ModuliOf<T> isotropic_moduli(const T& E, const T& nu) {
  return {E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

/// Where the stretch of a surface without ends is taken to end (Pa): 30 K, far beyond every pressure. So much
/// would be an elastic volume strain of -2.5.
constexpr double elastic_pressure_max(double E, double nu) { return 30 * isotropic_moduli(E, nu).K; }

} // namespace platen::material
