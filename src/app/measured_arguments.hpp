#pragma once
// What a command is told about files of instruments.

#include "app/command_line.hpp"
#include "measure/input_curve.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::app {

struct MeasuredArguments {
  measure::ReadOptions read;
  std::string radius_m, diameter_m; ///< one number, or one for each file with commas between
  std::optional<double> compliance_m_per_N;
  std::string empty_machine;
  std::optional<Option> force_option;

  /// --force alone, without a column: doubts do not refuse.
  bool despite_doubts() const { return force_option && force_option->given() && read.force.empty(); }
};

/// --force with or without a column, --displacement, --displacement-is, --radius_m, --diameter_m,
/// --compliance_m_per_N,
/// --empty-machine
/// `doubting`: the command has doubts, which --force alone overrules.
void add_measured_arguments(Command, MeasuredArguments&, bool doubting);

/// The diameter that the options give the k-th of `files` files; nothing where they give none. InvalidInput.
std::optional<double> diameter_of(const MeasuredArguments&, std::size_t k, std::size_t files);

/// The files as they were written; InvalidInput for what they, or the options, do not say.
std::vector<measure::Measurement> measurements_of(const std::vector<std::string>& files,
                                                  const MeasuredArguments&);
measure::Machine machine_of(const MeasuredArguments&);
/// Of one curve.
measure::CurveOptions curve_options_of(const MeasuredArguments&);

} // namespace platen::app
