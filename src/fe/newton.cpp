#include "fe/newton.hpp"

namespace platen::fe {

std::string_view words(Cause cause) {
  switch (cause) {
  case Cause::none:
    break;
  case Cause::inverted_element:
    return "an element turned inside out";
  case Cause::refused_material:
    return "the material found no admissible state";
  case Cause::diverged:
    return "the iteration diverged";
  case Cause::too_many_iterations:
    return "the iteration did not converge";
  case Cause::singular:
    return "the tangent is singular";
  case Cause::stalled:
    return "the linear system could not be solved";
  }
  return "";
}

} // namespace platen::fe
