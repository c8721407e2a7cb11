#pragma once

#include "core/os/input_file.hpp"
#include "core/task/stop.hpp"
#include "raster/format/raster_hints.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/raster.hpp"
#include "raster/table/stored_array.hpp"

namespace sarsim::raster {

/// The openers that the table of formats names (`Format::open`). Their files are not empty; the format is the row that
/// names them.

/// A text of samples (docs/formats/samples.md): ASCII, CSV, BRACKET.
///
/// A whole one is read through once to check every number and every row, and it is remembered where rows begin (at most
/// a sixteenth of the file's size). Malformed text stops at the first place, rows of different lengths are listed, ten
/// at most. Of a partial one only the first row is read before this returns.
[[nodiscard]] OpenedRaster open_text(core::InputFile file, const Format& format, const RasterHints& hints,
                                     Integrity integrity, const core::StopFlag* stop);

/// A BINARY file (docs/formats/samples.md). Without a shape of its own it needs columns and bits as hints.
[[nodiscard]] OpenedRaster open_binary(core::InputFile file, const Format& format, const RasterHints& hints,
                                       Integrity integrity, const core::StopFlag* stop);

/// A NumPy array. A whole one is complex64 or complex128 of one or two dimensions, or float32, float64, int16, int32,
/// int64 with a last dimension of 2, little-endian and in C order. A partial one is of numbers of any size and byte
/// order, C or Fortran order; a last dimension of 2 makes pairs of I and Q, one of 3 bytes colours. Pairs of integers
/// are counts.
[[nodiscard]] OpenedRaster open_npy(core::InputFile file, const Format& format, const RasterHints& hints,
                                    Integrity integrity, const core::StopFlag* stop);

/// An HDF5 file of samples, see `open_hdf5`; the library opens it anew, by its name.
[[nodiscard]] OpenedRaster open_hdf5_file(core::InputFile file, const Format& format, const RasterHints& hints,
                                          Integrity integrity, const core::StopFlag* stop);

/// A SigMF recording (docs/formats/samples.md), by either of its files: ours, and others of complex numbers whose
/// captures are equally long or whose rows the hints say.
[[nodiscard]] OpenedRaster open_sigmf(core::InputFile file, const Format& format, const RasterHints& hints,
                                      Integrity integrity, const core::StopFlag* stop);

/// A Zarr store of samples (docs/formats/samples.md) or one array of it: ours, and others of version 2 that are not
/// compressed. Of several arrays `samples` counts, otherwise the only one that may hold samples. Every size is compared
/// with the files that are there. Chunks that are nowhere are refused in our own stores; in others they are what the
/// array says, with a warning.
[[nodiscard]] OpenedRaster open_zarr(const std::filesystem::path& folder, const Format& format,
                                     const RasterHints& hints, Integrity integrity, const core::StopFlag* stop);

/// A file where a store was expected, which is a problem.
[[nodiscard]] OpenedRaster open_zarr_file(core::InputFile file, const Format& format, const RasterHints& hints,
                                          Integrity integrity, const core::StopFlag* stop);

/// Where the arrays of an HDF5 file that could be opened stand, see `hdf5_arrays`.
[[nodiscard]] StoredArrays arrays_of_hdf5(const core::InputFile& file, const RasterHints& hints);

/// Where the array of a NumPy file of samples stands.
[[nodiscard]] StoredArrays arrays_of_npy(const core::InputFile& file, const RasterHints& hints);

/// Where the numbers of a BINARY file that could be opened stand: with the offset of its counts, which a fact says.
[[nodiscard]] StoredArrays arrays_of_binary(const core::InputFile& file, const RasterHints& hints);

/// Where the samples of a SigMF recording stand in its file of samples, which must be the one that is named.
[[nodiscard]] StoredArrays arrays_of_sigmf(const core::InputFile& file, const RasterHints& hints);

/// Where the pixels of an image with an ENVI header stand, with the axes of the header.
[[nodiscard]] StoredArrays arrays_of_envi(const core::InputFile& file, const RasterHints& hints);

/// An image with its ENVI header beside it (docs/formats/focused-images.md), always whole: samples in volts, lines for
/// rows; real pixels have no imaginary part. Its fields become attributes; that of the script is named "script file",
/// as "script" is the text of one.
[[nodiscard]] OpenedRaster open_envi(core::InputFile file, const Format& format, const RasterHints& hints,
                                     Integrity integrity, const core::StopFlag* stop);

/// A SICD file: rows of ranges, columns along the track, in volts or what the file's maker took for them; integers and
/// amplitudes with phases become I and Q. Whole or not at all: it is refused where a segment is missing.
[[nodiscard]] OpenedRaster open_sicd(core::InputFile file, const Format& format, const RasterHints& hints,
                                     Integrity integrity, const core::StopFlag* stop);

/// A Sun raster. Rows that are missing are never an error.
[[nodiscard]] OpenedRaster open_sun(core::InputFile file, const Format& format, const RasterHints& hints,
                                    Integrity integrity, const core::StopFlag* stop);

/// A CPHD file (docs/formats/cphd.md), always whole: the samples of its reference channel, a row for each vector. What
/// its XML says is in the attributes.
[[nodiscard]] OpenedRaster open_cphd(core::InputFile file, const Format& format, const RasterHints& hints,
                                     Integrity integrity, const core::StopFlag* stop);

/// A file of numbers that lie as the layout of the hints says; errors where it says nothing sensible of this file, and
/// where a whole one has fewer rows.
[[nodiscard]] OpenedRaster open_custom(core::InputFile file, const Format& format, const RasterHints& hints,
                                       Integrity integrity, const core::StopFlag* stop);

}  // namespace sarsim::raster
