#pragma once

#include <filesystem>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::workflow {

/// The points that a data file has for the functions of a block: `scene::read_data_file`, and of HDF5 the dataset
/// `/points` as a table (`scene::functions_of_table`). Never `deferred`.
/// @param file  that was read: no `failure`
[[nodiscard]] scene::DataFileReading read_function_data(const scene::DataFileText& file,
                                                        const scene::FunctionBlock& block,
                                                        const core::WorkControl& control = {});

/// Reads the data files of functions that are HDF5 (`read_function_data`). All other data files are read with the text
/// that names them. What is wrong with one is an error of its object.
/// @param folder  of the script: where files are looked for first
[[nodiscard]] core::Problems read_function_tables(scene::Scene& scene, const std::filesystem::path& folder,
                                                  const core::WorkControl& control = {});

}  // namespace sarsim::workflow
