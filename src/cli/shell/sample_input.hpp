#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/shell/context.hpp"
#include "raster/format/open_raster.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::cli {

/// What the command line says about a file of samples that does not describe itself.
struct SampleArguments {
  std::optional<scene::FileFormat> format;
  std::optional<std::int64_t> columns;
  std::optional<std::int64_t> bits;
  std::optional<double> lsb_v;
  std::string script;
};

/// Adds --from, --columns, --bits, --lsb and --script.
void add_sample_arguments(CLI::App& app, SampleArguments& arguments);

/// The hints for a file: what was said on the command line, otherwise what the simulation of --script with that output
/// name says. Throws core::Refused where the script has errors or no such simulation.
[[nodiscard]] raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments);
/// The same of a command that has --simulation, which its hints name.
/// @param simulation  its number from 1, where the name shall not decide
[[nodiscard]] raster::RasterHints hints_for(const std::string& path, const SampleArguments& arguments,
                                            std::optional<std::int64_t> simulation);

/// The plan of the simulation of a script that writes a file of this name: its times, carriers and ranges. Throws
/// core::Refused like `hints_for`.
[[nodiscard]] simulate::Plan plan_of_file(const std::string& path, const std::string& script,
                                          std::optional<std::int64_t> simulation = {});

/// Opens a whole file of samples; prints warnings, throws core::Refused for errors.
[[nodiscard]] std::shared_ptr<const raster::Raster> open_samples(const std::string& path,
                                                                 const raster::RasterHints& hints, Streams& streams);

/// Rows that are read and converted together: as many as make a few MB.
[[nodiscard]] std::size_t rows_at_once(std::size_t columns);

}  // namespace sarsim::cli
