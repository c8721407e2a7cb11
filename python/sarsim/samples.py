"""Samples in rows and columns, with axes: what recordings and images have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Tuple

import numpy as np

if TYPE_CHECKING:
    from .pictures import Picture


class Axis(NamedTuple):
    """Where rows or columns are."""

    name: str
    """Ends in its unit: "slant_range_m"."""
    unit: str
    """ "s", "m", "Hz", "" """
    of_columns: bool
    """A value for each column; else for each row."""
    values: np.ndarray


# An array has one coordinate for each dimension; what else is known of rows stands beside it.
_FIRST = ("azimuth_m", "cross_range_m", "y_m", "pulse_time_s", "slant_range_m", "ground_range_m", "x_m")


class Samples:
    """A table of samples with its axes. NumPy takes it as an array; `to_xarray` gives one with named axes."""

    def __init__(self, axes: "List[Axis]", attributes: "Dict[str, str]") -> None:
        self.axes: "Dict[str, Axis]" = {axis.name: axis for axis in axes}
        """Axes by name."""
        self.attributes = attributes
        """What a file would say of them."""

    @property
    def samples(self) -> np.ndarray:
        """The numbers: rows, columns."""
        raise NotImplementedError

    @property
    def shape(self) -> "Tuple[int, int]":
        """Rows, columns."""
        rows, columns = self.samples.shape
        return rows, columns

    @property
    def dtype(self) -> np.dtype:
        """Type of the numbers."""
        return self.samples.dtype

    @property
    def dims(self) -> "Tuple[str, str]":
        """The names of the axes of rows and columns; "row" and "column" where they are not known."""
        return self._first(False) or "row", self._first(True) or "column"

    def _first(self, of_columns: bool) -> str:
        names = [axis.name for axis in self.axes.values() if axis.of_columns == of_columns and axis.values.ndim == 1]
        return next((name for name in _FIRST if name in names), names[0] if names else "")

    def __getattr__(self, name: str) -> np.ndarray:
        axes = self.__dict__.get("axes", {})
        if name in axes:
            return axes[name].values  # type: ignore[no-any-return]
        raise AttributeError(f"{type(self).__name__} has no {name!r}; its axes are {', '.join(axes) or 'not known'}")

    def __dir__(self) -> "List[str]":
        return [*super().__dir__(), *self.axes]

    def __array__(self, dtype: Any = None, copy: "bool | None" = None) -> np.ndarray:
        if copy:
            return np.array(self.samples, dtype=dtype)
        return np.asarray(self.samples, dtype=dtype)

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, which: Any) -> Any:
        """Part of the samples, as of an array."""
        return self.samples[which]

    def db(self, below: float = 100.0) -> np.ndarray:
        """The magnitudes in dB of the largest, not less than -below."""
        magnitudes = np.abs(self.samples)
        largest = float(magnitudes.max()) if magnitudes.size else 0.0
        if largest == 0.0:
            return np.full(magnitudes.shape, -below)
        levels: np.ndarray = 20 * np.log10(np.maximum(magnitudes / largest, 10 ** (-below / 20)))
        return levels

    def to_xarray(self) -> Any:
        """An xarray.DataArray with named axes and their units, without tracks. Needs xarray."""
        import xarray

        rows, columns = self.dims
        coords = {
            axis.name: (columns if axis.of_columns else rows, axis.values, {"units": axis.unit} if axis.unit else {})
            for axis in self.axes.values()
            if axis.values.ndim == 1
        }
        return xarray.DataArray(self.samples, coords, (rows, columns), name="samples", attrs=dict(self.attributes))

    def picture(self, *, span_db: float = 40.0, width: int = 720, height: int = 480) -> "Picture":
        """The magnitudes as a PNG picture: near range left, late rows at the top, span_db from black to white. Where a
        pixel holds several samples it shows the largest. It is about as large as said."""
        from .pictures import picture

        return picture(self, span_db, width, height)

    def plot(self, ax: Any = None, *, span_db: float = 40.0, **options: Any) -> Any:
        """Draws the magnitudes in dB with axes by matplotlib, and gives its Axes; a `Picture` where it is not installed.

        :param ax:      Axes to draw into; None: new ones
        :param options: go to matplotlib's imshow
        """
        from .pictures import plot

        return plot(self, ax, span_db, options)

    def _told(self) -> str:
        rows, columns = self.shape
        return f"{type(self).__name__}: {rows} x {columns} {self.dtype}"

    def __repr__(self) -> str:
        return f"<{self._told()}, {', '.join(self.axes) or 'no axes'}>"

    def _repr_html_(self) -> str:
        from ._show import samples_html

        return samples_html(self)
