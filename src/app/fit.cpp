#include "app/commands.hpp"
#include "app/fit_report.hpp"
#include "app/large_deformation_report.hpp"
#include "app/measured_arguments.hpp"
#include "app/wang_report.hpp"
#include "core/file.hpp"
#include "core/say.hpp"
#include "measure/fit_law.hpp"
#include "plot/measured/fitting_picture.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string curve, law, variant = "published", card, picture;
  MeasuredArguments measured;
  std::optional<double> sigma_ref_Pa, E_Pa, nu, phi_deg, sigma_c_Pa, inverse_m;
  bool json = false;
};

measure::FitOptions options_of(const Options& o) {
  return {o.law,          o.variant,   o.sigma_ref_Pa,
          o.E_Pa,         o.nu,        o.phi_deg,
          o.sigma_c_Pa,   o.inverse_m, o.measured.despite_doubts(),
          !o.card.empty()};
}

/// Words, or JSON.
struct Report {
  const press::Curve& curve;
  bool json;
  std::string operator()(const fit::PressedFit& f) const { return json ? fit_json(curve, f) : fit_words(f); }
  std::string operator()(const FittedLaw& f) const { return json ? fit_json(curve, f) : fit_words(f); }
  std::string operator()(const fit::WangFit& f) const { return json ? wang_json(curve, f) : wang_words(f); }
  std::string operator()(const fit::AgarwalFit& f) const {
    return json ? agarwal_json(curve, f) : agarwal_words(curve, f);
  }
  std::string operator()(const fit::ShahinFit& f) const {
    return json ? shahin_json(curve, f) : shahin_words(curve, f);
  }
};

void fit_curve(const Options& o) {
  if (!o.picture.empty()) plot::check_fitting_picture(o.law);
  const auto input = measure::read_curve(o.curve, curve_options_of(o.measured));
  const auto fitting = measure::fit_law(input, options_of(o), core::say_line);
  if (fitting.card) core::write_file(o.card, text_of(*fitting.card));
  if (!o.picture.empty()) plot::fitting_picture(fitting, o.picture);
  fmt::print(report_stream(o.card), "{}", std::visit(Report{fitting.curve, o.json}, fitting.fit));
  for (const auto& flag : fitting.doubts) core::say_line("doubted: " + flag);
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
