#include "picture/image/overview_cache.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <fstream>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "core/os/file_identity.hpp"
#include "scene/edit/text_file.hpp"

namespace sarsim::picture {

namespace {

namespace fs = std::filesystem;

// Magic, format, length of the key, key, count, checksum of the numbers, numbers; the machine's own byte order, which
// the format number shows.
constexpr std::string_view magic = "SARSIMOV";
constexpr std::uint32_t format = 2;
constexpr std::string_view extension = ".overview";

template <class Number>
void append(std::string& text, Number value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string head_of(const std::string& key, const std::vector<float>& numbers) {
  std::string head(magic);
  append(head, format);
  append(head, static_cast<std::uint32_t>(key.size()));
  head += key;
  append(head, static_cast<std::uint64_t>(numbers.size()));
  append(head, core::checksum_of(std::as_bytes(std::span(numbers))));
  return head;
}

}  // namespace

std::optional<std::string> file_identity(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::canonical(path, error);
  if (error) return std::nullopt;
  const std::optional<core::FileStatus> status = core::file_status(whole);
  if (!status) return std::nullopt;
  return fmt::format("{}\n{}\n{}.{:09}\n{}", whole.string(), status->bytes, status->changed.seconds,
                     status->changed.nanoseconds, status->identity.number);
}

OverviewCache::OverviewCache(fs::path folder, std::string identity, std::uint64_t max_bytes)
    : folder_(std::move(folder)), identity_(std::move(identity)), max_bytes_(max_bytes) {}

fs::path OverviewCache::file_of(const std::string& words) const {
  return folder_ / fmt::format("{:016x}{}", core::checksum_of(identity_ + "\n" + words), extension);
}

std::optional<std::vector<float>> OverviewCache::load(const std::string& words, std::size_t count) const {
  std::error_code error;
  const fs::path path = file_of(words);
  const std::string key = identity_ + "\n" + words;
  // The size is known beforehand, so that a foreign file is not even read.
  const std::vector<float> none;
  const std::size_t head_size = head_of(key, none).size();
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != head_size + count * sizeof(float))
    return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string head(head_size, '\0');
  std::vector<float> numbers(count);
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())) ||
      !file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(count * sizeof(float))) ||
      head != head_of(key, numbers))
    return std::nullopt;
  // Used files are the last to be removed.
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);
  return numbers;
}

void OverviewCache::store(const std::string& words, const std::vector<float>& numbers) const try {
  if (folder_.empty() || numbers.size() * sizeof(float) > max_bytes_) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  std::string text = head_of(identity_ + "\n" + words, numbers);
  text.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
  scene::write_text_file(file_of(words), text);
  remove_oldest();
} catch (const std::exception&) {
  // What cannot be kept is made again.
}

void OverviewCache::remove_oldest() const {
  struct Entry {
    fs::file_time_type used;
    std::uint64_t size;
    fs::path path;
  };
  std::vector<Entry> entries;
  std::uint64_t all = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (!entry.is_regular_file(error) || entry.is_symlink(error) || entry.path().extension() != extension) continue;
    entries.push_back({entry.last_write_time(error), entry.file_size(error), entry.path()});
    all += entries.back().size;
  }
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry& entry : entries) {
    if (all <= max_bytes_) return;
    fs::remove(entry.path, error);
    all -= entry.size;
  }
}

}  // namespace sarsim::picture
