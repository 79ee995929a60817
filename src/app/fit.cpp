#include "app/commands.hpp"
#include "app/fit_report.hpp"
#include "app/large_deformation_report.hpp"
#include "app/measured_curve.hpp"
#include "app/wang_report.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string curve, law, variant = "published", card, picture;
  MeasuredArguments measured;
  std::optional<double> sigma_ref_Pa, E_Pa, nu, phi_deg, sigma_c_Pa, inverse_m;
  bool json = false;
};

const std::vector<std::string> laws = {"pressed", "edmans-sinka", "wang", "agarwal", "shahin"};

double checked(double value, std::string_view option, bool allowed, std::string_view range) {
  if (!allowed)
    throw core::InvalidInput(
        fmt::format("{} {}: it must be a number {}", option, core::number_text(value), range));
  return value;
}

/// What a measured curve does not say about its material, from the command line.
void complete(press::Curve& curve, const Options& o) {
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
  core::say(fmt::format(
      "note: {} says no reference stress; took the largest force over the mid-section, sigma_ref_Pa = {}; "
      "give the yield stress with --sigma_ref_Pa\n",
      o.curve, core::number_text(curve.sigma_ref_Pa)));
}

void fit_wang_to(const press::Curve& curve, const Options& o) {
  const auto fit = fit::fit_wang(curve);
  for (const auto& sentence : fit.skipped) core::say(fmt::format("note: {}\n", sentence));
  if (!o.card.empty()) core::write_file(o.card, text_of(fit::law_card(curve, fit, core::read_file(o.curve))));
  if (!o.picture.empty()) draw_wang_fit(curve, fit, o.picture);
  fmt::print("{}", o.json ? wang_json(curve, fit) : wang_words(fit));
}

void fit_large_deformation_to(const press::Curve& curve, const Options& o) {
  if (!o.picture.empty())
    throw core::InvalidInput(
        fmt::format("--picture: there is none of a fit of {}; platen compare draws law and curve", o.law));
  const auto report = [&](const auto& fit, const auto& words, const auto& json) {
    if (!o.card.empty())
      core::write_file(o.card, text_of(fit::law_card(curve, fit, core::read_file(o.curve))));
    fmt::print("{}", o.json ? json(curve, fit) : words(curve, fit));
  };
  if (o.law == "agarwal") report(fit::fit_agarwal(curve), agarwal_words, agarwal_json);
  else report(fit::fit_shahin(curve), shahin_words, shahin_json);
}

/// The curve with what edmans-sinka makes of it.
fit::Claim claim_of_fit(const press::Curve& curve, const FittedLaw& law, const Options& o) {
  fit::Claim claim = claim_of(curve, o.curve);
  const auto& f = law.loading;
  claim.R2 = f.r_squared;
  constexpr double least_a = 1.1e-3,
                   most_a = 49.9; // the search's own ends, docs/explanation/edmans-sinka-fit.md
  if (f.a < least_a || f.a > most_a) claim.on_bound.push_back("a");
  // Perfectly plastic: F = 2 pi R delta 2.8 sigma_y, so k sigma_ref = 5.6 sigma_y.
  claim.strength_Pa = f.k * curve.sigma_ref_Pa / 5.6;
  return claim;
}

void fit_curve(const Options& o) {
  if (std::find(laws.begin(), laws.end(), o.law) == laws.end())
    throw core::InvalidInput(
        fmt::format("--law {}: there is no such law to fit{}", o.law, core::suggestion(o.law, laws)));
  auto [curve, measured, provenance] = curve_of(o.curve, o.measured);
  // Grave faults first: what follows would blame something else.
  auto flags = measured ? pass(doubts_about(claim_of(curve, o.curve)), o.measured.despite_doubts())
                        : std::vector<std::string>{};
  const bool large_deformation = o.law == "agarwal" || o.law == "shahin";
  if (large_deformation && !(curve.sigma_ref_Pa > 0) && !o.sigma_ref_Pa)
    throw core::InvalidInput(
        fmt::format("{} says no reference stress, the {} that {} needs; give --sigma_ref_Pa", o.curve,
                    o.law == "agarwal" ? "yield stress" : "kappa", o.law));
  complete(curve, o);
  if (measured && large_deformation) refuse_without_radius(curve, o.law, o.curve);
  if (measured)
    flags = pass(doubts_about(claim_of(curve, o.curve)), o.measured.despite_doubts()); // E is known now
  if (o.law == "wang") return fit_wang_to(curve, o);
  if (large_deformation) return fit_large_deformation_to(curve, o);
  if (!o.card.empty() && !(curve.E_Pa > 0))
    throw core::InvalidInput(
        fmt::format("{} says no elasticity, which a law card needs for unloading; give --E_Pa and "
                    "--nu, or leave out -o",
                    o.curve));
  if (o.law == "pressed") {
    if (!o.picture.empty())
      throw core::InvalidInput(
          "--picture: there is none of the law pressed; platen compare draws law and curve");
    const fit::PressedFit pressed = fit::fit_pressed(curve, unloading_of(curve));
    if (!o.card.empty()) {
      auto card = fit::law_card(curve, pressed, core::read_file(o.curve));
      for (const auto& remark : provenance) card.provenance.push_back(remark);
      if (!flags.empty()) card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(flags, "; ")));
      core::write_file(o.card, text_of(card));
    }
    fmt::print("{}", o.json ? fit_json(curve, pressed) : fit_words(pressed));
    for (const auto& flag : flags) core::say(fmt::format("doubted: {}\n", flag));
    return;
  }
  const FittedLaw law = fit_law(curve, o.variant);
  if (measured) flags = pass(doubts_about(claim_of_fit(curve, law, o)), o.measured.despite_doubts());
  if (!o.card.empty()) {
    auto card = fit::law_card(curve, law.loading, law.unloading, core::read_file(o.curve));
    for (const auto& remark : provenance) card.provenance.push_back(remark);
    if (!flags.empty()) card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(flags, "; ")));
    core::write_file(o.card, text_of(card));
  }
  if (!o.picture.empty()) draw_fit(curve, law, o.picture);
  fmt::print("{}", o.json ? fit_json(curve, law) : fit_words(law));
  for (const auto& flag : flags) core::say(fmt::format("doubted: {}\n", flag));
}

} // namespace

void add_fit(Command program) {
  auto command = program.add_subcommand("fit", "fit a contact law to a curve, pressed or measured");
  auto o = std::make_shared<Options>();
  command
      .add_option("CURVE.csv", o->curve,
                  "curve.csv of a press, columns delta_m,force_N, or an instrument's file")
      .required();
  command
      .add_option("--law", o->law,
                  "law to fit: pressed (the curve itself), edmans-sinka, wang, agarwal, shahin")
      .required()
      .type_name("NAME");
  command.add_option("--variant", o->variant, variant_help).type_name("V").capture_default_str();
  command.add_option("-o", o->card, "write the law card here").type_name("LAW.toml");
  command.add_option("--picture", o->picture, "draw curve, law and residual: .svg or .png").type_name("FILE");
  add_measured_arguments(command, o->measured, true);
  command.add_option("--sigma_ref_Pa", o->sigma_ref_Pa, "stress that makes forces dimensionless")
      .type_name("NUMBER");
  command.add_option("--E_Pa", o->E_Pa, "Young's modulus, for a measured curve").type_name("NUMBER");
  command.add_option("--nu", o->nu, "Poisson's ratio, for a measured curve").type_name("NUMBER");
  command.add_option("--phi_deg", o->phi_deg, "wang: friction angle, for a curve that does not say it")
      .type_name("NUMBER");
  command.add_option("--sigma_c_Pa", o->sigma_c_Pa, "wang: uniaxial compressive strength, likewise")
      .type_name("NUMBER");
  command.add_option("--inverse_m", o->inverse_m, "shahin: 1/m of sigma = kappa epsilon^(1/m), likewise")
      .type_name("NUMBER");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Example: platen fit out/curve.csv --law edmans-sinka -o law.toml\n"
                 "         platen fit measured.csv --radius_m 0.5e-3 --law edmans-sinka");
  command.callback([o] { fit_curve(*o); });
}

} // namespace platen::app
