"""Reads our sample files with NumPy alone and prints their numbers, one "row column I Q" per line.

usage: read_with_numpy.py FORMAT FILE COLUMNS BITS
"""

import sys

import numpy


def read_binary(path, columns, bits):
    width = (bits + 7) // 8
    offset = max(1, 2 ** (bits - 1) - 1)
    raw = numpy.fromfile(path, dtype=numpy.uint8).reshape(-1, columns, 2, width)
    stored = numpy.zeros(raw.shape[:3], dtype=object)
    for byte in range(width):
        stored += raw[..., byte].astype(object) << (8 * byte)
    return stored - offset


def read_npy(path, columns, bits):
    array = numpy.load(path)
    if array.dtype.kind == "c":
        return numpy.stack([array.real, array.imag], axis=-1)
    return array


def read_ascii(path, columns, bits):
    return numpy.loadtxt(path, dtype=numpy.int64).reshape(-1, columns, 2)


def read_csv(path, columns, bits):
    offset = max(1, 2 ** (bits - 1) - 1)
    table = numpy.loadtxt(path, delimiter=",", dtype=numpy.int64, ndmin=2)
    return table.reshape(-1, columns, 2) - offset


def read_bracket(path, columns, bits):
    with open(path) as file:
        text = file.read()
    numbers = text.replace("(", " ").replace(")", " ").replace(",", " ").split()
    return numpy.array(numbers, dtype=numpy.int64).reshape(-1, columns, 2)


def main():
    readers = {"binary": read_binary, "npy": read_npy, "ascii": read_ascii, "csv": read_csv, "bracket": read_bracket}
    kind, path, columns, bits = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    samples = readers[kind](path, columns, bits)
    for row in range(samples.shape[0]):
        for column in range(samples.shape[1]):
            print(row, column, "%.17g %.17g" % (float(samples[row, column, 0]), float(samples[row, column, 1])))


main()
