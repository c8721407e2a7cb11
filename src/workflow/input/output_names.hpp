#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/recording.hpp"
#include "workflow/input/input_list.hpp"

namespace sarsim::scene {
struct Scene;
}

namespace sarsim::workflow {

/// Where products go.
struct OutputRules {
  std::filesystem::path folder = ".";
  bool keep_paths = false;  ///< Keep the folders that names hold, below `folder`; otherwise only the base name counts.
  std::optional<scene::FileFormat> format;  ///< Of all recordings, instead of the script's: also changes the extension.
};

/// The files that a scene's products become: one path for each simulation, then one for each geometry table.
struct OutputNames {
  std::vector<std::filesystem::path> simulations;
  std::vector<std::filesystem::path> tables;
  core::Problems problems;  ///< Without places; the subjects say where.
};

/// Decides the files of all products of a scene. The base name after either kind of slash goes into the folder; of
/// several products with one name, or with a file in common (`raster::files_of`: both files of a SigMF recording), the
/// second becomes name-2.ext and so on, with a warning here where `check` has none:
/// when a change of format or another product's number makes names alike. A name without a base name is an error; with
/// `keep_paths` also one that leads out of the folder.
[[nodiscard]] OutputNames output_names(const scene::Scene& scene, const OutputRules& rules);

/// The simulation of a scene that writes a file of this name (`output_names`), ignoring its folder and case; otherwise
/// the one that writes it with another extension; otherwise the one that `--format` gives this name. Nothing where none
/// does.
/// @param hint  what to do where several could have written it, which is core::InvalidRequest
[[nodiscard]] std::optional<std::size_t> simulation_that_writes(const std::filesystem::path& file,
                                                                const scene::Scene& scene, const std::string& hint);

/// What the outputs of a command may not replace, and how its user gives them other names.
struct OutputCare {
  InputList sources;   ///< What they are made from: input, script, data files of the script.
  bool force = false;  ///< Other files that exist are replaced.
  /// What names the outputs on the command line, as "--out", "-o or --csv" or "OUT"; empty where the script names them
  /// and --out their folder.
  std::string option = {};
  /// Where the script names the outputs: the folder that they are not to leave by a symbolic link. Any where empty.
  std::filesystem::path folder = {};
};

/// OutputCare::folder for the --out of a command: none where it is the folder one works in, whose links are one's own.
[[nodiscard]] std::filesystem::path chosen_folder(const std::filesystem::path& out);

/// Meaning of the option --out of a run.
struct RunOutput {
  std::filesystem::path folder;               ///< Of the products.
  std::optional<std::filesystem::path> file;  ///< The file of the only recording, in that folder.
};

/// A name with the extension of a recording format is that of a file, unless a folder of that name exists that is not a
/// Zarr store of this program; every other name is that of a folder, whether it exists or not.
[[nodiscard]] RunOutput run_output(const std::filesystem::path& out);

/// Throws core::InvalidRequest where --out names no folder: a file, or what has the name of a recording and is not
/// there.
void expect_output_folder(const std::filesystem::path& out);

/// Throws core::InvalidRequest with everything that keeps files from being made: `problems_of_output` of each, and
/// names that two of them have.
void expect_free_outputs(const std::vector<std::filesystem::path>& paths, const OutputCare& care);
/// The same of outputs that are made from one file and named by --out.
void expect_free_outputs(const std::vector<std::filesystem::path>& paths, const std::filesystem::path& source,
                         bool force);

/// Problems that keep a file from being made there: a file that exists (unless `force`), a folder of that name, what it
/// is made from (`InputList::harm_of`), the inside of a Zarr store.
[[nodiscard]] core::Problems problems_of_output(const std::filesystem::path& path, const OutputCare& care);
/// The same of an output that is made from one file and named by --out.
[[nodiscard]] core::Problems problems_of_output(const std::filesystem::path& path, const std::filesystem::path& source,
                                                bool force);

/// Base name after the last slash of either kind and after a drive letter.
[[nodiscard]] std::string base_name(const std::string& name);

}  // namespace sarsim::workflow
