"""Sarsim, a radar echo simulator, in Python: scenes, recordings, images.

    import sarsim
    scene = sarsim.read("sar_r.toml")
    scene.radars["Radar1"].power = "2 kW"
    recording = scene.record()
    image = sarsim.focus(recording)
    image.plot()

Names, units and meanings of fields are those of the scene language. Numbers are in base units: SI, angles in degrees, ratios
in dB. Fields take texts with units, too: "50 MHz". What is wrong is a `ProblemError` with all `Problems`.
"""

from ._fields import Points
from ._library import lib as _lib
from .pictures import Picture
from .problems import FailedError, Problem, ProblemError, Problems, TryAgainError, UnknownNameError
from .recording import FileReport, Plan, Recording
from .samples import Axis, Samples
from .scene import Scene, explain, read
from .sweeps import Sweep, sweep
from .table import Table
from .products import (
    Image,
    Raster,
    doppler,
    export,
    focus,
    geometry,
    isar,
    measure,
    open,
    options,
    profiles,
    search,
    sweep_table,
    theory,
)

__version__: str = _lib.sarsim_version().decode()

__all__ = [
    "Axis",
    "FailedError",
    "FileReport",
    "Image",
    "Picture",
    "Plan",
    "Points",
    "Problem",
    "ProblemError",
    "Problems",
    "Raster",
    "Recording",
    "Samples",
    "Scene",
    "Sweep",
    "Table",
    "TryAgainError",
    "UnknownNameError",
    "doppler",
    "explain",
    "export",
    "focus",
    "geometry",
    "isar",
    "measure",
    "open",
    "options",
    "profiles",
    "read",
    "search",
    "sweep",
    "sweep_table",
    "theory",
]
