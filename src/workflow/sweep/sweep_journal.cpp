#include "workflow/sweep/sweep_journal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/os/raw_file.hpp"
#include "core/report/retryable.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr const char* heading =
    "sarsim sweep 2: stamp, file, bytes, written, seconds, engine, lsb_estimated, rows, columns, "
    "maximum_v, lsb_v, best_lsb_v, range_used, saturated, zero, figures, end\n";

constexpr const char* begun_word = "begun";

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == '\t')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

// Reads one cell after the other; one that does not fit is remembered.
class CellReader {
 public:
  explicit CellReader(const std::vector<std::string>& cells) : cells_(cells) {}

  const std::string& word() { return cells_[next_++]; }
  double number() {
    const auto value = core::parse_number(word());
    good_ = good_ && value;
    return value.value_or(0.0);
  }
  std::uint64_t whole(int base = 10) {
    const auto value = core::parse_whole(word(), base);
    good_ = good_ && value;
    return value.value_or(0);
  }
  // Nothing for "-".
  std::optional<std::int64_t> time() {
    const std::string& text = word();
    if (text == "-") return std::nullopt;
    const auto value = core::parse_integer(text);
    good_ = good_ && value;
    return value;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  const std::vector<std::string>& cells_;
  std::size_t next_ = 0;
  bool good_ = true;
};

// "focus-1a2b name=value name=value"; what is no number is empty.
std::string text_of_figures(const SweepRow& row) {
  std::string text = row.followed;
  for (const SweepFigure& figure : row.figures) {
    text += fmt::format(" {}=", figure.name);
    if (std::isfinite(figure.value)) core::append_number(text, figure.value);
  }
  return text;
}

bool read_figures(std::string_view text, SweepRow& row) {
  row.followed = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(row.followed.size() + 1, text.size()));
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(one.size() + 1, text.size()));
    const std::size_t equals = one.find('=');
    if (equals == std::string_view::npos || equals == 0) return false;
    const std::string_view value = one.substr(equals + 1);
    const auto number = core::parse_number(value);
    if (!number && !value.empty()) return false;
    row.figures.push_back(
        {std::string(one.substr(0, equals)), number.value_or(std::numeric_limits<double>::quiet_NaN())});
  }
  return true;
}

// A row whose file was begun; nothing where the line says something else.
std::optional<SweepRow> read_begun_line(std::string_view line) {
  const std::vector<std::string> cells = cells_of(std::string(line));
  if (cells.size() != 3 || cells.back() != begun_word) return std::nullopt;
  CellReader reader(cells);
  SweepRow row;
  row.stamp = reader.whole(16);
  row.file = reader.word();
  row.begun = true;
  return reader.good() && !row.file.empty() ? std::optional(row) : std::nullopt;
}

// Empty where the file cannot be read: then everything is made again.
std::string text_of_journal(const fs::path& path) try {
  return core::read_journal_file(path);
} catch (const std::system_error&) {
  return {};
}

// Those of all parts of a sweep.
std::vector<fs::directory_entry> journals_of(const fs::path& folder, const std::string& stem) {
  std::vector<fs::directory_entry> journals;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    const bool ours = name == stem + ".journal" || (name.starts_with(stem + "-") && name.ends_with(".journal"));
    std::error_code gone;
    if (ours && entry.is_regular_file(gone)) journals.push_back(entry);
  }
  return journals;
}

// The part that a journal is of, "sweep-2-of-4.journal"; the whole where its name speaks of none.
SweepPart part_of_journal(const fs::path& journal, const std::string& stem) {
  SweepPart part;
  const std::string name = journal.stem().string();
  std::size_t number = 0;
  std::size_t count = 0;
  if (std::sscanf(name.c_str() + std::min(stem.size(), name.size()), "-%zu-of-%zu", &number, &count) == 2 &&
      number >= 1 && number <= count)
    part = {number - 1, count};
  return part;
}

// Whether two parts have a variation in common, where the sweep is long enough.
bool meet(const SweepPart& a, const SweepPart& b) {
  const std::size_t step = std::gcd(a.count, b.count);
  return a.index % step == b.index % step;
}

// Whether a process holds a journal; not of one that we may not write, which tells us nothing.
bool is_held(const fs::path& journal) try {
  return !core::RawFile(journal, core::RawFile::Mode::append).try_lock();
} catch (const std::exception&) {
  return false;
}

}  // namespace

std::string journal_line(const SweepRow& row) {
  const raster::RunReport& run = row.run;
  std::string line = fmt::format("{:016x}\t{}\t{}\t{}\t{}\t{}\t{}", row.stamp, row.file, core::format_number(row.bytes),
                                 row.written ? std::to_string(*row.written) : "-", core::format_number(row.seconds),
                                 row.engine, row.lsb_estimated ? 1 : 0);
  line += fmt::format("\t{}\t{}", run.rows, run.columns);
  for (const double value : {run.maximum_v, run.lsb_v, run.best_lsb_v, run.range_used}) {
    line += '\t';
    core::append_number(line, value);
  }
  return line + fmt::format("\t{}\t{}\t{}\t.", run.saturated, run.zero, text_of_figures(row));
}

bool read_journal_line(const std::string& line, SweepRow& row) {
  const std::vector<std::string> cells = cells_of(line);
  // Without figures before there were any.
  constexpr std::size_t before = 16;
  if ((cells.size() != before && cells.size() != before + 1) || cells.back() != ".") return false;
  CellReader reader(cells);
  row.stamp = reader.whole(16);
  row.file = reader.word();
  row.bytes = reader.number();
  row.written = reader.time();
  row.seconds = reader.number();
  row.engine = reader.word();
  row.lsb_estimated = reader.whole() != 0;
  row.run.rows = reader.whole();
  row.run.columns = reader.whole();
  for (double raster::RunReport::*member : {&raster::RunReport::maximum_v, &raster::RunReport::lsb_v,
                                            &raster::RunReport::best_lsb_v, &raster::RunReport::range_used})
    row.run.*member = reader.number();
  row.run.saturated = reader.whole();
  row.run.zero = reader.whole();
  row.table = row.engine.empty();
  const bool figures = cells.size() == before || read_figures(reader.word(), row);
  row.done = reader.good() && figures && !row.file.empty();
  return row.done;
}

std::optional<std::int64_t> modification_time(const fs::path& file) {
  std::error_code none;
  const fs::file_time_type time = fs::last_write_time(file, none);
  if (none) return std::nullopt;
  return time.time_since_epoch().count();
}

SweepJournal::SweepJournal(const fs::path& path, bool keep) : file_(core::JournalFile::open(path, keep, heading)) {}

void SweepJournal::add(const SweepRow& row) {
  const std::string line = journal_line(row) + "\n";
  const std::scoped_lock hold(lock_);
  file_.add(line);
}

void SweepJournal::add_begun(const SweepRow& row) {
  const std::string line = fmt::format("{:016x}\t{}\t{}\n", row.stamp, row.file, begun_word);
  const std::scoped_lock hold(lock_);
  file_.add(line);
}

bool takes_journal_lines(const fs::path& path) {
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (!fs::exists(status)) return true;
  if (!fs::is_regular_file(status)) return false;
  if (fs::file_size(path, none) == 0) return true;
  constexpr std::size_t longest_heading = 1000;
  std::string line = core::beginning_of(path, longest_heading);
  // Of any version: a heading is as good as the next, and lines of another are passed over.
  line.resize(std::min(line.find('\n'), line.size()));
  const std::string_view name = "sarsim sweep ";
  return line.starts_with(name) && line.find(": stamp, file, ") == name.size() + 1 && line.ends_with(", end");
}

void expect_nobody_at_work(const fs::path& folder, const std::string& stem, const SweepPart& part) {
  for (const fs::directory_entry& entry : journals_of(folder, stem)) {
    const SweepPart other = part_of_journal(entry.path(), stem);
    if (!meet(part, other) || !is_held(entry.path())) continue;
    throw core::RetryableError(core::Problems{
        core::error(other.count == 1 ? "this sweep is being made by another process"
                                     : fmt::format("part {}/{} of this sweep is being made by another process",
                                                   other.index + 1, other.count))
            .hint("wait for it, or end it and continue with --resume")
            .in(entry.path().string())});
  }
}

std::map<std::string, SweepRow> read_journals(const fs::path& folder, const std::string& stem) {
  std::map<std::string, SweepRow> rows;
  std::vector<std::pair<fs::file_time_type, fs::path>> journals;
  for (const fs::directory_entry& entry : journals_of(folder, stem)) {
    std::error_code gone;
    journals.emplace_back(entry.last_write_time(gone), entry.path());
  }
  std::ranges::sort(journals);
  const auto take = [&](std::string_view line) {
    SweepRow row;
    if (const auto begun = read_begun_line(line)) {
      SweepRow& known = rows.try_emplace(begun->file, *begun).first->second;
      if (known.stamp != begun->stamp) known = *begun;
      known.begun = true;
      return;
    }
    if (!read_journal_line(std::string(line), row)) return;
    const auto known = rows.find(row.file);
    const bool poorer = known != rows.end() && known->second.stamp == row.stamp && known->second.written;
    if (row.written || !poorer) rows.insert_or_assign(row.file, std::move(row));
  };
  for (const auto& [time, path] : journals) {
    const std::string text = text_of_journal(path);
    const core::JournalLines lines = core::lines_of_journal(text);
    std::ranges::for_each(lines.whole, take);
    take(lines.cut_off);  // Its last cell shows whether only the line's end is missing.
  }
  return rows;
}

}  // namespace sarsim::workflow
