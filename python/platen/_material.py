"""Materials: what a particle is made of. A material has no radius."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._cards import Record, key_of, structured, tell, toml_lines, write
from ._errors import ConvergenceError, InvalidInput
from ._law import Law
from ._press import ZONES, Press, press_case

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._pool import Sensitivity


class Material:
    """A material card.

    >>> granule = platen.Material.load("mcc-ph-200")
    >>> law = granule.predict()
    """

    __slots__ = ("_card", "remarks")

    def __init__(self, card: _core.MaterialCard, remarks: list[str] | None = None) -> None:
        self._card = card
        self.remarks = remarks or []
        """of a material from a deck, or from compaction: how it was read"""

    @classmethod
    def load(cls, what: str | os.PathLike[str]) -> Material:
        """A card by path, or one of the catalogue by name: `platen.materials()` lists them."""
        return cls(_core.MaterialCard.find(os.fspath(what)))

    @classmethod
    def from_abaqus(
        cls,
        deck: str | os.PathLike[str],
        *,
        units: str = "",
        material: str = "",
        rho_r0: float | None = None,
        despite_doubts: bool = False,
    ) -> Material:
        """A material from an input file of Abaqus, as `platen convert`: *ELASTIC, *DENSITY, *PLASTIC, *DRUCKER PRAGER, *CAP
        PLASTICITY, *MOHR COULOMB with their hardening. `units` of the file: "si", "mm-tonne-MPa", "mm-kg-GPa", "m-tonne-kPa" or
        "in-lbf-psi"; `material` names one of several; `rho_r0` is the relative density at volumetric plastic strain 0 of a cap.
        What has no counterpart here is a warning; numbers that are those of no material are refused, unless
        `despite_doubts`."""
        card, said, left_over, doubts = _core.from_deck(os.fspath(deck), units, material, rho_r0, despite_doubts)
        tell([f"without counterpart: {line}" for line in left_over] + [f"doubted: {doubt}" for doubt in doubts])
        return cls(card, said)

    @classmethod
    def from_compaction(
        cls,
        test: str | os.PathLike[str],
        strengths: str | os.PathLike[str],
        *,
        rho_r0: float,
        model: str = "vmdc",
        name: str = "",
    ) -> Material:
        """A porous material, "vmdc" or "dpc", from die compaction and tablet strengths, as `platen compaction`. `test`: a CSV
        with rho_r, axial_stress_MPa, radial_stress_MPa (or _Pa, _kPa) in the order of the test; `strengths`: rho_r,
        compressive_strength_MPa (uniaxial), tensile_strength_MPa (diametral) of tablets; `rho_r0`: relative density of the
        granules that will be pressed. `remarks` are the lines of the command, `sources` say what each number is from."""
        card, found = _core.from_compaction(os.fspath(test), os.fspath(strengths), float(rho_r0), model, name)
        return cls(card, found["words"].splitlines())

    @classmethod
    def from_indices(
        cls, *, strain: float, bonding: float, hardness: float, relative_density: float, name: str = "granule of indices"
    ) -> Material:
        """A granule of relative density 0.7 from Hiestand's indices of compacts of `relative_density`: strain index H/E',
        bonding index sigma_T/H, `hardness` H [Pa]; what they do not say is the base case's. As `platen predict
        --strain_index`. InvalidInput where the indentation is partly elastic, or a compact is stronger in tension than in
        shear."""
        return cls(_core.from_indices(float(strain), float(bonding), float(hardness), float(relative_density), name))

    def to_abaqus(self, units: str) -> str:
        """The material as a section of an input file of Abaqus, in these units (those of `from_abaqus`). What Abaqus lacks is a
        warning; "vmdc" is refused."""
        text, left_over = _core.to_deck(self._card, units)
        tell(f"without counterpart: {line}" for line in left_over)
        return text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the card, in SI units."""
        write(path, self.text)

    @property
    def name(self) -> str:
        return self._card.name

    @property
    def model(self) -> str:
        """How cards name the constitutive model."""
        return self._card.model

    @property
    def text(self) -> str:
        """The card as it stands in a file."""
        return self._card.text()

    @property
    def parameters(self) -> Record:
        """Numbers of the model under the keys of the card."""
        return Record({key: value for key, value, _ in self._card.parameters})

    @property
    def sources(self) -> dict[str, str]:
        """Where values are from, by key or `default`."""
        return dict(self._card.sources)

    @property
    def E(self) -> float:
        """Young's modulus of the undeformed material [Pa]"""
        return self._card.E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the undeformed material"""
        return self._card.nu

    @property
    def sigma_ref(self) -> float:
        """The stress that makes forces dimensionless, F_bar = F/(pi R^2 sigma_ref) [Pa]"""
        return self._card.sigma_ref

    @property
    def density(self) -> float | None:
        """Of the undeformed particle [kg/m^3]"""
        return self._card.density

    def as_model(self, name: str) -> Material:
        """The same strengths on another yield surface: "vmdc", "dpc", "dpc-published" or "von-mises"."""
        return Material(self._card.as_model(name))

    def predict(
        self, law: str = "", *, variant: str = "published", quick: bool = False, extrapolate: bool = False
    ) -> Law:
        """Its law at once, from materials that were pressed: "pressed", "edmans-sinka"; of rock (drucker-prager) "wang"; none:
        "pressed", of rock "wang". `law.error.l2` is what is expected of it,
        `law.provenance.verdict` whether it lies inside of them, `law.near` the nearest, `law.prediction` the rest. Outside it is refused, unless
        `extrapolate` allows to guess. Of a powder a press on few elements comes first, 0.2 s; `quick` leaves it out and is
        less sure."""
        card, said, near, found = _core.predict(self._card, law, variant, quick, extrapolate)
        tell(said)
        return Law(card, near=near, prediction=Record(found))

    def point(
        self,
        way: str | os.PathLike[str] | npt.ArrayLike,
        *,
        strain: float = -0.2,
        lateral: float = 0.0,
        compaction: float = 0.0,
        steps: int = 100,
        moduli: str = "implicit",
        picture: str | os.PathLike[str] = "",
    ) -> Any:
        """Leads one material point along a way: "isotropic", "uniaxial-strain", "triaxial", "shear"; the path of a CSV with
        eps_1,eps_2,eps_3; or an array (n, 3) of principal logarithmic strains, extension positive, each row a state.

        `strain` is that at the end, of the volume (isotropic) or of axis 1; `lateral` the stress on axes 2 and 3 [Pa], tension
        positive (triaxial); `compaction` the logarithmic volume lost before (shear); `moduli` "implicit" or "after-step". One
        row a step, the start first: step, eps_1 .. 3, sigma_1_Pa .. 3, p_Pa (tension positive), q_Pa, phi (state variable of the
        model), rho_r, zone. A structured array: `table["q_Pa"]`. ConvergenceError where a step is refused; its attribute
        `points` is the way until then. `picture` draws the way and the yield surface, .svg or .png; it needs gnuplot."""
        name, rows = _way(way)
        numbers, zones, refusal = _core.walk(self._card, name, rows, strain, lateral, compaction, steps, moduli,
                                             os.fspath(picture))  # fmt: skip
        numbers = numbers.reshape(len(zones), -1)
        columns: list[tuple[str, Any]] = [("step", np.arange(len(zones)))]
        columns += [(key, numbers[:, i]) for i, key in enumerate(_POINT_COLUMNS)]
        table = structured([*columns, ("zone", [ZONES[zone] for zone in zones])])
        if refusal:
            refused = ConvergenceError(f"{refusal}; the way until then is the attribute points of this error")
            refused.points = table
            raise refused
        return table

    def press(
        self,
        experiment: str = "simple",
        *,
        radius: float = 1e-3,
        progress: bool | Callable[[float, float, float], Any] = False,
        estimate_error: bool = False,
        **path: Any,
    ) -> Press:
        """A virtual press: "simple", "local", "die", "hydrostatic" or "triaxial"; `radius` in m.

        The keys of a case card are keywords: `delta_bar_max`, `unload_from`, `reload`, `elements`, `step_max`,
        `fields_at`, ...; `platen.keys("case")` is a page of them all. `progress=True` draws a bar; a function is called with the
        fraction done, delta/R and force [N]. `estimate_error` presses a coarser mesh too. Ctrl-C ends it."""
        sections: dict[str, dict[str, Any]] = {"path": {}, "mesh": {}, "output": {}}
        for keyword, value in path.items():
            key = key_of(keyword, _CASE_KEYS)
            sections[_CASE_KEYS.get(key, "path")][key] = value
        head = toml_lines({"platen": 1, "experiment": experiment, "radius_m": radius})
        body = "".join(f"[{section}]\n{toml_lines(values)}" for section, values in sections.items() if values)
        return press_case(head + body + _inline(self.text), "the case", progress, estimate_error)

    def derive(
        self,
        law: str = "pressed",
        *,
        variant: str = "published",
        delta_bar_max: float | None = None,
        unload_from: Iterable[float] | None = None,
        radius: float = 1e-3,
        elements: int | None = None,
        force_max: float | None = None,
        progress: bool | Callable[[float, float, float], Any] = False,
        estimate_error: bool = False,
        folder: str | os.PathLike[str] = "",
    ) -> Law:
        """Its law by the main way: a press and a fit. "pressed" is the curve itself, "edmans-sinka" its published form,
        "wang" that of small contacts in stiff grains (`force_max` [N] is for it). Pressed to delta/R = `delta_bar_max`, by
        default 0.5; unloaded from `unload_from`, by default at five places. The law does not depend on `radius` [m].
        `law.curve` is the curve. `folder`: where to leave what `platen derive` does, cards, curve, pictures (charts need
        gnuplot)."""
        if law not in ("pressed", "edmans-sinka", "wang"):
            raise InvalidInput(f"law {law!r}: there is no such law to derive; there are pressed, edmans-sinka, wang")
        places = None if unload_from is None else [float(x) for x in unload_from]
        if law == "wang":
            case = _core.local_case(self._card, radius, delta_bar_max, force_max, places)
        else:
            if force_max is not None:
                raise InvalidInput("force_max is for the law wang; give delta_bar_max")
            end = 0.5 if delta_bar_max is None else delta_bar_max
            case = _core.simple_case(self._card, radius, end, elements, places)
        pressed = press_case(case, "the case", progress, estimate_error)
        if os.fspath(folder):
            pressed._pressed.save_derivation(law, variant, os.fspath(folder))
        return pressed.fit(law, variant=variant)

    def sobol(self, *, within: float = 0.2, picture: str | os.PathLike[str] = "") -> Sensitivity:
        """Which of its numbers matters: Sobol indices of force and energies through the surrogates of the catalogue, as each
        number goes `within` so much of itself to either side, as far as the pool reaches. `picture` draws them, .svg or .png; it
        needs gnuplot."""
        from ._pool import Sensitivity

        found = _core.sobol(self._card, float(within), os.fspath(picture))
        found["numbers"] = [Record(number) for number in found["numbers"]]
        return Sensitivity(found)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Material) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return _material, (self.text, self._card.file, self.remarks)

    def __repr__(self) -> str:
        return f"<Material {self.name}: {self.model}>"

    def __str__(self) -> str:
        lines = [f"{self.name}: model {self.model}"]
        for key, value, meaning in self._card.parameters:
            lines.append(f"  {key:<18} {value:<12.6g} {meaning}")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        from ._svg import table_html

        rows = [(key, f"{value:.6g}", meaning) for key, value, meaning in self._card.parameters]
        return table_html(f"{self.name}: model {self.model}", rows)


_POINT_COLUMNS = ("eps_1", "eps_2", "eps_3", "sigma_1_Pa", "sigma_2_Pa", "sigma_3_Pa", "p_Pa", "q_Pa", "phi", "rho_r")


def _way(way: Any) -> tuple[str, Any]:
    if isinstance(way, (str, os.PathLike)):
        name = os.fspath(way)
        named = name in _core.ways or not os.path.exists(name)
        return name, [] if named else _core.read_strains(name)
    rows = np.asarray(way)
    if rows.dtype.kind not in "iuf":
        raise TypeError(f"the way must be numbers, not {rows.dtype}")
    if rows.ndim != 2 or rows.shape[1] != 3 or len(rows) == 0:
        raise InvalidInput(f"the way must be rows of three strains, not an array of shape {rows.shape}")
    return "the way", rows.astype(float).tolist()


_CASE_KEYS = {
    **dict.fromkeys(("elements", "step_max", "edges", "first_contact_bar"), "mesh"),
    **dict.fromkeys(("fields_at", "fields_at_N"), "output"),
    **dict.fromkeys(("delta_bar_max", "unload_from", "reload", "force_max_N", "unload_from_N"), "path"),
}


def _inline(text: str) -> str:
    return "[material]\n" + text.replace("[parameters]", "[material.parameters]")


def _material(text: str, file: str, remarks: list[str]) -> Material:
    card = _core.MaterialCard.parse(text, file or "a pickled material")
    card.file = file
    return Material(card, remarks)


def materials() -> list[str]:
    """Names of the materials of the catalogue, for `Material.load`."""
    return _core.card_names("materials")


def yield_from_hardness(*, E: float, nu: float, hardness: float) -> float:
    """Yield stress [Pa] of a perfectly plastic metal from its indentation hardness [Pa], H = 2.8 sigma_y (Tabor), as `platen
    predict --hardness_Pa`. InvalidInput where the indentation cannot be fully plastic."""
    return float(_core.yield_from_hardness(float(E), float(nu), float(hardness)))


def yield_from_heckel(*, E: float, nu: float, pressure: float) -> float:
    """Yield stress [Pa] of a perfectly plastic material from the yield pressure [Pa] of its tablets out of the die, P_y = 3
    sigma_y (Heckel), as `platen predict --heckel_Pa`. InvalidInput where the grains would spring back."""
    return float(_core.yield_from_heckel(float(E), float(nu), float(pressure)))


def yield_from_crushing(*, E: float, nu: float, force: float, overlap: float, radius: float) -> float:
    """Yield stress [Pa] of a perfectly plastic metal for a sphere of `radius` [m] to carry `force` [N] between two plates at the
    `overlap` [m] of each, half of what they came together, as `platen predict --crush_force_N`. InvalidInput where none
    does."""
    return float(_core.yield_from_crushing(float(E), float(nu), float(force), float(overlap), float(radius)))


def keys(of: str) -> str:
    """Every key of a card, as Markdown: of a "material", a "case" or a "study"."""
    pages = {"material": _core.material_keys, "case": _core.case_keys, "study": _core.study_keys}
    if of not in pages:
        raise InvalidInput(f"there are no keys of {of!r}; there are those of a {', '.join(pages)}")
    return pages[of]()


def _made(model: str, name: str | None, hardening: Mapping[str, Any] | None, given: dict[str, Any]) -> Material:
    keys = ("E_Pa", "sigma_y_Pa", "Gamma_Pa", "Lambda_Pa", "beta_deg", "phi_deg", "psi_deg", "sigma_c_Pa", "cohesion_Pa",
            "tension_cutoff_Pa", "tensile_strength_Pa", "density_kg_per_m3")  # fmt: skip
    values: dict[str, Any] = {}
    for keyword, value in given.items():
        key = key_of(keyword, keys)
        if value is not None and key in values:
            raise InvalidInput(f"{key} is given twice")
        if value is not None:
            values[key] = value
    if hardening is not None:
        inner = ("kappa_Pa", "K_Pa", "stress_Pa")
        values["hardening"] = {key_of(keyword, inner): value for keyword, value in hardening.items()}
    head = toml_lines({"platen": 1, "name": name or model, "model": model})
    file = f"platen.{model.replace('-', '_')}()"
    return Material(_core.MaterialCard.parse(f"{head}[parameters]\n{toml_lines(values)}", file))


def elastic(*, E: float | None = None, nu: float | None = None, name: str | None = None, **more: Any) -> Material:
    """Linear elastic: Young's modulus E [Pa], Poisson's ratio nu. `more`, of any model: density [kg/m^3],
    tensile_strength [Pa]."""
    return _made("elastic", name, None, {"E": E, "nu": nu, **more})


def von_mises(
    *,
    sigma_y: float | None = None,
    E: float | None = None,
    nu: float | None = None,
    E_bar: float | None = None,
    hardening: Mapping[str, Any] | None = None,
    name: str | None = None,
    **more: Any,
) -> Material:
    """A metal: uniaxial yield stress sigma_y [Pa], Young's modulus E [Pa] or E_bar = E/sigma_y, Poisson's ratio nu.
    hardening: {"kind": "hollomon", "kappa": Pa, "inverse_m": ...} (without sigma_y), {"kind": "ludwik", "K": Pa,
    "inverse_n": ...}, {"kind": "exponential", "eta": ...}, {"kind": "table", "strain": [...], "stress": [Pa ...]}."""
    return _made("von-mises", name, hardening, {"sigma_y": sigma_y, "E": E, "nu": nu, "E_bar": E_bar, **more})


def _porous(model: str, name: str | None, given: dict[str, Any], more: dict[str, Any]) -> Material:
    return _made(model, name, None, {**given, **more})


def vmdc(
    *,
    rho_r0: float | None = None,
    sigma_y: float | None = None,
    E: float | None = None,
    nu: float | None = None,
    Gamma: float | None = None,
    Lambda: float | None = None,
    epsilon: float | None = None,
    eta: float | None = None,
    xi: float | None = None,
    zeta: float | None = None,
    omega: float | None = None,
    xi_1: float | None = None,
    xi_2: float | None = None,
    name: str | None = None,
    **more: Any,
) -> Material:
    """A porous granule, von Mises Double Cap (Edmans & Sinka): relative density rho_r0 and, there, hydrostatic yield
    stress sigma_y, Young's modulus E, shear strength Gamma and tensile strength Lambda [Pa] (or E_bar, Gamma_bar,
    Lambda_bar over sigma_y), nu, semi-axes' ratio epsilon of the compaction cap; exponents over relative density eta (of
    sigma_y), xi (E), zeta (Gamma), omega (Lambda), slopes xi_1 (nu), xi_2 (epsilon)."""
    given = {"rho_r0": rho_r0, "sigma_y": sigma_y, "E": E, "nu": nu, "Gamma": Gamma, "Lambda": Lambda, "epsilon": epsilon,
             "eta": eta, "xi": xi, "zeta": zeta, "omega": omega, "xi_1": xi_1, "xi_2": xi_2}  # fmt: skip
    return _porous("vmdc", name, given, more)


def dpc(
    *,
    rho_r0: float | None = None,
    sigma_y: float | None = None,
    E: float | None = None,
    nu: float | None = None,
    Gamma: float | None = None,
    Lambda: float | None = None,
    epsilon: float | None = None,
    eta: float | None = None,
    xi: float | None = None,
    zeta: float | None = None,
    omega: float | None = None,
    xi_1: float | None = None,
    xi_2: float | None = None,
    published_flow: bool | None = None,
    name: str | None = None,
    **more: Any,
) -> Material:
    """A porous granule, Drucker-Prager Cap: keywords as for `vmdc`; `published_flow` takes the paper's potential."""
    given = {"rho_r0": rho_r0, "sigma_y": sigma_y, "E": E, "nu": nu, "Gamma": Gamma, "Lambda": Lambda, "epsilon": epsilon,
             "eta": eta, "xi": xi, "zeta": zeta, "omega": omega, "xi_1": xi_1, "xi_2": xi_2,
             "published_flow": published_flow}  # fmt: skip
    return _porous("dpc", name, given, more)


def drucker_prager(
    *,
    E: float | None = None,
    nu: float | None = None,
    phi: float | None = None,
    beta: float | None = None,
    sigma_c: float | None = None,
    cohesion: float | None = None,
    psi: float | None = None,
    flow_stress_ratio: float | None = None,
    name: str | None = None,
    **more: Any,
) -> Material:
    """Rock: E [Pa], nu; exactly one of beta + sigma_c, phi + sigma_c, phi + cohesion: friction angle beta in the (p, q)
    plane or phi of triaxial compression [degrees], uniaxial compressive strength sigma_c or cohesion [Pa]; dilation angle
    psi [degrees], left out: associated flow; flow_stress_ratio K, strength in triaxial extension over that in compression,
    left out: 1."""
    given = {"E": E, "nu": nu, "phi": phi, "beta": beta, "sigma_c": sigma_c, "cohesion": cohesion, "psi": psi,
             "flow_stress_ratio": flow_stress_ratio}  # fmt: skip
    return _made("drucker-prager", name, None, {**given, **more})


def mohr_coulomb(
    *,
    E: float | None = None,
    nu: float | None = None,
    phi: float | None = None,
    cohesion: float | None = None,
    sigma_c: float | None = None,
    psi: float | None = None,
    tension_cutoff: float | None = None,
    name: str | None = None,
    **more: Any,
) -> Material:
    """Rock: E [Pa], nu, friction angle phi [degrees], one of cohesion and uniaxial compressive strength sigma_c [Pa],
    dilation angle psi [degrees] (left out: phi), largest principal stress tension_cutoff [Pa]."""
    given = {"E": E, "nu": nu, "phi": phi, "cohesion": cohesion, "sigma_c": sigma_c, "psi": psi,
             "tension_cutoff": tension_cutoff}  # fmt: skip
    return _made("mohr-coulomb", name, None, {**given, **more})
