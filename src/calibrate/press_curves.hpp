#pragma once
// The curves of materials near one that was pressed: logarithms, linear in what of the material makes a
// difference to a curve without dimension. A direction is one press on few elements; each material that is
// pressed on the way corrects the slopes (Broyden 1965), so that few presses lead to the one that is looked
// for. All presses are runs of a store: what was pressed once is not pressed again.

#include "calibrate/curves.hpp"
#include "press/curve.hpp"
#include "study/store.hpp"

#include <functional>
#include <memory>
#include <string>

namespace platen::calibrate {

struct PressSettings {
  study::Store store; ///< open for writing
  int workers = 1;
  double delta_bar_max = 0.5;
  int elements = 2500, coarse_elements = 600; ///< coarse: of the directions
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

class PressCurves {
 public:
  /// Presses the material of these values, and once for each direction. ConvergenceError where a press stops
  /// early, Interrupted, IoError of the store; the presses before it are in the store.
  PressCurves(const FreeMaterial&, const std::vector<double>& values, PressSettings);
  ~PressCurves();

  Curves curves() const;
  /// Presses the material of these values and corrects the slopes. How far off the curve had been: root mean
  /// square of ln F.
  double press(const std::vector<double>& values);

  const press::Curve& last() const; ///< of the presses
  int presses() const;

 private:
  struct Local;
  std::shared_ptr<Local> local_;
};

} // namespace platen::calibrate
