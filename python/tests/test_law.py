import csv
import io
import json
import pickle
import subprocess

import numpy as np
import pytest

import platen

LAWS = {
    "hertz": dict(E=1e9, nu=0.3),
    "similarity": dict(E=1e9, nu=0.3, kappa=1e7, inverse_m=0.2),
    "thornton-ning": dict(E=1e9, nu=0.3, p_y=2e7),
    "jackson-green": dict(E=1e9, nu=0.3, sigma_y=1e7),
}


def eval_of_the_command(command, card, overlaps, *options):
    with open("path.csv", "w") as file:
        file.write("overlap_m\n" + "\n".join(repr(float(x)) for x in overlaps) + "\n")
    answer = subprocess.run([command, "eval", card, "--path", "path.csv", *options], capture_output=True, text=True, check=True)
    return list(csv.DictReader(answer.stdout.splitlines()))


def there_and_back(end):
    return np.concatenate([np.linspace(0, end, 40), np.linspace(end, 0.5 * end, 40), np.linspace(0.5 * end, 1.2 * end, 40)])


@pytest.mark.parametrize("against", ["sphere", "plane"])
def test_a_way_is_what_the_command_evaluates(command, law, against):
    law.save("law.toml")
    way = there_and_back(8e-5)
    rows = eval_of_the_command(command, "law.toml", way, "-p", "radius_m=0.5e-3", "--against", against)
    contact = law.pair(radius=0.5e-3) if against == "sphere" else law.on_plane(radius=0.5e-3)
    out = contact(way)
    for name, column in {
        "force": "force_N", "stiffness": "stiffness_N_per_m", "contact_radius": "contact_radius_m",
        "mean_pressure": "mean_pressure_Pa", "dissipated_work": "dissipated_work_J",
    }.items():  # fmt: skip
        assert np.array_equal(getattr(out, name), [float(row[column]) for row in rows])
    assert [platen.BRANCHES[i] for i in out.branch] == [row["branch"] for row in rows]
    assert [str(x).lower() for x in out.in_range] == [row["in_range"] for row in rows]


@pytest.mark.parametrize("name", LAWS)
def test_many_contacts_answer_as_one_after_the_other(name):
    contact = platen.law(name, **LAWS[name]).pair(radius=1e-3, partner_radius=2e-3)
    way = there_and_back(5e-5)
    alone = contact(way)
    state = contact.new_state(3)
    for i, overlap in enumerate(way):
        out = contact.step(state, [overlap, overlap, 0.1 * overlap])
        assert out.force[0] == out.force[1] == alone.force[i]
        assert out.stiffness[0] == alone.stiffness[i] and out.branch[0] == alone.branch[i]
    assert np.array_equal(state.overlap, [way[-1], way[-1], 0.1 * way[-1]])
    assert state.largest_overlap[0] == way.max()


def test_hertz_is_the_closed_form(hertz):
    R, E, nu, overlap = 1e-3, 1e9, 0.3, np.linspace(0, 2e-6, 50)
    E_star = E / (2 * (1 - nu**2))
    force = hertz.pair(radius=R)(overlap).force
    assert force == pytest.approx(4 / 3 * E_star * np.sqrt(R / 2) * overlap**1.5, rel=5e-3, abs=1e-12)


def test_stiffness_is_the_slope_of_the_force(law):
    contact = law.pair(radius=1e-3)
    overlap = np.linspace(1e-6, 2e-4, 2001)
    out = contact(overlap)
    slope = np.gradient(out.force, overlap)
    assert out.stiffness[5:-5] == pytest.approx(slope[5:-5], rel=2e-2)


def test_the_order_of_the_bodies_does_not_matter(law, hertz):
    overlap = np.linspace(0, 5e-5, 100)
    one = law.pair(radius=1e-3, partner=hertz, partner_radius=2e-3)(overlap)
    two = hertz.pair(radius=2e-3, partner=law, partner_radius=1e-3)(overlap)
    assert one.force == pytest.approx(two.force, rel=1e-4)  # each from a table of its own


def test_response_of_a_number_is_numbers(law):
    out = law.pair(radius=1e-3)(1e-5)
    assert out.force.shape == () and float(out.force) > 0 and len(out) == 1


def test_only_and_out_choose_what_is_computed_and_where(law):
    contact = law.pair(radius=1e-3)
    state = contact.new_state(4)
    out = contact.step(state, [1e-6, 2e-6, 3e-6, 4e-6], only=["stiffness"])
    assert out.mean_pressure is None and out.stiffness is not None
    force = out.force
    again = contact.step(state, [2e-6, 3e-6, 4e-6, 5e-6], out=out)
    assert again is out and again.force is force
    with pytest.raises(platen.InvalidInput, match="there is no quantity 'heat'"):
        contact.step(state, [1e-6] * 4, only=["heat"])


def test_gaps_and_other_types_are_taken(law):
    contact = law.pair(radius=1e-3)
    wide = np.linspace(0, 1e-4, 100)
    assert np.array_equal(contact(wide[::2]).force, contact(wide[::2].copy()).force)
    assert np.allclose(contact(wide.astype(np.float32)).force, contact(wide).force, rtol=1e-5)
    assert np.array_equal(contact(list(wide)).force, contact(wide).force)
    assert np.array_equal(contact(wide[::-1]).force, contact(wide[::-1].copy()).force)
    assert contact([0, 0]).force.tolist() == [0, 0]


def test_a_state_is_reordered_as_neighbours_change(law):
    contact = law.pair(radius=1e-3)
    state = contact.new_state(4)
    contact.step(state, [1e-6, 2e-6, 3e-6, 4e-6])
    assert state[2:].largest_overlap.tolist() == [3e-6, 4e-6]
    assert state[state.overlap > 1.5e-6].overlap.tolist() == [2e-6, 3e-6, 4e-6]
    assert state[-1].overlap.tolist() == [4e-6]
    assert state.rebuilt([3, -1, 0]).largest_overlap.tolist() == [4e-6, 0, 1e-6]
    copy = state.copy()
    contact.step(copy, [9e-6] * 4)
    assert state.overlap.tolist() == [1e-6, 2e-6, 3e-6, 4e-6]


def test_pickles(law, granule, pressed):
    for thing in (law, granule, pressed.fit()):
        assert pickle.loads(pickle.dumps(thing)) == thing
    assert pickle.loads(pickle.dumps(pressed.curve)).text == pressed.curve.text
    contact = law.pair(radius=1e-3, partner=platen.law("hertz", E=1e9, nu=0.3))
    state = contact.new_state(3)
    contact.step(state, [1e-6, 2e-6, 3e-6])
    contact2, state2 = pickle.loads(pickle.dumps((contact, state)))
    assert np.array_equal(contact2.step(state2, [2e-6] * 3).force, contact.step(state, [2e-6] * 3).force)


def test_what_laws_say_of_themselves():
    known = platen.laws()
    assert {"hertz", "pressed", "edmans-sinka", "wang"} <= set(known)
    assert known["hertz"].source and known["hertz"].validity and "E_Pa" in str(known["hertz"])


def test_parameters_are_read_and_written_under_the_keys_of_the_card(law):
    parameters = law.parameters
    assert parameters["E_Pa"] == parameters.E_Pa == pytest.approx(51.3 * 8.61e6)
    assert isinstance(parameters.F_bar, np.ndarray)
    again = platen.law(law.name, **{key: value for key, value in parameters.items()})
    assert np.array_equal(again.pair(radius=1e-3)([1e-5, 5e-5]).force, law.pair(radius=1e-3)([1e-5, 5e-5]).force)


def test_lammps_lines_are_those_of_the_command(command, law):
    law.save("law.toml")
    answer = subprocess.run(
        [command, "export", "lammps", "law.toml", "--radius", "3e-4", "--density", "1500"], capture_output=True, text=True, check=True
    )
    assert law.to_lammps(radius=3e-4, density=1500) == answer.stdout


def test_texts_and_tables_are_those_of_the_command(law, command, tmp_path):
    law.save(tmp_path / "law.toml")
    run = lambda *words: subprocess.run([command, "export", *words], check=True, capture_output=True, text=True).stdout  # noqa: E731
    run("dem-engine", "law.toml", "--friction", "0.3", "--restitution", "0.5", "-o", "theirs")
    law.to_dem_engine("ours", restitution=0.5, friction=0.3)
    for name in ("functions.cu", "model.cu", "platen_model.py"):
        assert (tmp_path / "ours" / name).read_text() == (tmp_path / "theirs" / name).read_text()
    theirs = run("table", "law.toml", "-p", "radius_m=1e-3", "--overlap", "1e-6:1e-5:3")
    ours = platen.Law.load("law.toml").to_table(np.linspace(1e-6, 1e-5, 3), radius=1e-3)
    assert [line for line in ours.splitlines() if line[0] != "#"] == [line for line in theirs.splitlines() if line[0] != "#"]
    for overlap, sentence in (([], "at least one overlap"), ([1e9], "held constant"), ([np.inf], "held constant"), ([0], "above 0")):
        with pytest.raises(platen.InvalidInput, match=sentence):
            law.to_table(overlap, radius=1e-3)
    with pytest.raises(platen.InvalidInput, match="restitution"):
        law.to_dem_engine("ours", restitution=0)


def test_laws_of_two_numbers():
    E, nu, R = 3e9, 0.25, 2e-3
    hertz = platen.law("hertz", E=E, nu=nu).to_parameters(radius=R, delta_bar=0.01)
    assert hertz.hertz.E_Pa == pytest.approx(E, rel=1e-6) and hertz.hertz.force_relative_l2 < 1e-5 and hertz.restitution == 1
    # of 4/3 E* sqrt(R/2) x^1.5 the nearest line has the slope 3 int x^2.5 dx = 6/7 sqrt(end), and misses 1 - 48/49 of the square
    end = 2 * R * 0.01
    line = 4 / 3 * E / (2 * (1 - nu**2)) * np.sqrt(R / 2) * 6 / 7 * np.sqrt(end)
    assert hertz.springs.k_1_N_per_m == pytest.approx(line, rel=1e-5)
    assert hertz.springs.force_relative_l2 == pytest.approx(1 / 7, rel=1e-3)
    assert hertz.springs.k_2_N_per_m == pytest.approx(line, rel=1e-5)
    springs = platen.law("luding", k_1=1e4, k_2=5e4, phi_f=0.1).to_parameters(radius=R, delta_bar=0.02)
    assert springs.springs.k_1_N_per_m == pytest.approx(1e4, rel=1e-4) and springs.springs.force_relative_l2 < 1e-3
    plastic = platen.Material.load("von-mises-100").predict().to_parameters(radius=R)
    assert 0 < plastic.restitution < 0.5 and plastic.springs.k_2_N_per_m > 4 * plastic.springs.k_1_N_per_m
    assert plastic.restitutions[0][1] > plastic.restitutions[-1][1]


def test_formulas_are_those_of_the_exact_command(law, command):
    law.save("law.toml")
    overlap = np.linspace(0, 2e-4, 21)
    line = [command, "eval", "law.toml", "-p", "radius_m=1e-3", "--overlap", "0:2e-4:21", "--exact"]
    theirs = np.genfromtxt(io.StringIO(subprocess.run(line, check=True, capture_output=True, text=True).stdout), delimiter=",",
                           names=True, usecols=(0, 1, 2, 4))  # fmt: skip
    contact = law.pair(radius=1e-3)
    exact = contact(overlap, exact=True)
    assert exact.force == pytest.approx(theirs["force_N"], rel=1e-12)
    assert exact.stiffness == pytest.approx(theirs["stiffness_N_per_m"], rel=1e-12)
    assert exact.force == pytest.approx(contact(overlap).force, rel=1e-3) and not np.array_equal(exact.force, contact(overlap).force)
    with pytest.raises(platen.InvalidInput, match="overlap 0 is nan"):
        contact(np.nan, exact=True)


def test_initial_yield_is_that_of_the_command(command):
    rock = platen.law("wang", E=1e10, nu=0.15, phi=25, sigma_c=15e6)
    line = [command, "laws", "wang", "--json", "-p", "radius_m=0.1", "-p", "E_Pa=1e10", "-p", "nu=0.15", "-p", "phi_deg=25", "-p", "sigma_c_Pa=15e6"]
    theirs = json.loads(subprocess.run(line, check=True, capture_output=True, text=True).stdout)
    assert rock.initial_yield(0.1) == pytest.approx(theirs)
    plane = rock.initial_yield(0.1, against="plane")
    assert plane.gamma_y_m < theirs["gamma_y_m"] and rock.initial_yield(0.1, nu2=0.3).p0_Pa <= theirs["p0_Pa"]
    for call, sentence in (
        (lambda: platen.law("hertz", E=1e9, nu=0.3).initial_yield(1e-3), "this is hertz"),
        (lambda: rock.initial_yield(-1), "radius"),
        (lambda: rock.initial_yield(0.1, against="wall"), "neither sphere nor plane"),
        (lambda: rock.initial_yield(0.1, colour=3), "colour"),
    ):
        with pytest.raises(platen.InvalidInput, match=sentence):
            call()
