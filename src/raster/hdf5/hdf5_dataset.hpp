#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/hdf5/hdf5_library.hpp"

namespace sarsim::raster {

/// Where the samples are, and where the program of 2015 had them.
inline constexpr const char* samples_path = "/samples";
inline constexpr const char* old_samples_path = "/Data/PulseNo_x_SampleNo_I&Q";

/// Whether a file has its samples at `old_samples_path` and not at `samples_path`.
[[nodiscard]] bool is_of_2015(hid_t file);

/// Path of the samples: `dataset`, from the root with or without a slash; if it is empty, the usual path.
[[nodiscard]] std::string path_of_samples(hid_t file, const std::string& dataset);

/// A dataset whose shape and storage have been found sound: its bytes are in the file itself, no larger than the file
/// can hold, and every filter that they need is at hand.
struct Hdf5Dataset {
  Hdf5Handle id;
  Hdf5Handle type;
  std::vector<std::uint64_t> shape;  ///< One or two sizes.
};

/// Opens a file for reading; the problem, without a place, where the library cannot. All that is opened in the file is
/// closed with it.
[[nodiscard]] std::variant<Hdf5Handle, core::Problem> open_hdf5_file(const std::filesystem::path& path);

/// Opens a dataset by its path from the root, following hard links only, so that no other file is ever opened.
/// @param file_bytes  size of the file, against which the dataset's size is held
[[nodiscard]] std::variant<Hdf5Dataset, core::Problem> open_dataset(hid_t file, const std::string& path,
                                                                    std::uint64_t file_bytes);

/// The first twelve datasets of a file, each with shape and type, for messages: "/raw (620 x 512, compound)". Empty if
/// there are none.
[[nodiscard]] std::string list_of_datasets(hid_t file);

/// Whether the path leads to something over hard links only.
[[nodiscard]] bool has_object(hid_t file, const std::string& path);
/// Whether the root of the file has an entry of that name, which may be a link that leads anywhere.
[[nodiscard]] bool has_link(hid_t file, const std::string& path);

}  // namespace sarsim::raster
