#include "app/measured_arguments.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "measure/dialect.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::app {

using core::InvalidInput;

void add_measured_arguments(Command command, MeasuredArguments& a, bool doubting) {
  const std::string what = "column of the force, where the file's words do not tell it";
  a.force_option = command
                       .add_option("--force", a.read.force,
                                   doubting ? what + "; alone: write the card despite doubts" : what)
                       .type_name("COLUMN[:UNIT]");
  if (doubting) a.force_option->value_optional();
  command.add_option("--displacement", a.read.displacement, "column of the displacement, likewise")
      .type_name("COLUMN[:UNIT]");
  command
      .add_option("--displacement-is", a.read.displacement_is,
                  "travel: between the platens, 2 delta (default); contact: of one platen, delta")
      .type_name("WAY");
  auto radius =
      command
          .add_option("--radius_m", a.radius_m,
                      "radius of the particle, where the file says none; one for each file with commas")
          .type_name("NUMBER");
  command.add_option("--diameter_m", a.diameter_m, "its diameter instead")
      .type_name("NUMBER")
      .excludes(radius);
  auto compliance =
      command.add_option("--compliance_m_per_N", a.compliance_m_per_N, "how much the machine gives way")
          .type_name("NUMBER");
  command.add_option("--empty-machine", a.empty_machine, "a file measured without a particle, for the same")
      .type_name("FILE")
      .excludes(compliance);
}

std::optional<double> diameter_of(const MeasuredArguments& a, std::size_t k, std::size_t files) {
  const bool radius = !a.radius_m.empty();
  const std::string& list = radius ? a.radius_m : a.diameter_m;
  const std::string_view option = radius ? "--radius_m" : "--diameter_m";
  if (list.empty()) return {};
  std::vector<std::string_view> parts;
  measure::split(list, {',', false}, parts);
  if (parts.size() != 1 && parts.size() != files)
    throw InvalidInput(fmt::format("{} {}: {} numbers for {} files; give one for all, or one for each",
                                   option, list, parts.size(), files));
  const auto value = core::number_from(parts.size() == 1 ? parts.front() : parts[k]);
  if (!value || !(*value > 0) || !std::isfinite(*value))
    throw InvalidInput(fmt::format("{} {}: it must be a number > 0", option, list));
  return radius ? 2 * *value : *value;
}

std::vector<measure::Measurement> measurements_of(const std::vector<std::string>& files,
                                                  const MeasuredArguments& a) {
  std::vector<measure::Measurement> all;
  for (std::size_t k = 0; k < files.size(); ++k) {
    measure::ReadOptions options = a.read;
    options.diameter_m = diameter_of(a, k, files.size());
    all.push_back(measure::read_measurement(files[k], options));
  }
  return all;
}

measure::Machine machine_of(const MeasuredArguments& a) {
  return measure::machine_of(a.compliance_m_per_N, a.empty_machine, a.read);
}

measure::CurveOptions curve_options_of(const MeasuredArguments& a) {
  measure::CurveOptions options{a.read, machine_of(a), a.despite_doubts()};
  options.read.diameter_m = diameter_of(a, 0, 1);
  return options;
}

} // namespace platen::app
