#pragma once

#include <array>
#include <utility>

#include "scene/model/recording.hpp"

namespace sarsim::scene {

/// What the samples of a recording are where nothing else is asked for.
enum class SampleValues {
  counts,  ///< Of the A/D converter, always.
  volts,   ///< Unless counts are asked for.
};

/// The values of every format of recordings.
inline constexpr std::array<std::pair<FileFormat, SampleValues>, 8> format_values{
    {{FileFormat::ascii, SampleValues::counts},
     {FileFormat::binary, SampleValues::counts},
     {FileFormat::bracket, SampleValues::counts},
     {FileFormat::hdf5, SampleValues::volts},
     {FileFormat::csv, SampleValues::counts},
     {FileFormat::npy, SampleValues::volts},
     {FileFormat::zarr, SampleValues::volts},
     {FileFormat::sigmf, SampleValues::volts}}};

/// The values of one format; counts for a number that is none of a format.
[[nodiscard]] constexpr SampleValues values_of(FileFormat format) {
  for (const auto& [known, values] : format_values)
    if (known == format) return values;
  return SampleValues::counts;
}

}  // namespace sarsim::scene
