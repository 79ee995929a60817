#include "measure/fit_law.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::measure {
namespace {

const std::vector<std::string> laws = {"pressed", "edmans-sinka", "wang", "agarwal", "shahin"};

double checked(double value, std::string_view option, bool allowed, std::string_view range) {
  if (!allowed)
    throw core::InvalidInput(
        fmt::format("{} {}: it must be a number {}", option, core::number_text(value), range));
  return value;
}

/// What a measured curve does not say about its material.
void complete(press::Curve& curve, const std::string& file, const FitOptions& o, const fit::Say& say) {
  if (o.E_Pa) curve.E_Pa = checked(*o.E_Pa, "--E_Pa", *o.E_Pa > 0 && std::isfinite(*o.E_Pa), "> 0");
  if (o.nu) curve.nu = checked(*o.nu, "--nu", *o.nu >= 0 && *o.nu < 0.5, "in [0, 0.5)");
  if (o.phi_deg)
    curve.phi_deg = checked(*o.phi_deg, "--phi_deg", *o.phi_deg >= 0 && *o.phi_deg < 60, "in [0, 60)");
  if (o.sigma_c_Pa)
    curve.sigma_c_Pa =
        checked(*o.sigma_c_Pa, "--sigma_c_Pa", *o.sigma_c_Pa > 0 && std::isfinite(*o.sigma_c_Pa), "> 0");
  if (o.inverse_m)
    curve.inverse_m =
        checked(*o.inverse_m, "--inverse_m", *o.inverse_m >= 0 && *o.inverse_m <= 1, "in [0, 1]");
  if (o.sigma_ref_Pa)
    press::set_reference_stress(curve, checked(*o.sigma_ref_Pa, "--sigma_ref_Pa",
                                               *o.sigma_ref_Pa > 0 && std::isfinite(*o.sigma_ref_Pa), "> 0"));
  if (curve.sigma_ref_Pa > 0) return;
  // Only the product k sigma_ref is in the law, so any reference serves: the largest force over the
  // mid-section.
  double F_max = 0;
  for (const auto& point : curve.points) F_max = std::max(F_max, point.force_N);
  if (F_max > 0)
    press::set_reference_stress(curve, F_max / (std::numbers::pi * curve.radius_m * curve.radius_m));
  say(fmt::format(
      "note: {} says no reference stress; took the largest force over the mid-section, sigma_ref_Pa = {}; "
      "give the yield stress with --sigma_ref_Pa",
      file, core::number_text(curve.sigma_ref_Pa)));
}

/// A law that is fitted to the contact radius cannot be fitted to a measurement.
void refuse_without_radius(const press::Curve& curve, const std::string& law, const std::string& file) {
  const bool none =
      std::ranges::all_of(curve.points, [](const auto& p) { return !(p.contact_radius_m > 0); });
  if (none)
    throw core::InvalidInput(
        fmt::format("{}: {} is fitted to force and contact radius, and there is no radius in this "
                    "curve; platen calibrate --law {} fits it to the force alone",
                    file, law, law));
}

/// A press has no doubts of a measurement; what it does not determine is doubted all the same.
fit::Claim claim_of_bounds(const std::string& file, std::vector<std::string_view> on_bound) {
  fit::Claim claim;
  claim.name = file;
  claim.on_bound = std::move(on_bound);
  return claim;
}

/// kappa of a material that hardens otherwise is not the stress at which it yields.
void refuse_yield_stress_as_kappa(const press::Curve& curve, const std::string& file, const FitOptions& o) {
  if (o.law == "shahin" && !curve.inverse_m && o.inverse_m && *o.inverse_m > 0 && curve.sigma_ref_Pa > 0 &&
      !o.sigma_ref_Pa)
    throw core::InvalidInput(fmt::format(
        "{} is of a material that does not harden as kappa epsilon^(1/m), and its sigma_ref_Pa = {} is "
        "where that yields; give the kappa that goes with --inverse_m {} as --sigma_ref_Pa",
        file, core::number_text(curve.sigma_ref_Pa), core::number_text(*o.inverse_m)));
}

/// The curve with what edmans-sinka makes of it.
fit::Claim claim_of_fit(const press::Curve& curve, const fit::EdmansSinkaFit& f, const std::string& file) {
  fit::Claim claim = claim_of(curve, file);
  claim.R2 = f.r_squared;
  claim.on_bound = f.on_bound();
  // Perfectly plastic: F = 2 pi R delta 2.8 sigma_y, so k sigma_ref = 5.6 sigma_y.
  claim.strength_Pa = f.k * curve.sigma_ref_Pa / 5.6;
  return claim;
}

} // namespace

Fitting fit_law(const InputCurve& input, const FitOptions& o, const fit::Say& say) {
  if (std::find(laws.begin(), laws.end(), o.law) == laws.end())
    throw core::InvalidInput(
        fmt::format("--law {}: there is no such law to fit{}", o.law, core::suggestion(o.law, laws)));
  const auto& file = input.file;
  Fitting f{input.curve, {}, {}, {}};
  press::Curve& curve = f.curve;
  // Grave faults first: what follows would blame something else.
  if (input.measured) f.doubts = pass(doubts_about(claim_of(curve, file)), o.despite_doubts);
  const bool large_deformation = o.law == "agarwal" || o.law == "shahin";
  if (large_deformation && !(curve.sigma_ref_Pa > 0) && !o.sigma_ref_Pa)
    throw core::InvalidInput(
        fmt::format("{} says no reference stress, the {} that {} needs; give --sigma_ref_Pa", file,
                    o.law == "agarwal" ? "yield stress" : "kappa", o.law));
  complete(curve, file, o, say);
  if (!input.measured) refuse_yield_stress_as_kappa(input.curve, file, o);
  if (input.measured && large_deformation) refuse_without_radius(curve, o.law, file);
  if (input.measured)
    f.doubts = pass(doubts_about(claim_of(curve, file)), o.despite_doubts); // E is known now
  if (o.wants_card && !(curve.E_Pa > 0) && (o.law == "pressed" || o.law == "edmans-sinka"))
    throw core::InvalidInput(
        fmt::format("{} says no elasticity, which a law card needs for unloading; give --E_Pa and "
                    "--nu, or leave out -o",
                    file));
  const auto keep = [&](auto fitted) {
    if (o.wants_card) f.card = law_card(curve, fitted, input.text);
    f.fit = std::move(fitted);
  };
  const auto doubt_bounds = [&](const auto& on_bound) { // of a measured curve refused
    for (auto& doubt :
         pass(doubts_about(claim_of_bounds(file, on_bound)), o.despite_doubts || !input.measured))
      f.doubts.push_back(std::move(doubt));
  };
  const auto keep_within_bounds = [&](auto fitted) {
    doubt_bounds(fitted.on_bound);
    keep(std::move(fitted));
  };
  if (o.law == "agarwal") keep_within_bounds(fit::fit_agarwal(curve));
  else if (o.law == "shahin") keep_within_bounds(fit::fit_shahin(curve));
  else if (o.law == "pressed") {
    fit::PressedFit fitted = fit::fit_pressed(curve, fit::unloading_of(curve, say));
    if (input.measured) {
      fit::Claim claim = claim_of(curve, file);
      claim.R2 = fitted.errors.r_squared;
      f.doubts = pass(doubts_about(claim), o.despite_doubts);
    }
    keep(std::move(fitted));
  } else if (o.law == "wang") {
    fit::WangFit fitted = fit::fit_wang(curve);
    for (const auto& sentence : fitted.notes) say(fmt::format("note: {}", sentence));
    keep(std::move(fitted));
  } else {
    fit::FittedLaw fitted = fit::fit_law(curve, o.variant, say);
    if (input.measured)
      f.doubts = pass(doubts_about(claim_of_fit(curve, fitted.loading, file)), o.despite_doubts);
    else doubt_bounds(fitted.loading.on_bound());
    keep(std::move(fitted));
  }
  if (f.card) {
    for (const auto& remark : input.provenance) f.card->provenance.push_back(remark);
    if (!f.doubts.empty())
      f.card->provenance.emplace_back("doubts", fmt::format("{}", fmt::join(f.doubts, "; ")));
  }
  return f;
}

} // namespace platen::measure
