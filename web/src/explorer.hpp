#pragma once
// The state behind the page: a material, the law predicted for it, a contact that is dragged, a measured
// curve.

#include "fit/law_card.hpp"
#include "json.hpp"
#include "material/models.hpp"
#include "surrogate/assess.hpp"
#include "surrogate/rock.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::web {

struct Asked {
  double radius_m, density; ///< [m], [kg/m^3]
  bool on_plane;            ///< against a rigid plane; else two equal spheres
  std::vector<std::string> beside;
};

/// Of name, model and parameters. InvalidInput.
material::Material material_of(const law::ParameterTexts&);

class Explorer {
 public:
  /// A surrogate, or the grains of rock.
  void load(const std::string& file);
  int prepare();
  std::string predict(const law::ParameterTexts& material);
  std::string nearest_of(const std::vector<std::string>& runs) const;
  std::string curves(const Asked&, std::vector<double>& numbers);
  void step(double overlap, std::vector<double>& numbers);
  void forget() { state_ = {}; }
  std::string file(const std::string& name, double radius_m, double density, bool on_plane) const;
  std::string measured(const std::string& bytes, const std::string& name, std::vector<double>& numbers);
  std::string fit_strength(const law::ParameterTexts& material, double radius_m);

 private:
  surrogate::Answer ask(const material::Material&) const;
  const surrogate::RockInterpolation& between_grains();
  fit::LawCard predicted(const material::Material&);
  Json pressed();
  Json rock();
  law::Law law_of(double radius_m, bool on_plane) const;
  const fit::LawCard& card() const;

  std::vector<surrogate::Surrogate> surrogates_;
  surrogate::Rock rock_;
  std::optional<surrogate::RockInterpolation> between_grains_; ///< of rock_
  std::optional<material::Material> material_;
  std::optional<fit::LawCard> card_; ///< as `platen predict -o` writes it
  std::string pool_;                 ///< that the law is from
  std::vector<double> knots_, band_; ///< none of rock
  law::Law law_;
  law::State state_;
  std::vector<double> delta_m_, force_N_; ///< measured: loading of one platen
};

} // namespace platen::web
