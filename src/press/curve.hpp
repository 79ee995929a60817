#pragma once
// The curve of a press: one row for each converged step.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace platen::press {

enum class Branch { loading, unloading, reloading };

/// The contact with one plane. Forces and overlaps: compression positive.
struct PlanePoint {
  double delta_m = 0;
  double force_N = 0;
  double contact_radius_m = 0;
  double mean_pressure_Pa = 0;
  double peak_pressure_Pa = 0;
};

/// One converged step; columns of curve.csv under the same names. The plane along z, and of a confined press
/// those along x and y, each a whole plane. Energies are those of one side: the whole sphere pressed from
/// both sides, halved.
struct CurvePoint : PlanePoint {
  int branch_id = 0; ///< 0: loading; others count the branches
  Branch branch = Branch::loading;
  double delta_bar = 0; ///< delta/R0
  double F_bar = 0;     ///< F/(pi R0^2 sigma_ref)
  double zone_elastic = 1, zone_shear = 0, zone_compaction = 0,
         zone_tension = 0; ///< fractions of reference volume
  double work_J = 0, stored_J = 0, dissipated_J = 0;
  double rho_r_mean = 1, rho_r_min = 1, rho_r_max = 1;
  double sigma_1_max_Pa = 0;
  double equator_displacement_m = 0; ///< outwards, of the point of the sphere on the x axis
  double hertz_delta_m = 0;          ///< delta with the far field of the finite sphere taken out: Hertz's
  double mises_max_Pa = 0;           ///< largest von Mises stress at a Gauss point
  int iterations = 0;
  std::array<PlanePoint, 2> side; ///< planes along x and y
  double cell_filling = 0; ///< volume of the undeformed particle over that of the cell; 0: no closed cell
  double mesh_quality = 0; ///< least scaled Jacobian

  /// Along z, x, y.
  PlanePoint& plane(int k) { return k == 0 ? *this : side[k - 1]; }
  const PlanePoint& plane(int k) const { return k == 0 ? *this : side[k - 1]; }
};

/// A curve with what is needed to read it.
struct Curve {
  double radius_m = 0;
  double sigma_ref_Pa = 0;
  double E_Pa = 0;
  double nu = 0;
  std::string experiment;
  std::string material;
  std::string version; ///< of the program that pressed; filled by the press
  int engine = 0;
  std::vector<CurvePoint> points;
  // Of the local press, 0 where unknown: the Drucker-Prager strength that makes the curve dimensionless.
  double phi_deg = 0;
  double sigma_c_Pa = 0;
  /// Of sigma = kappa epsilon^(1/m), kappa being sigma_ref; not for other materials.
  std::optional<double> inverse_m = {};
};

/// Where the loading branch ends; the first point where there is none, null where there is no point at all.
inline const CurvePoint* loading_end(const Curve& curve) {
  const CurvePoint* end = nullptr;
  for (const auto& point : curve.points)
    if (!end || (point.branch == Branch::loading && !(point.delta_bar < end->delta_bar))) end = &point;
  return end;
}

} // namespace platen::press
