#pragma once
// What the rows are made of: numbers that the papers print, pools, single presses; all files of a catalogue.

#include "core/csv.hpp"
#include "press/curve.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace platen::reproduce {

/// A branch of a run over delta/R0. Of a die: the walls too.
struct BranchCurve {
  std::vector<double> x, F, a, F_side, a_side;

  double F_at(double x_at) const; ///< monotone cubic; not-a-number outside
  double a_at(double x_at) const;
  double H_at(double x_at) const; ///< F/a^2: mean pressure over sigma_ref
};

/// A pool of the catalogue.
struct Pool {
  std::string name, engine;
  core::Csv runs;
  std::map<int, BranchCurve> loading; ///< by run, from 1

  std::size_t size() const { return runs.rows.size(); }
  bool done(int run) const;
  std::string text(int run, std::string_view column) const;
  /// Nothing where the cell is empty or the column is missing.
  std::optional<double> value(int run, std::string_view column) const;
  double number(int run, std::string_view column) const; ///< InvalidInput where there is none
  /// The first run that is done whose columns have these values (relative 1e-6); InvalidInput where there is
  /// none.
  int find(const std::map<std::string, double>& values) const;
};

/// The loading branch of a curve.csv, as that of a pool.
BranchCurve loading_of(const press::Curve&);

/// A pool's curve with what fits of a metal need.
press::Curve metal_curve(const BranchCurve&, std::string_view experiment, double E_Pa, double nu,
                         double sigma_y_Pa);

class Data {
 public:
  /// Folders that are searched, in this order, for papers/, pools/ and tables/.
  explicit Data(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// InvalidInput where no folder has it.
  std::filesystem::path file(const std::string& below) const;
  const Pool& pool(const std::string& name) const;
  /// A curve.csv of papers/presses/NAME.
  const press::Curve& press(const std::string& name) const;
  /// A number that a paper prints, papers/PAPER.csv.
  double printed(std::string_view paper, std::string_view key) const;
  core::Csv table(const std::string& name) const; ///< tables/NAME

  struct Source {
    std::string name, engine, date;
    std::size_t runs = 0;
  };
  /// Pools and presses used so far; dates from papers/sources.csv, where it has them.
  std::vector<Source> sources() const;

 private:
  std::vector<std::filesystem::path> folders_;
  mutable std::map<std::string, Pool> pools_;
  mutable std::map<std::string, press::Curve> presses_;
  mutable std::map<std::string, std::map<std::string, double>, std::less<>> printed_;
};

} // namespace platen::reproduce
