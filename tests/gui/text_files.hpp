#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace sarsim::test {

/// All bytes of a file; none where it cannot be read.
inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace sarsim::test
