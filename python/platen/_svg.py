"""Small pictures and tables for notebooks, without any other library."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._law import Law
    from ._press import Curve

_BLUE, _GREY = "#1f6fb2", "#777"


def dimensionless(law: Law) -> tuple[Any, Any, list[tuple[Any, Any]]]:
    """delta/R and F/(R^2 Pa) of a sphere of one metre on a rigid plane, and its unloadings from three places."""
    contact = law.on_plane(1.0)
    end = law.valid.delta_bar[1] if law.valid.delta_bar else 0.1
    x = np.linspace(0, end, 201)
    back = []
    for top in (end / 3, 2 * end / 3, end):
        way = np.concatenate([[0, top], np.linspace(top, 0, 101)])
        answer = contact(way)
        touching = np.asarray(answer.force)[1:] > 0
        back.append((way[1:][touching], np.asarray(answer.force)[1:][touching]))
    return x, contact(x).force, back


def picture(lines: Iterable[tuple[Any, Any, str]], x_label: str, y_label: str) -> str:
    """Lines over axes from 0, as SVG."""
    lines = list(lines)
    width, height, left, bottom = 340, 210, 46, 34
    x_end = max(float(np.max(x)) for x, _, _ in lines if len(x)) or 1.0
    y_end = max(float(np.max(y)) for _, y, _ in lines if len(y)) or 1.0

    def place(x: Any, y: Any) -> str:
        across = left + np.asarray(x) / x_end * (width - left - 12)
        down = height - bottom - np.asarray(y) / y_end * (height - bottom - 14)
        return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, down))

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
             'font-size="11" fill="currentColor">']  # fmt: skip
    axis = f"M{left},10 V{height - bottom} H{width - 10}"
    parts.append(f'<path d="{axis}" fill="none" stroke="currentColor" stroke-width="1"/>')
    for x, y, colour in lines:
        parts.append(f'<polyline points="{place(x, y)}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
    parts.append(f'<text x="{width - 10}" y="{height - bottom + 14}" text-anchor="end">{x_end:.3g}</text>')
    parts.append(f'<text x="{left - 4}" y="18" text-anchor="end">{y_end:.3g}</text>')
    parts.append(f'<text x="{left - 4}" y="{height - bottom + 4}" text-anchor="end">0</text>')
    parts.append(f'<text x="{(width + left) / 2}" y="{height - 6}" text-anchor="middle">{escape(x_label)}</text>')
    parts.append(f'<text x="{left + 8}" y="20">{escape(y_label)}</text></svg>')
    return "".join(parts)


def table_html(title: str, rows: Iterable[tuple[str, ...]]) -> str:
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<div><strong>{escape(title)}</strong><table>{body}</table></div>"


def law_html(law: Law) -> str:
    x, force, back = dimensionless(law)
    sigma_ref = law.parameters.get("sigma_ref_Pa")
    scale = np.pi * sigma_ref if sigma_ref else 1.0
    label = "F/(πR²σ_ref)" if scale != 1.0 else "F/R² [Pa]"
    lines = [(u, f / scale, _GREY) for u, f in back] + [(x, np.asarray(force) / scale, _BLUE)]
    svg = picture(lines, "δ/R", label)
    from ._law import _short

    rows = [(key, _short(value)) for key, value in law.parameters.items()]
    return f"<div>{svg}{table_html('law ' + law._title(), rows)}</div>"


def curve_html(curve: Curve) -> str:
    column = "travel_m" if "travel_m" in curve.columns else "delta_m"
    return f"<div>{picture([(1e3 * curve[column], curve['force_N'], _BLUE)], column[:-2] + ' [mm]', 'F [N]')}</div>"
