"""What is wrong ends in an exception with a sentence, never in a crash."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import platen

quick = settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck))


def test_exceptions_are_those_that_python_would_raise():
    assert issubclass(platen.InvalidInput, ValueError) and issubclass(platen.InvalidInput, platen.Error)
    assert issubclass(platen.IoError, OSError) and issubclass(platen.ConvergenceError, ArithmeticError)


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda: platen.Material.load("mcc-ph-20"), "did you mean 'mcc-ph-200'?"),
        (lambda: platen.Material.load("nowhere.toml"), "nowhere.toml: there is no such file"),
        (lambda: platen.Law.load("herz"), "there is no law or law card 'herz'"),
        (lambda: platen.von_mises(sigma_y=-1, E=1e9, nu=0.3), "sigma_y_Pa = -1"),
        (lambda: platen.von_mises(sigma_y=1e6, E=1e9), "nu is missing"),
        (lambda: platen.von_mises(sigma_y=1e6, E=1e9, nu=0.3, E_bar=3), "exactly one of the two"),
        (lambda: platen.von_mises(sigma_y=math.nan, E=1e9, nu=0.3), "sigma_y_Pa = nan"),
        (lambda: platen.von_mises(sigma_y=1e6, E=1e9, nu=0.3, colour=3), "there is no such key"),
        (lambda: platen.elastic(E="stiff", nu=0.3), "E_Pa"),
        (lambda: platen.law("hertz", E=1e9), "hertz: nu is missing"),
        (lambda: platen.law("hertz", E=1e9, nu=0.7), "nu = 0.7 is not in [0, 0.5)"),
        (lambda: platen.law("hertz", E=math.nan, nu=0.3), "E_Pa = 'nan' is not a number"),
        (lambda: platen.law("herz", E=1), "there is no law 'herz'"),
        (lambda: platen.law("hertz", "exotic", E=1e9, nu=0.3), "there is no variant 'exotic'"),
        (lambda: platen.law("hertz", E=1e9, E_Pa=1e9, nu=0.3), "given twice"),
        (lambda: platen.Material.load("elastic").derive("wish"), "no such law to derive"),
        (lambda: platen.Material.load("elastic").press("squeeze"), "squeeze"),
        (lambda: platen.Material.load("elastic").press(delta_bar_max=2), "delta_bar_max = 2"),
        (lambda: platen.Material.load("elastic").press(elemants=3), "elemants"),
        (lambda: platen.Material.load("elastic").press(radius=-1), "radius_m = -1"),
        (lambda: platen.press("no\ncase = 1\n"), "the case"),
        (lambda: platen.press("nowhere.toml"), "nowhere.toml: there is no such file"),
        (lambda: platen.Curve.load("nowhere.csv"), "nowhere.csv"),
        (lambda: platen.fit("nowhere.csv"), "nowhere.csv: there is no such file"),
        (lambda: platen.import_curve("nowhere.csv"), "nowhere.csv"),
        (lambda: platen.calibrate([], "hertz"), "no file"),
        (lambda: platen.calibrate("nowhere.csv", "hertz", radius=1, diameter=2), "not both"),
    ],
)
def test_sentences(call, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        call()
    assert sentence in str(raised.value)


def test_unwritable_files_are_input_output_errors(law):
    with pytest.raises(platen.IoError, match="cannot be written"):
        law.save("no/such/folder/law.toml")
    with pytest.raises(OSError):
        platen.Material.load("elastic").save("/proc/none")


def test_a_law_that_is_in_no_file_is_not_for_lammps(hertz):
    with pytest.raises(platen.InvalidInput, match="in no file yet"):
        hertz.to_lammps(radius=1e-3, density=1500)


def test_lammps_lines_of_types(hertz, tmp_path):
    hertz.save(tmp_path / "hertz.toml")
    lines = hertz.to_lammps(hertz, radius=[1e-3, 2e-3], density=1500, delta_bar=0.01)
    assert "# type 1: law hertz, radius 0.001 m, 1500 kg/m^3" in lines
    assert "# type 2: law hertz, radius 0.002 m, 1500 kg/m^3" in lines
    with pytest.raises(platen.InvalidInput, match="2 types need one for all"):
        hertz.to_lammps(hertz, radius=[1e-3, 2e-3, 3e-3], density=1500)


@pytest.mark.parametrize("radius", [0, -1e-3, math.nan, -math.inf])
def test_radii_are_positive(law, hertz, radius):
    for make in (law.on_plane, law.pair, lambda radius: law.pair(1e-3, hertz, radius), lambda radius: law.pair(radius, hertz)):
        with pytest.raises(platen.InvalidInput):
            make(radius=radius)


@pytest.mark.parametrize("radius", ["1", None, [1e-3], True, 1j])
def test_radii_are_numbers(law, radius):
    with pytest.raises(TypeError):
        law.pair(radius=radius)


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf])
def test_overlaps_are_finite_and_leave_the_state_alone_where_not(law, wrong):
    contact = law.pair(radius=1e-3)
    state = contact.new_state(3)
    contact.step(state, [1e-6, 2e-6, 3e-6])
    with pytest.raises(platen.InvalidInput, match="overlap 2 is .*: overlaps must be finite numbers"):
        contact.step(state, [2e-6, 3e-6, wrong])
    assert state.overlap.tolist() == [1e-6, 2e-6, 3e-6]
    with pytest.raises(platen.InvalidInput):
        contact(wrong)


@pytest.mark.parametrize("wrong", ["abc", ["a"], [1j], [None], [True], object(), {"a": 1}])
def test_overlaps_are_numbers(law, wrong):
    with pytest.raises(TypeError):
        law.pair(radius=1e-3)(wrong)


def test_shapes_fit(law):
    contact = law.pair(radius=1e-3)
    state = contact.new_state(3)
    with pytest.raises(platen.InvalidInput, match="2 overlaps for a state of 3 contacts"):
        contact.step(state, [1e-6, 1e-6])
    with pytest.raises(platen.InvalidInput, match="shape"):
        contact(np.zeros((2, 2)))
    out = contact.step(state, [1e-6] * 3)
    out.force = np.empty(2)
    with pytest.raises(platen.InvalidInput, match="force has 2 numbers for 3 overlaps"):
        contact.step(state, [1e-6] * 3, out=out)
    for force in (np.empty(6)[::2], np.empty(3, dtype=np.float32), np.empty((3, 1)), "force", None):
        out.force = force
        with pytest.raises(TypeError):
            contact.step(state, [1e-6] * 3, out=out)
    frozen = np.empty(3)
    frozen.flags.writeable = False
    out.force = frozen
    with pytest.raises(TypeError):
        contact.step(state, [1e-6] * 3, out=out)
    assert contact(np.empty(0)).force.shape == (0,) and len(contact.new_state(0)) == 0
    with pytest.raises(platen.InvalidInput):
        contact.new_state(-1)
    with pytest.raises((MemoryError, ValueError)):
        contact.new_state(2**61)


def test_a_state_belongs_to_its_contact(law, hertz):
    state = law.pair(radius=1e-3).new_state(3)
    for other in (hertz.pair(radius=1e-3), law.pair(radius=2e-3), law.on_plane(radius=1e-3)):
        with pytest.raises(platen.InvalidInput, match="the state is that of another contact"):
            other.step(state, [1e-6] * 3)
    for no_state in (None, 3, np.zeros((3, 2))):
        with pytest.raises(TypeError):
            law.pair(radius=1e-3).step(no_state, [1e-6] * 3)
    for index in (7, [0, 9], "a", 1.5):
        with pytest.raises(IndexError):
            state[index]
    with pytest.raises(IndexError):
        state.rebuilt([-2])
    with pytest.raises(TypeError):
        state.rebuilt([0.5])


def test_partners_are_laws(law, hertz):
    with pytest.raises(TypeError, match="must be a Law"):
        law.pair(radius=1e-3, partner="hertz")
    with pytest.raises(platen.InvalidInput, match="second body"):
        platen.law("hertz", E=1e9, nu=0.3, E2=2e9, nu2=0.3).pair(1e-3, law)


numbers = st.floats(width=64)
anything = st.one_of(numbers, st.integers(), st.text(max_size=5), st.none(), st.booleans(), st.lists(numbers, max_size=4))


@quick
@given(arrays.arrays(st.sampled_from([np.float64, np.float32, np.int64, np.uint8, np.complex128, np.bool_]),
                     arrays.array_shapes(min_dims=0, max_dims=2, min_side=0, max_side=6)))  # fmt: skip
def test_fuzz_overlaps(law, overlap):
    contact = law.pair(radius=1e-3)
    try:
        force = contact(overlap).force
    except (platen.InvalidInput, TypeError):
        return
    assert np.all(np.isfinite(force)) and np.all(force >= 0)


@quick
@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=2, max_size=12))
def test_fuzz_ways_stay_finite(law, hertz, way):
    for contact in (law.on_plane(radius=1e-3), hertz.pair(radius=1e-3)):
        out = contact(way)
        assert np.all(out.force >= 0) and np.all(np.isfinite(out.force)) and np.all(out.contact_radius >= 0)


@quick
@given(st.text(max_size=12), st.lists(numbers, max_size=3), st.lists(numbers, max_size=3))
def test_fuzz_states_from_outside(law, key, overlap, largest):
    """A pickle that was tampered with."""
    from platen._contact import _state

    contact = law.pair(radius=1e-3)
    try:
        state = _state(contact._core.key, np.array(overlap), np.array(largest))
    except platen.InvalidInput:
        return
    try:
        force = contact.step(state, np.full(len(state), 1e-6)).force
        assert np.all(np.isfinite(force))
    except platen.InvalidInput as error:
        assert "beyond any that this contact remembers" in str(error)
    with pytest.raises(platen.InvalidInput):
        contact.step(_state("key " + key, np.array(overlap), np.array(largest)), np.full(len(state), 1e-6))


@quick
@given(st.sampled_from(sorted(platen.laws())), st.dictionaries(
    st.sampled_from(["E", "nu", "sigma_y", "kappa", "inverse_m", "radius", "k", "delta_t", "a", "F_bar", "x", "against"]),
    anything, max_size=5))  # fmt: skip
def test_fuzz_parameters(name, parameters):
    try:
        law = platen.law(name, **parameters)
        law.on_plane(radius=1e-3)(1e-6)
    except (platen.InvalidInput, TypeError):
        return


@quick
@given(anything, anything)
def test_fuzz_radii(law, hertz, radius, partner_radius):
    try:
        law.pair(radius=radius, partner=hertz, partner_radius=partner_radius)(1e-7)
    except (platen.InvalidInput, TypeError):
        return


@quick
@given(st.text(max_size=60))
def test_fuzz_texts(text):
    from platen import _core

    for parse in (_core.LawCard.parse, _core.MaterialCard.parse):
        with pytest.raises(platen.InvalidInput):
            parse(text, "a text")
    with pytest.raises(platen.InvalidInput):
        _core.parse_curve(text, "a text", 1e-3)


@quick
@given(st.dictionaries(st.sampled_from(["E", "nu", "sigma_y", "E_bar", "hardening", "name"]), anything, max_size=5))
def test_fuzz_materials(keywords):
    try:
        platen.von_mises(**keywords)
    except (platen.InvalidInput, TypeError, AttributeError):
        return


@quick
@given(arrays.arrays(st.sampled_from([np.float64, np.float32, np.int64, np.bool_, np.complex128]),
                     arrays.array_shapes(min_dims=0, max_dims=3, max_side=4)), st.sampled_from(["implicit", "after-step", "else"]))  # fmt: skip
def test_fuzz_ways_of_a_point(granule, way, moduli):
    try:
        table = granule.point(way, moduli=moduli)
    except (platen.InvalidInput, platen.ConvergenceError, TypeError):
        return
    assert len(table) == len(way) + 1 and np.all(np.isfinite(table["p_Pa"]))


@quick
@given(st.text(max_size=12), anything, anything)
def test_fuzz_questions(pressed, name, ranges, value):
    try:
        platen.compare(pressed.curve, name, ranges=ranges, E=value)
    except (platen.InvalidInput, platen.IoError, TypeError, ValueError):
        return


@settings(quick, max_examples=60)
@given(numbers, numbers, numbers)
def test_fuzz_exports(law, radius, delta_bar, friction):
    for call in (lambda: law.to_parameters(radius=radius, delta_bar=delta_bar),
                 lambda: law.to_dem_engine("engine", friction=friction, restitution=delta_bar),
                 lambda: law.to_table([delta_bar, friction], radius=radius)):  # fmt: skip
        try:
            call()
        except (platen.InvalidInput, TypeError):
            pass


@quick
@given(st.sampled_from(["radius", "radius2", "E2", "nu2", "against"]), anything)
def test_fuzz_initial_yield(key, value):
    rock = platen.law("wang", E=1e10, nu=0.15, phi=25, sigma_c=15e6)
    try:
        found = rock.initial_yield(**{"radius": 0.1, key: value})
    except (platen.InvalidInput, TypeError):
        return
    assert all(np.isfinite(number) for number in found.values())


@quick
@given(numbers, numbers, numbers, numbers, numbers)
def test_fuzz_yield_stresses(E, nu, one, other, radius):
    for call in (lambda: platen.yield_from_hardness(E=E, nu=nu, hardness=one),
                 lambda: platen.yield_from_heckel(E=E, nu=nu, pressure=one),
                 lambda: platen.yield_from_crushing(E=E, nu=nu, force=one, overlap=other, radius=radius)):  # fmt: skip
        try:
            assert np.isfinite(call()) and call() > 0
        except platen.InvalidInput:
            pass


@settings(quick, max_examples=100)
@given(st.dictionaries(st.sampled_from(["share", "seed", "until", "workers", "cheapest", "progress"]), anything, max_size=4))
def test_fuzz_checks_of_a_pool(tmp_path, keywords):
    (tmp_path / "study.toml").write_text("platen = 1\n")
    with pytest.raises((platen.InvalidInput, platen.IoError, TypeError, ValueError, OverflowError)):
        platen.Pool(tmp_path).check(**keywords)


@settings(quick, max_examples=100)
@given(st.dictionaries(st.sampled_from(["tasks", "slurm"]), anything, max_size=2))
def test_fuzz_jobs(tmp_path, keywords):
    from test_study import CARD

    (tmp_path / "study.toml").write_text(CARD)
    try:
        script = platen.Study.load(tmp_path / "study.toml").batch_script(**keywords)
    except (platen.InvalidInput, TypeError, ValueError, OverflowError):
        return
    assert script.startswith("#!/bin/bash")


@settings(quick, max_examples=100)
@given(st.text(max_size=200), st.booleans())
def test_fuzz_surrogates(text, of_rock):
    from platen._pool import _surrogate

    with pytest.raises(platen.InvalidInput):
        _surrogate(text, "a text", of_rock)


@settings(quick, max_examples=100)
@given(st.dictionaries(st.sampled_from(["material", "free", "variant", "asked", "workers", "profiles", "confined", "store", "picture"]),
                       anything, max_size=3))  # fmt: skip
def test_fuzz_calibrations(keywords):
    with pytest.raises((platen.InvalidInput, platen.IoError, TypeError, ValueError, OverflowError, AttributeError)):
        platen.calibrate("nowhere.csv", "hertz", nu=0.3, **keywords)


@settings(quick, max_examples=60)
@given(arrays.arrays(np.float64, arrays.array_shapes(min_dims=0, max_dims=2, min_side=0, max_side=6)))
def test_fuzz_exact_overlaps(law, overlap):
    try:
        force = law.pair(radius=1e-3)(overlap, exact=True).force
    except platen.InvalidInput:
        return
    assert np.all(np.isfinite(force)) and np.all(force >= 0)


def test_a_truncated_pickle_is_pythons_own_error(law):
    with pytest.raises(Exception):
        pickle.loads(pickle.dumps(law)[:-5])
