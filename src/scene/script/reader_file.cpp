#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/large_pages.hpp"
#include "core/os/sequential_file.hpp"
#include "core/task/stop_points.hpp"
#include "core/text/number_text.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene {

namespace {

namespace fs = std::filesystem;

struct FileBytes {
  std::string text;
  std::string failure;  // why there is no text, in words; empty for none
};

// Why nothing can be read from here at all; empty where something might.
std::string refusal(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  switch (status.type()) {
    case fs::file_type::not_found: return "no such file";
    case fs::file_type::directory: return "is a folder, not a file";
    case fs::file_type::regular:
    case fs::file_type::fifo: return {};
    case fs::file_type::none: return error.message();
    default: return "is not a file";
  }
}

std::string too_large() { return fmt::format("is larger than {}", core::bytes_text(double{largest_script_bytes})); }

FileBytes read_bytes(const fs::path& path, const core::StopFlag* stop) {
  FileBytes bytes;
  bytes.failure = refusal(path);
  if (!bytes.failure.empty()) return bytes;
  std::error_code unknown_size;
  const std::uintmax_t size = fs::file_size(path, unknown_size);
  if (!unknown_size && size > largest_script_bytes) return {{}, too_large()};
  core::SequentialFile stream(path, [stop] { core::end_if_asked(stop); });
  constexpr std::size_t piece = std::size_t{1} << 20;
  if (!unknown_size) bytes.text.reserve(static_cast<std::size_t>(size));
  std::vector<char> buffer(piece);
  while (const std::size_t got = stream.read(buffer)) {
    bytes.text.append(buffer.data(), got);
    if (bytes.text.size() > largest_script_bytes) return {{}, too_large()};
  }
  if (const std::error_code failure = stream.failure()) return {{}, failure.message()};
  return bytes;
}

// Whether all bytes that were asked for could be had.
bool reads_all(const core::InputFile& file, std::size_t offset, std::span<std::byte> bytes) try {
  return file.read_at(offset, bytes) == bytes.size();
} catch (const std::system_error&) {
  return false;
}

struct LargeText {
  std::unique_ptr<char[]> bytes;  // NOLINT: not a vector, which would write to all of it first
  std::size_t size = 0;
};

// The bytes of a large ordinary file, read by all threads; nothing for other files and for any that cannot be read so.
std::optional<LargeText> read_large(const fs::path& path, const core::WorkControl& control) {
  constexpr std::uintmax_t large = std::uintmax_t{1} << 18;
  constexpr std::size_t range_bytes = std::size_t{1} << 19;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, failure);
  if (failure || size < large || size > largest_script_bytes) return std::nullopt;
  LargeText text{std::make_unique_for_overwrite<char[]>(size), static_cast<std::size_t>(size)};  // NOLINT
  core::prefer_large_pages(text.bytes.get(), text.size);
  const auto opened = core::InputFile::open(path);
  const auto* const file = std::get_if<core::InputFile>(&opened);
  if (file == nullptr) return std::nullopt;
  std::atomic<bool> complete{true};
  core::parallel_ranges(text.size, range_bytes, control, [&](std::size_t begin, std::size_t end) {
    if (!reads_all(*file, begin, std::as_writable_bytes(std::span(text.bytes.get() + begin, end - begin))))
      complete = false;
  });
  if (!complete) return std::nullopt;
  return text;
}

// The name as typed and, for scripts from systems that part folders with a backslash, with slashes.
std::vector<std::string> spellings(const std::string& name) {
  std::vector<std::string> names{name};
  std::string slashed = name;
  std::ranges::replace(slashed, '\\', '/');
  if (slashed != name) names.push_back(slashed);
  return names;
}

std::vector<fs::path> places_to_look(const fs::path& script_folder, const std::string& name) {
  std::vector<fs::path> places;
  for (const std::string& spelling : spellings(name)) {
    places.push_back((script_folder / spelling).lexically_normal());
    const fs::path here = fs::path(spelling).lexically_normal();
    if (std::ranges::find(places, here) == places.end()) places.push_back(here);
  }
  return places;
}

DataFileText load(const fs::path& script_folder, const std::string& name) {
  const fs::path place = data_file_on_disk(script_folder, name);
  if (place.empty()) {
    std::string looked_at;
    for (const fs::path& other : places_to_look(script_folder, name))
      looked_at += (looked_at.empty() ? "" : " and ") + other.string();
    return {{}, {}, "data file not found; looked for " + looked_at};
  }
  // Nobody stands at the other end of a pipe that a script names, and one would wait for ever.
  std::error_code ignored;
  FileBytes bytes = fs::is_fifo(place, ignored) ? FileBytes{{}, "is not a file"} : read_bytes(place, nullptr);
  if (bytes.failure.empty()) return {place.string(), std::move(bytes.text), {}};
  return {place.string(), {}, fmt::format("data file {}: {}", place.string(), bytes.failure)};
}

// What to do about a script that cannot be read.
std::string remedy(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  for (const char* const ending : {".toml", ".scr", ".json"}) {
    fs::path script = path;
    script += ending;
    if (!fs::exists(status) && fs::exists(script, ignored)) return fmt::format("did you mean {}?", script.string());
  }
  if (!fs::exists(status)) return "check the name and the folder; file names are case-sensitive";
  if (fs::is_directory(status)) return "name a script in that folder";
  return "give a text file that you may read";
}

}  // namespace

DataFileLoader disk_loader(const fs::path& script_folder) {
  return [script_folder](const std::string& name) { return load(script_folder, name); };
}

PointsLoader disk_points(const fs::path& script_folder) {
  return [script_folder](const std::string& name, const FunctionBlock& block) -> NamedPoints {
    DataFileText data = load(script_folder, name);
    if (!data.failure.empty()) return {{}, std::move(data.failure)};
    DataFileReading reading = read_data_file(data.text, data.path, block);
    for (const core::Problem& problem : reading.problems)
      if (problem.severity == core::Severity::error) return {{}, core::to_string(problem)};
    return {std::move(reading.functions), {}};
  };
}

fs::path data_file_on_disk(const fs::path& script_folder, const std::string& name) {
  for (fs::path& place : places_to_look(script_folder, name)) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) return std::move(place);
  }
  return {};
}

ScriptReading read_script_file(const fs::path& path, const ReadControl& control) {
  return read_text_of_file(path, control, read_script);
}

ScriptReading read_text_of_file(const fs::path& path, const ReadControl& control, TextReader& read) {
  if (const std::optional<LargeText> text = read_large(path, control.work))
    return read({text->bytes.get(), text->size}, path.string(), disk_loader(path.parent_path()), control);
  const FileBytes bytes = read_bytes(path, control.work.stop);
  if (bytes.failure.empty()) return read(bytes.text, path.string(), disk_loader(path.parent_path()), control);
  ScriptReading result;
  result.problems.push_back(
      core::error(fmt::format("cannot read the script: {}", bytes.failure)).in(path.string()).hint(remedy(path)));
  return result;
}

}  // namespace sarsim::scene
