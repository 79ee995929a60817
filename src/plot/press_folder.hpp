#pragma once
// What a press leaves in a folder.

#include "core/output_folder.hpp"
#include "fit/derivation.hpp"
#include "fit/wang.hpp"
#include "press/case.hpp"
#include "press/result.hpp"

#include <string>

namespace platen::plot {

/// What becomes of the fields that a case asks for.
enum class Fields { pictures, pictures_and_vtu };

/// curve.csv, case.toml, summary.json, pictures and, where fields were asked for, the files of VTK, in the
/// place of those of an earlier press. Gives summary.json. IoError.
std::string write_press(const press::Case&, const press::Result&, const core::OutputFolder&, Fields);

/// Beside these the laws of `derive`: both as law cards, law.toml the pressed one or, if `published_first`,
/// that of edmans-sinka; and the picture of the fit. IoError.
void write_laws(const press::Curve&, const fit::DerivedLaws&, bool published_first,
                const core::OutputFolder&);
/// The same of the law wang.
void write_law(const press::Curve&, const fit::WangFit&, const core::OutputFolder&);

} // namespace platen::plot
