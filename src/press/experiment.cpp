#include "press/experiment.hpp"

namespace platen::press {

AnyResult press(const Case& c, const Progress& progress) {
  if (c.experiment == "local") return local(c, progress);
  if (is_confined(c.experiment)) return confined(c, progress);
  return simple(c, progress);
}

} // namespace platen::press
