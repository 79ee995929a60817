#pragma once
// What a plastic model tells the integrator.
//
// A yield surface is a curve in the (p, q) half-plane q >= 0 (Cauchy stress, tension positive), followed by a
// parameter s from the tensile to the compressive end. A model gives the point and the flow direction at s;
// corners, apices and flat parts are then parts of one curve, and a converged stress lies on the surface
// exactly. The surface and the elastic moduli depend on one state variable phi.
//
//   struct Surface { SurfacePoint at(double s) const; ... };    surface at one phi, with derivatives in phi
//   model.moduli(phi), model.surface(phi), Model::phi_rate      see the concept below

#include <concepts>

namespace platen::material {

/// How a material point flowed in its last increment.
enum class Zone : unsigned char { elastic, shear, compaction, tension };

/// Bulk and shear modulus (Pa) with their derivatives in phi.
struct Moduli {
  double K, G;
  double K_phi = 0, G_phi = 0;
};

/// A point of the yield surface and the unit flow direction there, with derivatives in s and phi.
struct SurfacePoint {
  double p, q;         ///< Pa
  double p_s, q_s;     ///< derivatives in s
  double p_phi, q_phi; ///< derivatives in phi at constant s
  double n_p, n_q;     ///< flow direction: d(eps_v^p) : d(eps_q^p) = n_p : n_q, n_p^2 + n_q^2 = 1
  double n_p_s, n_q_s;
  double n_p_phi, n_q_phi;
};

/// Moduli and yield surface at one phi.
template <class Surface> struct Properties {
  Moduli moduli;
  Surface surface;
};

/// d(phi) = v d(eps_v^p) + w d(eps_q^p).
struct PhiRate {
  double v, w;
};

/// Which bounds of the material description were active at a state (SCHEMAS of the cards: nothing is clamped
/// in silence).
struct Bounds {
  bool rho_r = false;   ///< properties held at their values for rho_r = 1
  bool nu = false;      ///< Poisson's ratio held in [0, 0.49]
  bool epsilon = false; ///< cap axis ratio held at its minimum
  bool pi_3 = false;    ///< cap centred at p = 0
  bool table = false;   ///< hardening table left behind, its last stress held
};

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

template <class M>
concept PlasticModel = requires(const M& model, double phi) {
  { model.moduli(phi) } -> std::same_as<Moduli>;
  { model.surface(phi) } -> YieldSurface;
  { M::phi_rate } -> std::convertible_to<PhiRate>;
};

/// Both at once: a model may offer them together, where that is cheaper.
template <PlasticModel M> auto properties(const M& model, double phi) {
  if constexpr (requires { model.properties(phi); }) return model.properties(phi);
  else return Properties<decltype(model.surface(phi))>{model.moduli(phi), model.surface(phi)};
}

/// K and G of an isotropic material.
constexpr Moduli isotropic_moduli(double E, double nu) {
  return {E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

} // namespace platen::material
