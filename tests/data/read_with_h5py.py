"""Reads our HDF5 files with h5py and prints their samples, one "row column I Q" per line, then axes and attributes.

usage: read_with_h5py.py FILE
"""

import sys

import h5py


def main():
    with h5py.File(sys.argv[1], "r") as file:
        samples = file["samples"][...]
        for row in range(samples.shape[0]):
            for column in range(samples.shape[1]):
                value = samples[row, column]
                # Volts arrive as complex64, counts as a structure of r and i.
                parts = (value.real, value.imag) if samples.dtype.kind == "c" else (value["r"], value["i"])
                print(row, column, "%.17g %.17g" % tuple(float(part) for part in parts))
        for name in ("pulse_time_s", "carrier_hz", "slant_range_m", "platform_position_m", "platform_velocity_mps",
                     "platform_rotation_rad"):
            print(name, *("%.17g" % value for value in file[name][...].flat))
        for name in sorted(file.attrs):
            print(name, repr(file.attrs[name]) if isinstance(file.attrs[name], str) else file.attrs[name])
        print("unit", file["samples"].attrs["unit"])


main()
