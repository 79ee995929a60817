#pragma once
// The three papers as rows. Each file of a paper says what it prints, beside what our presses say.

#include "reproduce/data.hpp"
#include "reproduce/row.hpp"

#include <string>
#include <vector>

namespace platen::reproduce {

/// What a press is good for: errors of ours, relative. Forces and radii:
/// docs/explanation/what-can-be-trusted.md.
inline constexpr double force_error = 0.015, radius_error = 0.03, pressure_error = 0.06, fit_error = 0.03;
/// Of a formula that is evaluated on both sides.
inline constexpr double formula_error = 1e-9;

struct Paper {
  std::string name;  ///< as the command takes it
  std::string title; ///< authors, year, title
  std::string notation;
  std::string without_row; ///< figures and tables that hold no result
  std::vector<Row> rows;
};

std::vector<std::string> paper_names();
/// InvalidInput for an unknown name and for what the catalogue lacks.
Paper paper_rows(const std::string& name, const Data&);

std::vector<Row> edmans_sinka_model_rows(const Data&); ///< section 4: models, zones
std::vector<Row> edmans_sinka_law_rows(const Data&);   ///< sections 5, 6, appendix A: the law
std::vector<Row> wang_rows(const Data&);
std::vector<Row> shahin_hardening_rows(const Data&); ///< chapter 3; of chapter 2: shahin.hpp

/// Pools and presses, by name, that the rows of a paper are made of.
struct Sources {
  std::vector<std::string> pools, presses;
};
Sources sources_of(const std::string& paper);

} // namespace platen::reproduce
