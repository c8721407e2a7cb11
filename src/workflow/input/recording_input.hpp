#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/task/sample_rows.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::raster {
class Raster;
}

namespace sarsim::workflow {

/// A scene in memory, and perhaps a recording of it.
struct HeldScene {
  SceneInput input;
  /// All rows of the simulation that the arguments name, in V; nothing: they are computed.
  std::optional<core::SampleRows<double>> rows{};
};

/// Whose echoes a command works on: those of a script, or of a file of samples and of the script that wrote it.
struct RecordingArguments {
  std::string path;
  std::string script;                       ///< For a file that does not carry its script.
  std::optional<std::int64_t> simulation;   ///< Its number in the script, from 1.
  SceneOverrides overrides;                 ///< Of a script that is read.
  std::string dataset{};                    ///< Of an HDF5 file: path of its samples; empty: the usual one.
  std::shared_ptr<const HeldScene> held{};  ///< In place of the file `path`, which is then only a name; null: none.
};

/// The files that the arguments name: the input and its script. Which data files belong to them is known once they are
/// opened.
[[nodiscard]] std::vector<std::filesystem::path> named_sources(const RecordingArguments& arguments);

/// Reads the script inside a file of samples. Throws core::InvalidRequest if it includes files; the data files that it
/// names are read, but problems quote nothing of their contents, since whoever made the recording chose them.
/// @param path  of the file, beside which data files are looked for
[[nodiscard]] scene::ScriptReading read_carried_script(const std::string& script, const std::string& path);

/// Whether the arguments name a script rather than a file of samples.
[[nodiscard]] bool names_script(const RecordingArguments& arguments);

/// Whether a file is a script: by its ending, or where that says nothing, by how it begins.
[[nodiscard]] bool holds_script(const std::string& path);

/// Whether a command can use a simulation of a scene; the first such one is taken where none is named.
using Suits = std::function<bool(const scene::Scene& scene, const scene::Simulation& simulation)>;

/// A `Suits`: pulses, not synthetic range profiles.
[[nodiscard]] bool records_pulses(const scene::Scene& scene, const scene::Simulation& simulation);

/// A script, checked with its echoes.
struct ScriptedRecording {
  SceneInput input;
  std::size_t simulation = 0;  ///< Position in the script's list.
};

/// Refuses a focused image that has a header beside it, and that header; of other files that are images opening says
/// so.
/// @throws core::InvalidRequest
void expect_no_image(const std::string& path);

/// Reads the script of the arguments and finds the simulation. Throws core::InvalidRequest with all problems where the
/// script cannot be simulated or has no such simulation.
[[nodiscard]] ScriptedRecording open_script(const RecordingArguments& arguments, const Suits& suits,
                                            const core::WorkControl& control);

/// A file of samples and the plan of the simulation that wrote it.
struct StoredRecording {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  std::size_t simulation = 0;                  ///< Position in the script's list.
  scene::Scene scene;                          ///< Of the script.
  std::shared_ptr<const raster::Raster> file;  ///< As it was opened.
  core::SampleRows<double> rows;               ///< Like those of the plan, in V, or in counts where no LSB is known.
  core::Problems problems;                     ///< Warnings about script and file.
  core::Problems of_files;                     ///< Of these the ones about the files that the script names.
  std::vector<std::filesystem::path> sources;  ///< The file, its script and the data files of that.
};

/// Opens the file of the arguments; its script is the one that it carries or that they name, its simulation the one
/// that they name or that writes a file of that name. Throws core::InvalidRequest where script and file do not fit each
/// other.
/// @param problems_of  what prevents the plan, asked before the samples are opened; errors end it
[[nodiscard]] StoredRecording open_recording(
    const RecordingArguments& arguments, const Suits& suits,
    const std::function<core::Problems(const simulate::Acquisition&)>& problems_of,
    const core::WorkControl& control = {});

}  // namespace sarsim::workflow
