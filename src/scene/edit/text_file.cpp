#include "scene/edit/text_file.hpp"

#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/os/process.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", path.string(), std::error_code(error, std::generic_category()).message()));
}

}  // namespace

std::optional<std::string> read_text_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  if (const auto size = fs::file_size(path, error); error || size > largest_script_bytes) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) return std::nullopt;
  return text;
}

void write_text_file(const fs::path& path, std::string_view text) try {
  std::error_code none;
  // Whoever may not write the file itself shall not replace it either.
  if (fs::is_regular_file(path, none))
    if (const std::error_code failure = core::write_failure(path)) fail(path, failure.value());
  core::OutputFile file(path, true);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
} catch (const std::system_error& error) {
  fail(path, error.code().value());
}

}  // namespace sarsim::scene
