"""Tables: numbers and texts in named columns."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterator, List

import numpy as np

from ._library import Handle, _decoded, call, lib

if TYPE_CHECKING:
    import os


class Table:
    """Rows and named columns, as the command writes them to CSV. A column is an array: numbers with NaN for what is empty,
    or texts. The name of a column ends in its unit."""

    def __init__(self, columns: "Dict[str, np.ndarray]", csv: str) -> None:
        self.columns = columns
        """Arrays by name."""
        self.csv = csv
        """All of it as comma-separated values."""

    @property
    def names(self) -> "List[str]":
        """Names of the columns."""
        return list(self.columns)

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.columns:
            raise KeyError(f"no column {name!r}; there is {', '.join(self.columns)}")
        return self.columns[name]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values()))) if self.columns else 0

    def __iter__(self) -> "Iterator[Dict[str, Any]]":
        """The rows, as dictionaries."""
        return ({name: values[row] for name, values in self.columns.items()} for row in range(len(self)))

    def __array__(self, dtype: Any = None, copy: "bool | None" = None) -> np.ndarray:
        """A structured array."""
        kinds = [(name, values.dtype) for name, values in self.columns.items()]
        whole = np.empty(len(self), dtype=kinds)
        for name, values in self.columns.items():
            whole[name] = values
        return whole if dtype is None else whole.astype(dtype)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame. Needs pandas."""
        import pandas

        return pandas.DataFrame(self.columns)

    def write(self, path: "str | os.PathLike[str]") -> None:
        """Writes it as comma-separated values."""
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self.csv)

    def __repr__(self) -> str:
        return f"<Table: {len(self)} rows of {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        from ._show import table_html

        def cell(value: Any) -> str:
            return f"{value:.6g}" if isinstance(value, float) else str(value)

        few = [[cell(value) for value in row.values()] for _, row in zip(range(30), self)]
        more = f"<p>... and {len(self) - 30} more rows</p>" if len(self) > 30 else ""
        return table_html(self.names, few) + more


def take_table(handle: Handle) -> Table:
    """A table of the library, as arrays."""
    rows = lib.sarsim_table_rows(handle)
    columns: "Dict[str, np.ndarray]" = {}
    for index in range(lib.sarsim_table_columns(handle)):
        name = _decoded(lib.sarsim_table_name(handle, index))
        if lib.sarsim_table_is_number(handle, index):
            values = np.empty(rows)
            call(lib.sarsim_table_numbers, handle, index, values.ctypes.data)
        else:
            values = np.array([_decoded(lib.sarsim_table_text(handle, row, index)) for row in range(rows)], dtype=str)
        columns[name] = values
    return Table(columns, _decoded(lib.sarsim_table_csv(handle)))
