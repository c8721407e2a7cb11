#include "core/os/journal_file.hpp"

#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "core/report/retryable.hpp"

namespace sarsim::core {

namespace {

constexpr std::string_view seal_mark = " #";

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

std::uint64_t size_of_journal(const RawFile& file) {
  const std::uint64_t bytes = file.size();
  if (bytes <= max_journal_bytes) return bytes;
  throw InvalidRequest(Problems{error("the file is too large for a journal")
                                    .found(fmt::format("{} bytes", bytes))
                                    .expected(fmt::format("at most {}", max_journal_bytes))
                                    .hint("delete this journal: what it lists is then computed again")
                                    .in(file.path().string())});
}

[[noreturn]] void throw_in_use(const std::filesystem::path& path) {
  throw RetryableError(
      Problems{error("another process is adding to this journal").hint("wait for it").in(path.string())});
}

}  // namespace

std::string sealed_line(std::string_view content) {
  return fmt::format("{}{}{:016x}\n", content, seal_mark, checksum_of(content));
}

std::optional<std::string_view> unsealed_line(std::string_view line) {
  const std::size_t mark = line.rfind(seal_mark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view content = line.substr(0, mark);
  if (line.substr(mark + seal_mark.size()) != fmt::format("{:016x}", checksum_of(content))) return std::nullopt;
  return content;
}

JournalLines lines_of_journal(std::string_view text) {
  JournalLines lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    lines.whole.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  lines.cut_off = text;
  return lines;
}

std::string read_journal_file(const std::filesystem::path& path) {
  const RawFile file(path, RawFile::Mode::read);
  std::string text;
  // Whoever goes on with a journal may cut a line off it meanwhile.
  do text.resize(size_of_journal(file));
  while (!file.read_at(0, std::as_writable_bytes(std::span(text))));
  return text;
}

JournalFile::JournalFile(RawFile file) : file_(std::move(file)), end_(file_.size()) {}

JournalFile JournalFile::open(const std::filesystem::path& path, bool keep, std::string_view heading) {
  RawFile file(path, RawFile::Mode::append);
  if (!file.try_lock()) throw_in_use(path);
  JournalFile journal(std::move(file));
  journal.appends_ = true;
  if (!keep && journal.end_ > 0) journal.cut(0);
  // A line that was cut off must not swallow the next one.
  journal.add(journal.end_ > 0 ? "\n" : heading);
  return journal;
}

void JournalFile::cut(std::uint64_t whole_bytes) {
  file_.resize(whole_bytes);
  end_ = whole_bytes;
}

void JournalFile::add(std::string_view lines) {
  if (appends_) return file_.append(bytes_of(lines));
  file_.write_at(end_, bytes_of(lines));
  file_.sync();
  end_ += lines.size();
}

}  // namespace sarsim::core
