#pragma once
// Of each law a material, and overlaps from well below yield to the end of its range: all regimes.

#include <string>

namespace platen::bench {

struct LawCase {
  const char *law, *parameters; ///< beside the radius
  double x_low, x_high;

  [[nodiscard]] std::string name() const {
    std::string text = law;
    for (const char* loading : {"die", "hydrostatic"})
      if (std::string(parameters).find(loading) != std::string::npos) text += std::string("-") + loading;
    return text;
  }
};

inline const LawCase law_cases[] = {
    {"hertz", "E_Pa=1e9 nu=0.3", 1e-6, 1e-2},
    {"similarity", "E_Pa=2e9 nu=0.3 kappa_Pa=1e7 inverse_m=0.3", 1e-4, 3e-2},
    {"edmans-sinka", "E_Pa=4.417e8 nu=0.1472 sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5", 1e-2, 0.5},
    {"wang", "E_Pa=1e10 nu=0.15 phi_deg=25 sigma_c_Pa=15e6", 1e-6, 1e-4},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6", 1e-5, 0.5},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=die", 1e-5, 0.5},
    {"agarwal", "E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=hydrostatic", 1e-5, 0.2},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3", 1e-5, 0.5},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3 loading=die", 1e-5, 0.47},
    {"shahin", "E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3 loading=hydrostatic", 1e-5, 0.19},
    {"thornton-ning", "E_Pa=1e9 nu=0.3 p_y_Pa=1.6e6", 1e-6, 1e-2},
    {"kogut-etsion", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 1e-2},
    {"etsion-unloading", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 1e-2},
    {"jackson-green", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 0.1},
    {"mdr", "E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6", 1e-6, 0.5},
    {"luding", "k_1_N_per_m=1e5 k_2_N_per_m=5e5 phi_f=0.1", 1e-4, 0.2},
    {"eepa", "E_Pa=1e9 nu=0.3 lambda_p=0.6", 1e-4, 0.2},
    {"pressed",
     "E_Pa=2e9 nu=0.3 sigma_ref_Pa=1e7 delta_bar=1e-4,1e-3,1e-2,0.05,0.1,0.2,0.35,0.5 "
     "F_bar=6e-5,1.6e-3,0.035,0.22,0.48,1.1,2.2,4 a_bar=0.009,0.03,0.13,0.32,0.46,0.66,0.85,1 "
     "unload_delta_bar=0.1,0.3,0.5 alpha=1.4,1.3,1.25 beta=1.2,1.5,1.7",
     1e-5, 0.5},
};

} // namespace platen::bench
