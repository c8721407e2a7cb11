#include "scene/edit/recovery.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/hash/fnv1a.hpp"
#include "core/os/process.hpp"
#include "scene/edit/text_file.hpp"

namespace sarsim::scene {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view ending = ".recovery";
// Of files that write_text_file has not completed: ".NAME.partial-PID-N", of earlier programs ".sarsim-PID-N.part".
constexpr std::string_view part_mark = ".partial-";
constexpr std::string_view earlier_part_beginning = ".sarsim-";
constexpr std::string_view earlier_part_ending = ".part";
constexpr std::string_view first_line = "Sarsim recovery copy 1\n";

// The next of numbers that are parted by one character, taken off the front of the line together with it.
std::optional<std::uint64_t> take_number(std::string_view& line, char part = ' ') {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc{}) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  if (line.starts_with(part)) line.remove_prefix(1);
  return number;
}

struct Content {
  std::uint64_t start = 0;
  fs::path document;
  std::string text;
};

std::string packed(std::uint64_t start, const fs::path& document, const std::string& text) {
  const std::string content = document.string() + text;
  return fmt::format("{}{} {} {} {}\n{}", first_line, start, document.string().size(), text.size(),
                     core::fnv1a(content), content);
}

std::optional<Content> unpacked(std::string_view copy) {
  if (!copy.starts_with(first_line)) return std::nullopt;
  copy.remove_prefix(first_line.size());
  const std::size_t line_end = copy.find('\n');
  if (line_end == std::string_view::npos) return std::nullopt;
  std::string_view line = copy.substr(0, line_end);
  const std::string_view content = copy.substr(line_end + 1);
  const auto start = take_number(line);
  const auto path_size = take_number(line);
  const auto text_size = take_number(line);
  const auto sum = take_number(line);
  if (!start || !path_size || !text_size || !sum) return std::nullopt;
  if (*path_size > content.size() || content.size() - *path_size != *text_size || core::fnv1a(content) != *sum)
    return std::nullopt;
  return Content{*start, fs::path(content.substr(0, *path_size)), std::string(content.substr(*path_size))};
}

// The name of a copy holds the start as well: the next process of this number must not write over what this one left.
// Where starts are not known, the present moment parts the two.
std::string copy_name(long process, int number) {
  std::uint64_t start = core::process_start(process);
  if (start == 0) start = static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
  return number == 0 ? fmt::format("{}-{}{}", process, start, ending)
                     : fmt::format("{}-{}-{}{}", process, start, number, ending);
}

// The process that a file belongs to, by a name of the form 123.recovery, 123-456.recovery or 123-456-7.recovery, which
// is of its document number 7; 0 for other files.
long owner_of(const fs::path& file) {
  const std::string whole = file.filename().string();
  std::string_view name = whole;
  const auto owner = take_number(name, '-');
  if (!owner || *owner > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) return 0;
  if (take_number(name, '-')) static_cast<void>(take_number(name));
  return name == ending ? static_cast<long>(*owner) : 0;
}

// The process that a partly written file was left by, had it been killed; 0 for other files.
long writer_of(const fs::path& file) {
  const std::string whole = file.filename().string();
  std::string_view name = whole;
  if (name.starts_with(earlier_part_beginning) && name.ends_with(earlier_part_ending)) {
    name.remove_prefix(earlier_part_beginning.size());
  } else if (const std::size_t mark = name.rfind(part_mark); name.starts_with('.') && mark != std::string_view::npos) {
    name.remove_prefix(mark + part_mark.size());
  } else {
    return 0;
  }
  return static_cast<long>(std::min(take_number(name, '-').value_or(0), std::uint64_t{1} << 62));
}

// What writers left that were killed while they wrote is of no use to anybody. A folder may be shared with machines
// whose processes are not seen here, so young files are left alone.
void sweep(const fs::path& file) {
  constexpr auto longest_writing = std::chrono::minutes(1);
  const long writer = writer_of(file);
  if (writer <= 0 || core::is_running(writer, 0)) return;
  std::error_code gone;
  const auto written = fs::last_write_time(file, gone);
  if (!gone && fs::file_time_type::clock::now() - written > longest_writing) fs::remove(file, gone);
}

}  // namespace

Recovery::Recovery(const fs::path& folder, long owner, int number)
    : owner_(owner), file_(folder / copy_name(owner, number)) {}

void Recovery::keep(const fs::path& document, const std::string& text) const {
  const fs::path folder = file_.parent_path();
  std::error_code error;
  if (fs::create_directories(folder, error))
    fs::permissions(folder, fs::perms::owner_all, error);  // scenes are nobody else's business
  else if (!fs::is_directory(folder))
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  write_text_file(file_, packed(core::process_start(owner_), document, text));
}

void Recovery::forget() const {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

std::vector<Recovery::Copy> Recovery::orphans(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, Copy>> found;
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
    const long owner = owner_of(entry.path());
    if (owner == 0) {
      sweep(entry.path());
      continue;
    }
    const auto bytes = read_text_file(entry.path());
    auto content = bytes ? unpacked(*bytes) : std::nullopt;
    if (!content || core::is_running(owner, content->start)) continue;
    std::error_code ignored;
    found.emplace_back(fs::last_write_time(entry.path(), ignored),
                       Copy{entry.path(), std::move(content->document), std::move(content->text)});
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, [](const auto& copy) { return copy.first; });
  std::vector<Copy> copies;
  for (auto& [time, copy] : found) copies.push_back(std::move(copy));
  return copies;
}

void Recovery::discard(const Copy& copy) {
  std::error_code ignored;
  fs::remove(copy.file, ignored);
}

}  // namespace sarsim::scene
