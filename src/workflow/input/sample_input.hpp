#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/task/observer.hpp"
#include "raster/format/open_raster.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::workflow {

/// What is said about a file of samples that does not describe itself.
struct SampleArguments {
  std::optional<scene::FileFormat> format;
  std::optional<std::int64_t> columns;
  std::optional<std::int64_t> bits;
  std::optional<double> lsb_v;
  std::string script;
  std::string dataset = {};  ///< Of HDF5: path of the samples; empty: the usual one.
};

/// The hints for a file: what is said of it, otherwise what the simulation of its script with that output
/// name says. Throws core::InvalidRequest where the script has errors or no such simulation. The observer hears
/// warnings about the files that the script names.
[[nodiscard]] raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments,
                                            const core::Observer& observer);
/// The same of a command that has --simulation, which its hints name.
/// @param simulation  its number from 1, where the name shall not decide
[[nodiscard]] raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments,
                                            std::optional<std::int64_t> simulation, const core::Observer& observer);

/// The simulation of a script that writes a file of this name: its times, carriers and ranges. Throws
/// core::InvalidRequest like `hints_for`, and Interrupted where a stop is requested.
[[nodiscard]] simulate::Acquisition acquisition_of_file(const std::string& path, const std::string& script,
                                                        std::optional<std::int64_t> simulation = {},
                                                        const core::StopFlag* stop = nullptr);

/// A file of samples that has no errors.
struct SampleFile {
  std::shared_ptr<const raster::Raster> file;
  std::optional<raster::RasterAxes> axes;  ///< Where opening it has read them.
};

/// Opens a file of samples; the observer hears its warnings. Throws core::InvalidRequest for errors.
[[nodiscard]] SampleFile open_samples(const std::string& path, const raster::RasterHints& hints,
                                      const core::Observer& observer,
                                      raster::Integrity integrity = raster::Integrity::whole);

/// Rows that are read and converted together: as many as make a few MB.
[[nodiscard]] std::size_t rows_at_once(std::size_t columns);

}  // namespace sarsim::workflow
