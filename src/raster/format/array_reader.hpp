#pragma once

#include "core/os/input_file.hpp"
#include "raster/format/sample_reader.hpp"

namespace sarsim::raster {

/// Opens a BINARY file (docs/formats/samples.md). Without a shape of its own it needs columns and bits as hints.
[[nodiscard]] OpenedReader open_binary(core::InputFile file, const SampleFileHints& hints);

/// Opens a NumPy array: complex64 or complex128 of one or two dimensions, or float32, float64, int16, int32, int64
/// with a last dimension of 2, little-endian and in C order. Integers are counts, the others volts.
[[nodiscard]] OpenedReader open_npy(core::InputFile file, const SampleFileHints& hints);

}  // namespace sarsim::raster
