"""GrainLearning drives a calibration: it draws sets of parameters, platen says what the particles say of each.

pip install grainlearning
python3 calibrate.py PLATEN GRANULES.txt
"""

import csv
import json
import subprocess
import sys

import numpy as np
from grainlearning import BayesianCalibration
from grainlearning.dynamic_systems import DynamicSystem

platen, curves = sys.argv[1], sys.argv[2]
names, low, high = ["kappa_Pa", "inverse_m"], [1e6, 0.1], [10e6, 0.9]


def ask(sets):
    """The forces of each set of parameters, and those that were measured, where particles are well in contact."""
    with open("asked.csv", "w", newline="") as file:
        csv.writer(file).writerows([names, *sets])
    subprocess.run([platen, "calibrate", curves, "--law", "shahin", "--nu", "0.3", "--E", "0.3 GPa", "--ask", "asked.csv",
                    "--tell", "told.json"], check=True, stdout=subprocess.DEVNULL)
    with open("told.json") as file:
        told = json.load(file)
    measured = np.concatenate([particle["force_N"] for particle in told["measured"]])
    rows = np.flatnonzero(measured > 0.1 * measured.max())[::10]
    forces = [np.concatenate(one["force_N"])[rows] for one in told["sets"]]
    return measured[rows], np.array(forces)


def run(calibration):
    system = calibration.system
    system.set_sim_data(ask(system.param_data)[1][:, None, :])


measured, _ = ask([[np.sqrt(low[0] * high[0]), 0.5]])
calibration = BayesianCalibration.from_dict({
    "num_iter": 5,
    "callback": run,
    "system": {
        "system_type": DynamicSystem, "param_names": names, "param_min": low, "param_max": high,
        "num_samples": 60, "obs_data": measured, "ctrl_data": np.arange(len(measured)),
    },
    "inference": {"Bayes_filter": {"ess_target": 0.3, "scale_cov_with_max": True},
                  "sampling": {"max_num_components": 2, "random_state": 0}},
    "save_fig": -1,
})
calibration.run()
for name, value in zip(names, calibration.get_most_prob_params()):
    print(f"{name} = {value:.4g}")
