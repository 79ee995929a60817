#include "plot/measured/fitting_picture.hpp"

#include "core/error.hpp"
#include "plot/fit_picture.hpp"

#include <fmt/format.h>

namespace platen::plot {

void check_fitting_picture(const std::string& law) {
  for (const std::string without : {"pressed", "agarwal", "shahin"})
    if (law == without)
      throw core::InvalidInput(
          fmt::format("--picture: there is none of {} {}; platen compare draws law and curve",
                      law == "pressed" ? "the law" : "a fit of", law));
}

void fitting_picture(const measure::Fitting& fitting, const std::filesystem::path& file) {
  if (const auto* wang = std::get_if<fit::WangFit>(&fitting.fit)) fit_picture(fitting.curve, *wang, file);
  if (const auto* law = std::get_if<fit::FittedLaw>(&fitting.fit)) fit_picture(fitting.curve, *law, file);
}

} // namespace platen::plot
