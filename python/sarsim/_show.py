"""How things look in notebooks."""

from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING, Iterable, Sequence

if TYPE_CHECKING:
    from .samples import Samples
    from .scene import Scene, SceneObject


def table_html(names: "Sequence[str]", rows: "Iterable[Sequence[object]]") -> str:
    def line(cells: "Iterable[object]", tag: str) -> str:
        return "<tr>" + "".join(f'<{tag} style="text-align:left">{html.escape(str(cell))}</{tag}>' for cell in cells) + "</tr>"

    return f"<table>{line(names, 'th')}{''.join(line(row, 'td') for row in rows)}</table>"


def scene_html(scene: "Scene") -> str:
    rows = [(kind, count, repr(getattr(scene, kind)).strip("[]")) for kind, count in scene._counts().items() if count]
    return f"<b>{html.escape(scene._name)}</b>{table_html(('objects', 'number', 'names'), rows)}"


def fields_html(one: "SceneObject") -> str:
    return f"<b>{html.escape(repr(one)[1:-1])}</b>{table_html(('field', 'value'), one.fields().items())}"


def samples_html(samples: "Samples") -> str:
    rows = []
    for axis in samples.axes.values():
        if axis.values.ndim == 1 and len(axis.values):
            rows.append((axis.name, f"{axis.values[0]:.9g}", f"{axis.values[-1]:.9g}", axis.unit))
    shown = base64.b64encode(samples.picture(width=480, height=320).png).decode()
    return (
        f"<b>{html.escape(samples._told())}</b>{table_html(('axis', 'first', 'last', 'unit'), rows)}"
        f'<img src="data:image/png;base64,{shown}" alt="magnitudes, 40 dB">'
    )
