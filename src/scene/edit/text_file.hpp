#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sarsim::scene {

/// The bytes of a regular file; nothing where there is none that can be read to its end.
[[nodiscard]] std::optional<std::string> read_text_file(const std::filesystem::path& path);

/// Writes a file completely or not at all: beside its place first, brought to the disk, then given its name. An
/// existing file keeps its permissions and a symbolic link stays one; devices are written directly.
/// @throws std::runtime_error "cannot write FILE: cause"
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace sarsim::scene
