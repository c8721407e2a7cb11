"""A scene with many values: here, on all cores, on a cluster."""

from __future__ import annotations

import itertools
from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Tuple

import numpy as np

from .scene import Scene


class Sweep:
    """What a function made of each variation."""

    def __init__(self, values: "Dict[str, List[Any]]", results: "List[Any]") -> None:
        self.values = values
        """The values of each field, in the order of the axes."""
        self.results = results
        """What the function gave, the last field changing fastest."""

    @property
    def shape(self) -> "Tuple[int, ...]":
        """How many values each field has."""
        return tuple(map(len, self.values.values()))

    def __len__(self) -> int:
        return len(self.results)

    def __iter__(self) -> "Iterator[Tuple[Dict[str, Any], Any]]":
        """Each variation with its result."""
        return zip(_variations(self.values), self.results)

    def __array__(self, dtype: Any = None, copy: "bool | None" = None) -> np.ndarray:
        """The results as an array with an axis for each field, and those of the results behind them."""
        whole = np.asarray(self.results, dtype=dtype)
        return whole.reshape(self.shape + whole.shape[1:])

    def to_xarray(self) -> Any:
        """An xarray.DataArray with the fields as axes. Needs xarray, and results that are numbers or arrays of one shape."""
        import xarray

        whole = np.asarray(self)
        more = [f"axis_{number}" for number in range(whole.ndim - len(self.values))]
        return xarray.DataArray(whole, dict(self.values), (*self.values, *more))

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each variation. Needs pandas."""
        import pandas

        return pandas.DataFrame([{**variation, "result": result} for variation, result in self])

    def __repr__(self) -> str:
        return f"<Sweep: {' x '.join(f'{len(values)} {name}' for name, values in self.values.items())}>"


def _variations(values: "Mapping[str, List[Any]]") -> "Iterator[Dict[str, Any]]":
    return (dict(zip(values, one)) for one in itertools.product(*values.values()))


def _one(scene: Scene, fields: "Dict[str, Any]", function: "Callable[[Scene], Any]") -> Any:
    return function(scene.with_(fields))


def sweep(
    scene: Scene,
    values: "Mapping[str, Iterable[Any]]",
    function: "Callable[[Scene], Any]",
    *,
    executor: Any = None,
    progress: bool = False,
) -> Sweep:
    """Calls a function with every variation of a scene: sweep(scene, {"Radar1.bandwidth": [50e6, 100e6]}, contrast).

    :param values:   of each field, by the names that `sarsim sweep --fields` prints; all combinations are made
    :param function: takes a Scene; what it gives must be picklable where it runs in other processes
    :param executor: None: here, one after the other, each on all cores; or what has submit(function, ...): an executor of
                     concurrent.futures, a dask.distributed.Client, an mpi4py.futures.MPIPoolExecutor
    :param progress: a bar by tqdm, which has to be installed
    """
    lists = {name: list(some) for name, some in values.items()}
    each: "Iterable[Dict[str, Any]]" = list(_variations(lists))
    if executor is None:
        return Sweep(lists, [_one(scene, fields, function) for fields in _shown(each, progress)])
    futures = [executor.submit(_one, scene, fields, function) for fields in each]
    try:
        return Sweep(lists, [future.result() for future in _shown(futures, progress)])
    except BaseException:
        for future in futures:
            future.cancel()
        raise


def _shown(each: "Iterable[Any]", progress: bool) -> "Iterable[Any]":
    if not progress:
        return each
    from tqdm.auto import tqdm

    return tqdm(each)  # type: ignore[no-any-return]
