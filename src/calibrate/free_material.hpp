#pragma once
// A material of which some parameters are looked for in measured curves.

#include "calibrate/free_parameters.hpp"
#include "core/toml.hpp"
#include "material/card.hpp"
#include "platen/law/parameter_reader.hpp"

#include <string>
#include <vector>

namespace platen::calibrate {

/// Whether a model of material has this name.
bool is_material_model(const std::string& name);

class FreeMaterial {
 public:
  /// `what`: a model, a card, or a name in the catalogue. `given`: parameters that are known, which replace
  /// those of the card. `free`: keys that are looked for; empty: E and the strength. The other strengths of a
  /// card go with the reference stress, as its ratios (Gamma_bar). InvalidInput for keys that the model does
  /// not have, for what is neither given nor free, for rock.
  FreeMaterial(const std::string& what, const law::ParameterTexts& given, std::vector<std::string> free);

  const std::vector<FreeParameter>& free() const { return free_; }
  /// InvalidInput where there is no such material.
  material::Material with(const law::ParameterTexts&) const;
  /// A material of the kind, to see what is known of it.
  material::Material typical() const { return with({}); }
  const std::string& strength() const { return strength_; } ///< key of its strength; empty: it has none
  /// Values of the free parameters in the card that it was made of; empty where there is none.
  const std::vector<double>& of_card() const { return of_card_; }
  /// What stays as it is: "rho_r0 = 0.4, nu = 0.1472".
  std::string held() const;

 private:
  void read_model(const std::string& model);
  void set(const std::string& key, double value);
  FreeParameter sought(const std::string& key, bool known) const;

  core::Table card_;
  std::vector<core::FieldInfo> fields_;
  std::vector<FreeParameter> free_;
  std::vector<double> of_card_;
  std::string strength_;
};

} // namespace platen::calibrate
