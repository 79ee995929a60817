"""From a material to its law, to contacts, to a picture and to LAMMPS."""

import numpy as np

import platen

granule = platen.Material.load("mcc-ph-200")
law = granule.predict()
print(law, law.error.l2, law.valid.delta_bar)
contact = law.pair(radius=0.5e-3, partner=law, partner_radius=0.3e-3)
out = contact(np.linspace(0, 1e-4, 201))
state, overlaps = contact.new_state(10_000), np.linspace(0, 1e-4, 10_000)
print(out.force[-1], out.contact_radius[-1], contact.step(state, overlaps).force.sum())
law.save("law.toml")
print(law.to_lammps(radius=0.3e-3, density=1500))
law.plot().figure.savefig("law.svg")
