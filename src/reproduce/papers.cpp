#include "reproduce/papers.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "reproduce/shahin.hpp"

#include <fmt/format.h>

#include <iterator>

namespace platen::reproduce {

std::vector<std::string> paper_names() { return {"edmans-sinka", "wang", "shahin"}; }

namespace {

void append(std::vector<Row>& rows, std::vector<Row> more) {
  rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

[[noreturn]] void refuse(const std::string& name) {
  throw core::InvalidInput(
      fmt::format("there is no paper '{}'{}", name, core::suggestion(name, paper_names())));
}

} // namespace

Paper paper_rows(const std::string& name, const Data& data) {
  if (name == "edmans-sinka") {
    Paper paper{
        name,
        "Edmans & Sinka: Numerical derivation of a normal contact law for compressible plastic particles",
        "F̄ = F/(πR₀²σ_y), δ̄ = δ/R₀; Ē₀, Γ̄₀, Λ̄₀: stiffness, shear and tensile strength over the "
        "hydrostatic yield stress.",
        "Figs 3 and 5 (mesh, scheme) and Tables 1, 2, 4, 5, 6 (symbols, formulas, inputs) hold no "
        "result; the inputs are cards and tables of the catalogue.",
        edmans_sinka_model_rows(data)};
    append(paper.rows, edmans_sinka_law_rows(data));
    return paper;
  }
  if (name == "wang")
    return {name,
            "Wang, Li, Yang, Huang & Zhou (2018): A simple model for elastic-plastic contact of granular "
            "geomaterials",
            "a, b, m, n in the paper's convention: the approach of both centres over that of one sphere at "
            "first yield; elastic limit 2^(−3/2) and 3/2.",
            "Fig. 1 (mesh) and Table 1 (inputs) hold no result.", wang_rows(data)};
  if (name == "shahin") {
    Paper paper{name,
                "Shahin (2021): Contact laws for large deformation unconfined and confined compression of "
                "spherical plastic particles with power-law hardening",
                "γ/2R = δ/R: overlap; H̄ = F/(πa²σ_y); λ = E/((1 − ν²)σ_y), ζ = B/σ_y. Forces here are over "
                "πR²σ_y (πR²κ), where the thesis has σ_yR² in some figures.",
                "Figs 2.2, 2.5, 2.7, 2.8, 2.24, B.1 (schemes, mesh) and Tables 2.1, 2.3, 3.2, 3.3, A.1, E.1 "
                "(bounds, formulas, inputs) hold no result.",
                lead_rows(data)};
    for (const auto rows :
         {raw_rows, coefficient_rows, plastic_law_rows, side_rows, coefficient_tables, shahin_hardening_rows})
      append(paper.rows, rows(data));
    return paper;
  }
  refuse(name);
}

Sources sources_of(const std::string& name) {
  if (name == "edmans-sinka")
    return {{"edmans-sinka", "von-mises", "elastic"},
            {"base-vmdc", "base-dpc", "corner-E3-G025-L001", "corner-E3-G025-L1", "corner-E3-G1-L001",
             "corner-E3-G1-L1", "corner-E500-G025-L001", "corner-E500-G025-L1", "corner-E500-G1-L001",
             "corner-E500-G1-L1"}};
  if (name == "wang")
    return {{"wang"},
            {"wang-type-1", "wang-type-2", "sandstone-3-3", "sandstone-3-4", "sandstone-3-4-k",
             "sandstone-mohr-coulomb", "sandstone-von-mises"}};
  if (name == "shahin")
    return {{"shahin", "shahin-hardening", "von-mises"}, {"lead-simple", "lead-die", "lead-hydrostatic"}};
  refuse(name);
}

} // namespace platen::reproduce
