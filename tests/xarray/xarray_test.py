#!/usr/bin/env python3
"""Opens what the program writes with xarray and its like, and compares the values with those of the program itself.

    xarray_test.py NAME      one of the functions below

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment, an interpreter with the packages
SARSIM_TEST_PYTHON. Exit status: 0 as it should be, 1 not, 77 packages are missing.
"""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
NEEDS = {
    "recordings_have_named_axes": ("numpy", "xarray", "h5netcdf"),
    "netcdf_reads_recordings": ("numpy", "netCDF4"),
    "images_have_named_axes": ("numpy", "xarray", "h5netcdf"),
    "references_are_zarr": ("numpy", "xarray", "zarr", "fsspec"),
    "zarr_stores": ("numpy", "xarray", "zarr", "h5netcdf"),
    "zarr_stores_by_newest_packages": ("numpy", "xarray", "zarr", "h5netcdf"),
}
SCENE = """$TARGET Earth 1000 0 0 0 0 0 1 0 ISOTROPIC
$RADAR Radar1 Earth CHIRP 0.03 500 RECT CONSTANT 1000 SINGLE 1 1 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC
$SIMULATION Radar1 900 1200 0 0.0199 8 0.05 1E-6 HDF5 RAW sim.h5 BEGIN 1 1
"""


def skip_without(modules):
    """Ends the test where a package is missing, after another interpreter has been tried."""
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if sys.argv[1].endswith("_newest_packages") and "SARSIM_NEWEST" not in os.environ:
        missing.append("newest packages")
    if not missing:
        return
    other = os.environ.pop("SARSIM_TEST_PYTHON", "")
    if other:
        os.environ["SARSIM_NEWEST"] = "yes"
        os.execv(other, [other, "-B", *sys.argv])
    print(f"{sys.executable} has no {', '.join(missing)}; SARSIM_TEST_PYTHON may name an interpreter that has")
    sys.exit(SKIPPED)


def sarsim(*words):
    program = os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stderr}"
    return done.stdout


def refused(*words):
    program = os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 2, f"{words}: status {done.returncode}"
    return done.stderr


def recorded(folder, *words, end="0.0199"):
    """A recording as HDF5, of a pulse every millisecond until its end."""
    (folder / "scene.scr").write_text(SCENE.replace("0.0199", end))
    sarsim("run", folder / "scene.scr", "--out", folder, "--quiet", "--force", *words)
    return folder / "sim.h5"


def volts_of(path):
    """The samples as the program copies them to NPY."""
    import numpy

    sarsim("convert", path, path.with_suffix(".npy"), "--force")
    return numpy.load(path.with_suffix(".npy"))


def check_axes(data):
    import numpy

    assert data.samples.dims == ("pulse_time_s", "slant_range_m"), data.samples.dims
    numpy.testing.assert_allclose(data.pulse_time_s, 0.001 * numpy.arange(20), atol=1e-12)
    numpy.testing.assert_allclose(numpy.diff(data.slant_range_m), 299792458 / 1e8)
    assert data.samples.coords["carrier_hz"].dims == ("pulse_time_s",)
    assert set(data.carrier_hz.values) == {1e9}
    units = {name: data[name].attrs["units"] for name in ("samples", "pulse_time_s", "slant_range_m", "carrier_hz")}
    assert units == {"samples": "V", "pulse_time_s": "s", "slant_range_m": "m", "carrier_hz": "Hz"}, units
    assert list(data.world_axis.values) == ["x", "y", "z"]
    assert data.platform_position_m.dims == ("pulse_time_s", "world_axis")


def recordings_have_named_axes(folder):
    import numpy
    import xarray

    path = recorded(folder)
    with xarray.open_dataset(path, engine="h5netcdf") as data:
        check_axes(data)
        assert data.samples.dtype == numpy.complex64
        numpy.testing.assert_array_equal(data.samples.values, volts_of(path))
        near = data.samples.sel(slant_range_m=1004, method="nearest")
        assert abs(float(near.slant_range_m) - 1004) < 1.5
        assert abs(near.values).min() > 0, "the echo of the target at 1000 m"
    with xarray.open_dataset(recorded(folder, "--counts"), engine="h5netcdf") as data:
        assert data.samples.attrs["units"] == "count"
        assert data.samples.dims == ("pulse_time_s", "slant_range_m")
    # Without axes the dimensions have names all the same.
    recorded(folder)
    volts_of(path)
    sarsim("convert", path.with_suffix(".npy"), folder / "bare.h5")
    with xarray.open_dataset(folder / "bare.h5", engine="h5netcdf") as data:
        assert data.samples.dims == ("pulse", "sample") and not data.coords, data
        numpy.testing.assert_array_equal(data.samples.values, volts_of(path))


def netcdf_reads_recordings(folder):
    import netCDF4
    import numpy

    path = recorded(folder)
    with netCDF4.Dataset(path) as data:
        assert sorted(data.dimensions) == ["pulse_time_s", "slant_range_m", "world_axis"], list(data.dimensions)
        samples = data["samples"]
        assert samples.dimensions == ("pulse_time_s", "slant_range_m")
        assert samples.units == "V"
        pairs = samples[...]
        numpy.testing.assert_array_equal(pairs["r"] + 1j * pairs["i"], volts_of(path))
        assert data["pulse_time_s"][3] == 0.003
    volts_of(path)
    sarsim("convert", path.with_suffix(".npy"), folder / "bare.h5")
    with netCDF4.Dataset(folder / "bare.h5") as data:
        assert sorted(data.variables) == ["samples"], data.variables
        assert data["samples"].dimensions == ("pulse", "sample")


EARTH_SCENE = """format = "sarsim 2"

[world]
frame = "earth"
anchor = { latitude = "52.3 deg", longitude = "13.4 deg" }

[[platform]]
name = "Aircraft"
[platform.path]
type = "points"
x = { interpolation = "linear", points = [[0, -60], [1, 40]] }
y = { interpolation = "linear", points = [[0, -3000]] }
z = { interpolation = "linear", points = [[0, 2000]] }

[[target]]
positions = [[0, 0, 0]]

[[radar]]
name = "SAR"
platform = "Aircraft"
pulse = { type = "chirp", bandwidth = "50 MHz", width = "1 us" }
repetition = "400 Hz"
carrier = "5 GHz"
power = "1 kW"
beam = { type = "fixed", azimuth = "0 deg", elevation = "-33.7 deg" }

[[recording]]
radar = "SAR"
file = "sim.h5"
format = "hdf5"
range = ["3.5 km", "3.8 km"]
time = ["0 s", "1.2 s"]
sample_rate = "60 MHz"
bits = 16
"""


def header_of(path):
    """The fields of an ENVI header."""
    lines = (line.split(" = ", 1) for line in path.read_text().splitlines() if " = " in line)
    return {name: value.strip("{} ") for name, value in lines}


def images_have_named_axes(folder):
    import numpy
    import xarray

    scene = folder / "scene.toml"
    scene.write_text(EARTH_SCENE)
    sarsim("run", scene, "--out", folder, "--quiet")
    # A slant-range image: places along the track name its rows, times go with them.
    sarsim("focus", folder / "sim.h5", "--out", folder / "slant.h5", "--quiet")
    sarsim("focus", folder / "sim.h5", "--out", folder / "slant.img", "--quiet")
    header = header_of(folder / "slant.hdr")
    with xarray.open_dataset(folder / "slant.h5", engine="h5netcdf") as image:
        assert image.samples.dims == ("azimuth_m", "slant_range_m"), image.samples.dims
        assert image.samples.coords["pulse_time_s"].dims == ("azimuth_m",)
        steps = float(header["azimuth step m"]) * numpy.arange(image.azimuth_m.size)
        numpy.testing.assert_allclose(image.azimuth_m, float(header["azimuth first m"]) + steps)
        numpy.testing.assert_allclose(image.pulse_time_s, image.azimuth_m / 100.0)
        peak = abs(image.samples).argmax(dim=["azimuth_m", "slant_range_m"])
        assert abs(float(image.slant_range_m[peak["slant_range_m"]]) - numpy.hypot(3000, 2000)) < 3
    # A ground grid over the Earth.
    grid = ("--algorithm", "back-projection", "--grid", "ground", "--quiet")
    sarsim("focus", folder / "sim.h5", "--out", folder / "ground.h5", *grid)
    sarsim("focus", folder / "sim.h5", "--out", folder / "ground.img", *grid)
    header = header_of(folder / "ground.hdr")
    with xarray.open_dataset(folder / "ground.h5", engine="h5netcdf") as image:
        assert image.samples.dims == ("azimuth_m", "ground_range_m"), image.samples.dims
        assert image.samples.attrs.get("grid_mapping", image.samples.encoding.get("grid_mapping")) == "utm"
        assert f"{image.utm.attrs['spatial_ref']}" == "EPSG:32633"
        transform = [float(word) for word in image.utm.attrs["GeoTransform"].split()]
        middle = [float(word) for word in header["utm middle m"].split(",")]
        half = (image.sizes["ground_range_m"] / 2, image.sizes["azimuth_m"] / 2)
        numpy.testing.assert_allclose(transform[0] + transform[1] * half[0] + transform[2] * half[1], middle[0], atol=1e-3)
        numpy.testing.assert_allclose(transform[3] + transform[4] * half[0] + transform[5] * half[1], middle[1], atol=1e-3)
        corners = [float(word) for word in header["geo points"].split(",")]
        assert abs(min(corners[2::4]) - image.attrs["geospatial_lat_min"]) < 1e-9
        assert abs(max(corners[3::4]) - image.attrs["geospatial_lon_max"]) < 1e-9
        places = image.ground_range_m.values
    # Copies keep the axes.
    sarsim("convert", folder / "ground.h5", folder / "copy.h5")
    with xarray.open_dataset(folder / "copy.h5", engine="h5netcdf") as image:
        assert image.samples.dims == ("azimuth_m", "ground_range_m"), image.samples.dims
        numpy.testing.assert_array_equal(image.ground_range_m, places)
    assert "ground ranges" in sarsim("info", folder / "copy.h5")


def opened_as_zarr(references, **options):
    import xarray

    options = {"fo": str(references), "remote_protocol": "file", **options}
    return xarray.open_dataset(
        "reference://", engine="zarr", backend_kwargs={"consolidated": False, "storage_options": options}
    )


def references_are_zarr(folder):
    import numpy

    # Each under a name of its own, as fsspec remembers what it has opened. Of 10007 pulses, which nothing divides, the
    # last piece stands in the references.
    for end in ("0.0199", "10.0064"):
        path, references = recorded(folder, end=end), folder / f"until{end}.json"
        sarsim("convert", path, "--references", references, "--force")
        with opened_as_zarr(references) as data:
            assert data.samples.dims == ("pulse_time_s", "slant_range_m")
            numpy.testing.assert_array_equal(data.samples.values, volts_of(path))
            numpy.testing.assert_allclose(data.pulse_time_s, 0.001 * numpy.arange(data.pulse_time_s.size), atol=1e-9)
            assert data.samples.coords["carrier_hz"].dims == ("pulse_time_s",)
            assert list(data.world_axis.values) == ["x", "y", "z"]
            assert data.attrs["bits"] == 8
            near = data.samples.isel(pulse_time_s=7).sel(slant_range_m=1004, method="nearest")
            assert abs(complex(near)) > 0
    # The file elsewhere.
    path.rename(folder / "moved.h5")
    with opened_as_zarr(references, template_overrides={"file": str(folder / "moved.h5")}) as data:
        numpy.testing.assert_array_equal(data.samples.values, volts_of(folder / "moved.h5"))
    # Counts are pairs.
    references = folder / "counts.json"
    sarsim("convert", recorded(folder, "--counts"), "--references", references, "--force")
    with opened_as_zarr(references) as data:
        assert data.samples.dims == ("pulse_time_s", "slant_range_m", "iq") and list(data.iq.values) == ["I", "Q"]
        sarsim("convert", folder / "sim.h5", folder / "counts.npy", "--counts")
        numpy.testing.assert_array_equal(data.samples.values, numpy.load(folder / "counts.npy"))


def check_same(store, file):
    """A store and an HDF5 file of one product hold the same."""
    import numpy
    import xarray
    import zarr

    with xarray.open_zarr(store) as data, xarray.open_dataset(file, engine="h5netcdf") as expected:
        assert data.samples.dims[:2] == expected.samples.dims, data.samples.dims
        assert data.samples.dtype in (expected.samples.dtype, numpy.int32), data.samples.dtype
        assert set(data.coords) - {"iq"} == set(expected.coords), (list(data.coords), list(expected.coords))
        assert set(data.variables) - {"iq"} == set(expected.variables)
        for name, variable in expected.variables.items():
            values = data[name].values
            if "iq" in data[name].dims:
                values = values.copy().view([("r", "<i4"), ("i", "<i4")])[..., 0]
            numpy.testing.assert_array_equal(values, variable.values, err_msg=name)
            said = {key: value for key, value in variable.attrs.items() if key not in ("_FillValue", "coordinates")}
            assert said == data[name].attrs, (name, said, data[name].attrs)
        assert set(data.attrs) == set(expected.attrs)
        for name, value in expected.attrs.items():
            # The script of a recording says in which format it is.
            assert data.attrs[name] == value or name == "script", (name, value, data.attrs[name])
    group = zarr.open(str(store), mode="r")
    plain = group["samples"][...]
    with xarray.open_zarr(store) as data:
        numpy.testing.assert_array_equal(plain, data.samples.values)


def zarr_stores(folder):
    import numpy
    import xarray
    import zarr

    scene = folder / "scene.toml"
    # The second has so many pulses that there are several chunks, of which the last one is not full.
    for end, words in (("0.0199", ()), ("30.0064", ()), ("0.0199", ("--double",)), ("0.0199", ("--counts",))):
        file = recorded(folder, *words, end=end)
        sarsim("run", folder / "scene.scr", "--out", folder, "--quiet", "--force", "--format", "zarr", *words)
        check_same(folder / "sim.zarr", file)
        if end != "0.0199":
            assert (folder / "sim.zarr" / "samples" / "2.0").exists(), "one chunk"
    # An image, its map included, and back to HDF5.
    scene.write_text(EARTH_SCENE.replace("sim.h5", "sim.zarr").replace('"hdf5"', '"zarr"'))
    sarsim("run", scene, "--out", folder, "--quiet", "--force")
    grid = ("--algorithm", "back-projection", "--grid", "ground", "--quiet")
    for name in ("ground.zarr", "ground.h5"):
        sarsim("focus", folder / "sim.zarr", "--out", folder / name, *grid)
    check_same(folder / "ground.zarr", folder / "ground.h5")
    sarsim("convert", folder / "sim.zarr", folder / "back.h5")
    sarsim("convert", folder / "back.h5", folder / "again.zarr")
    check_same(folder / "again.zarr", folder / "back.h5")
    for name in (".zattrs", "samples/0.0", "platform_position_m/0.0"):
        assert (folder / "again.zarr" / name).read_bytes() == (folder / "sim.zarr" / name).read_bytes(), name
    # Arrays of others.
    numbers = (numpy.arange(70) + 1j * numpy.arange(70)[::-1]).astype("<c8").reshape(7, 10)
    extra = {"zarr_format": 2} if zarr.__version__[0] != "2" else {}
    for chunks in ((3, 4), (7, 10), (20, 20)):
        array = zarr.open(str(folder / "other.zarr"), mode="w", shape=(7, 10), chunks=chunks, dtype="<c8", compressor=None, **extra)
        array[...] = numbers
        sarsim("convert", folder / "other.zarr", folder / "other.npy", "--force")
        numpy.testing.assert_array_equal(numpy.load(folder / "other.npy"), numbers)
    data = xarray.Dataset({"image": (("y", "x"), numbers), "mask": (("y", "x"), numbers.real > 3)})
    data.to_zarr(folder / "set.zarr", encoding={"image": {"compressors" if extra else "compressor": None}}, **extra)
    sarsim("convert", folder / "set.zarr", folder / "set.npy")
    numpy.testing.assert_array_equal(numpy.load(folder / "set.npy"), numbers)
    data.to_zarr(folder / "packed.zarr", **extra)
    assert "compressed" in refused("info", folder / "packed.zarr" / "image")
    if extra:
        zarr.create_array(str(folder / "three.zarr"), shape=(7, 10), dtype="<c8")[...] = numbers
        assert "version 3" in refused("info", folder / "three.zarr")


def zarr_stores_by_newest_packages(folder):
    zarr_stores(folder)


def main():
    name = sys.argv[1]
    skip_without(NEEDS[name])
    with tempfile.TemporaryDirectory() as folder:
        globals()[name](pathlib.Path(folder))


main()
