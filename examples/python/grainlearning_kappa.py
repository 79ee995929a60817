"""GrainLearning finds kappa and 1/m of a metal, sigma = kappa epsilon^(1/m), from the force over overlap of one particle.

The law `shahin` of Platen is the model; the measurement is the law itself with 1 % of noise, so that the truth is known.
    pip install grainlearning, and the wheel of platen
"""

import numpy as np
from grainlearning import BayesianCalibration
from grainlearning.dynamic_systems import DynamicSystem

import platen

RADIUS, E, NU = 1e-3, 16e9, 0.43  # m, Pa
TRUTH = {"kappa": 30e6, "inverse_m": 0.2}
overlap = np.linspace(0.02, 0.3, 40) * RADIUS


def force(kappa: float, inverse_m: float) -> np.ndarray:
    """Of the particle on a rigid plane [N]."""
    return platen.law("shahin", E=E, nu=NU, kappa=kappa, inverse_m=inverse_m).on_plane(RADIUS)(overlap).force


def run(calibration: BayesianCalibration) -> None:
    """What GrainLearning calls with its samples of (log10 kappa, 1/m)."""
    system = calibration.system
    system.set_sim_data([[force(10**log_kappa, inverse_m)] for log_kappa, inverse_m in system.param_data])


measured = force(**TRUTH) * (1 + 0.01 * np.random.default_rng(1).standard_normal(len(overlap)))
calibration = BayesianCalibration.from_dict(
    {
        "num_iter": 6,
        "callback": run,
        "system": {
            "system_type": DynamicSystem,
            "param_names": ["log_kappa", "inverse_m"],
            "param_min": [6.5, 0.0],
            "param_max": [8.5, 0.6],
            "num_samples": 60,
            "obs_data": measured,
            "ctrl_data": overlap,
            "sim_name": "platen",
        },
        "inference": {"Bayes_filter": {"ess_target": 0.3}, "sampling": {"max_num_components": 2}},
        "save_fig": -1,
    }
)
calibration.run()
log_kappa, inverse_m = calibration.get_most_prob_params()
print(f"kappa = {10**log_kappa:.4g} Pa (truth {TRUTH['kappa']:.4g}), 1/m = {inverse_m:.4g} (truth {TRUTH['inverse_m']})")
assert abs(10**log_kappa / TRUTH["kappa"] - 1) < 0.05 and abs(inverse_m - TRUTH["inverse_m"]) < 0.02
