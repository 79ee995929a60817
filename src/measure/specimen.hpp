#pragma once
// Particles pressed between platens, as an instrument saw them: travel, force and time in SI units and in
// their order, with what was found in the file said in words.

#include "measure/sheet.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace platen::measure {

/// What the file does not say, or says wrongly; all may be left out.
struct ReadOptions {
  std::string force, displacement; ///< COLUMN or COLUMN:UNIT
  /// "travel": the way between the platens, 2 delta; "contact": of one platen, delta. Empty: travel, unless
  /// the column is our own delta_m.
  std::string displacement_is;
  std::optional<double> diameter_m; ///< of all particles
};

struct Specimen {
  std::string file, name;
  int first_line = 0;
  std::optional<double> diameter_m;
  std::vector<double> time_s;             ///< empty where the file has none
  std::vector<double> travel_m, force_N;  ///< growing as the platens close; compression positive
  std::vector<int> line;                  ///< of the file
  bool contact_overlap = false;           ///< travel_m is delta, that of one platen
  double travel_sign = 1, force_sign = 1; ///< -1: turned
  Unit travel_unit, force_unit;           ///< of the file
  std::string travel_column, force_column;

  double radius_m() const { return *diameter_m / 2; }
  /// delta for a way of the platens.
  double per_travel() const { return contact_overlap ? 1 : 0.5; }
  /// On the scale of the file, in its unit: "-11.7 um".
  std::string on_scale_of_file(double travel) const;
};

struct Measurement {
  std::string file, sha256, read_as; ///< read_as: encoding and dialect in words
  std::vector<Specimen> specimens;
  std::vector<std::string> said; ///< what was found, turned and left out, a sentence each
};

/// All particles of a file. InvalidInput says file, line and column, and what to write: for a column that is
/// missing, there twice, or without a unit; for text in place of a number; for two diameters.
Measurement read_measurement(const std::filesystem::path&, const ReadOptions& = {});
Measurement read_measurement(const Text&, const ReadOptions& = {});

} // namespace platen::measure
