"""Pictures by matplotlib, which is asked for only here."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._svg import dimensionless

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._comparison import Comparison
    from ._law import Law
    from ._press import Curve


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install matplotlib") from error
    return pyplot.subplots(layout="constrained")[1]


def plot_law(law: Law, ax: Axes | None, **style: Any) -> Axes:
    ax = _axes(ax)
    sigma_ref = law.parameters.get("sigma_ref_Pa")
    scale = np.pi * sigma_ref if sigma_ref else 1.0
    x, force, back = dimensionless(law)
    if law.curve is not None and "F_bar" in law.curve.columns and scale != 1.0:
        loading = law.curve.loading
        ax.plot(loading["delta_bar"], loading["F_bar"], color="0.75", linewidth=4, label="curve")
    for i, (u, f) in enumerate(back):
        ax.plot(u, f / scale, color="0.5", linewidth=1, label="unloading" if i == 0 else None)
    ax.plot(x, np.asarray(force) / scale, **{"label": law.name, **style})
    ax.set_xlabel(r"$\delta/R$")
    ax.set_ylabel(r"$F/(\pi R^2 \sigma_\mathrm{ref})$" if scale != 1.0 else r"$F/R^2$ [Pa]")
    ax.set_title(law._title(), fontsize="small")
    ax.legend(frameon=False)
    return ax


def plot_comparison(comparison: Comparison, ax: Axes | None) -> Axes:
    ax = _axes(ax)
    x = comparison.delta_m / comparison.radius
    ax.plot(x, comparison.reference["force_N"], color="0.75", linewidth=4, label=comparison.reference["name"])
    for trace in comparison.traces:
        ax.plot(x, trace["force_N"], label=trace["name"])
    ax.set_xlabel(r"$\delta/R$")
    ax.set_ylabel("F [N]")
    ax.legend(frameon=False)
    return ax


def plot_curve(curve: Curve, ax: Axes | None, **style: Any) -> Axes:
    ax = _axes(ax)
    column = "travel_m" if "travel_m" in curve.columns else "delta_m"
    ax.plot(1e3 * curve[column], curve["force_N"], **style)
    ax.set_xlabel("travel [mm]" if column == "travel_m" else r"$\delta$ [mm]")
    ax.set_ylabel("F [N]")
    return ax
