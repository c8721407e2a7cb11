#pragma once

#include <filesystem>
#include <vector>

#include "core/report/problem.hpp"

namespace sarsim::workflow {

/// What keeps the files beside a recording from being made, which may be finished later or elsewhere: a receipt
/// (NAME.journal) that would replace a file that is no receipt, a folder of parts (NAME.parts) that is a link or holds
/// what is not of parts. No option replaces these.
/// @param output  the recording
[[nodiscard]] core::Problems problems_of_side_files(const std::filesystem::path& output);

/// The receipt and the folder of parts of a recording.
[[nodiscard]] std::vector<std::filesystem::path> side_files_of(const std::filesystem::path& output);

/// What keeps outputs of one run from being made: two of them that are one file, by their names or by links. Devices
/// and pipes take any number.
[[nodiscard]] core::Problems problems_of_same_files(const std::vector<std::filesystem::path>& paths);

}  // namespace sarsim::workflow
