#include "raster/parts/join_parts.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"
#include "core/os/file_identity.hpp"
#include "core/os/output_file.hpp"
#include "core/os/output_folder.hpp"
#include "core/os/process.hpp"
#include "core/os/raw_file.hpp"
#include "core/os/temporary_files.hpp"
#include "raster/format/zarr_store.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/placed_rows.hpp"

namespace sarsim::raster {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20U;
constexpr std::string_view finished_name = "finished";
constexpr const char* door_name = "lock";
constexpr const char* joined_name = "joined";
constexpr const char* frame_name = "frame";

fs::path file_of(const Journal& journal) {
  return journal.head.store == RowStore::placed ? shared_rows_of(journal.path.parent_path())
                                                : rows_file_of(journal.path);
}

// What a journal speaks of, to be read.
PlacedRows rows_of(const Journal& journal, const RowPlaces& places) {
  const bool placed = journal.head.store == RowStore::placed;
  return {file_of(journal), placed ? places : RowPlaces(), core::RawFile::Mode::read};
}

// A claim and whose it is.
struct Piece {
  Claim claim;
  const Journal* journal = nullptr;
};

std::vector<Piece> pieces_of(std::span<const Journal> journals) {
  std::vector<Piece> pieces;
  for (const Journal& journal : journals)
    for (const Claim& claim : journal.claims) pieces.push_back({claim, &journal});
  std::ranges::stable_sort(pieces, {}, [](const Piece& piece) { return piece.claim.rows.first; });
  return pieces;
}

std::string rows_text(RowRange rows) {
  if (rows.count == 1) return fmt::format("pulse {}", rows.first + 1);
  return fmt::format("pulses {} to {}", rows.first + 1, rows.end());
}

// Calls take(bytes) for the bytes of a claim, at most `step` at a time; whether they are as vouched for.
bool each_piece(const PlacedRows& file, const Claim& claim, std::size_t step,
                const std::function<void(std::span<const std::byte>)>& take) {
  core::Checksum sum;
  std::vector<std::byte> bytes;
  for (std::uint64_t done = 0; done < claim.bytes; done += bytes.size()) {
    bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(step, claim.bytes - done)));
    if (!file.read_at(claim.offset + done, bytes)) return false;
    sum.add(bytes);
    if (take) take(bytes);
  }
  return sum.value() == claim.checksum;
}

[[noreturn]] void throw_damaged(const Piece& piece) {
  core::Problem problem =
      file_problem(file_of(*piece.journal).string(),
                   fmt::format("{} are not what part {} wrote", rows_text(piece.claim.rows), piece.journal->head.part));
  problem.hint = "compute them again: run that part with --resume, or delete its journal and run it anew";
  throw core::InvalidRequest({problem});
}

// Throws core::InvalidRequest for a piece whose bytes are not there.
void verify(const std::vector<Piece>& pieces, const RowPlaces& places, const RunControl& control) {
  core::parallel_ranges(pieces.size(), 1, {core::thread_count(control.threads), control.stop},
                        [&](std::size_t begin, std::size_t end) {
                          for (std::size_t i = begin; i < end; ++i)
                            if (!holds(*pieces[i].journal, pieces[i].claim, places)) throw_damaged(pieces[i]);
                        });
}

radar::ConversionTally tally_of(const std::vector<Piece>& pieces) {
  radar::ConversionTally tally;
  for (const Piece& piece : pieces) tally.add(piece.claim.tally);
  return tally;
}

double seconds_of(const std::vector<Piece>& pieces) {
  double seconds = 0.0;
  for (const Piece& piece : pieces) seconds += piece.claim.seconds;
  return seconds;
}

// One join, from the pieces to a complete file that has not its name yet.
class Joiner {
 public:
  Joiner(const JoinTask& task, const RunControl& control)
      : task_(task),
        control_(control),
        pieces_(pieces_of(task.journals)),
        folder_(parts_folder_of(task.output)),
        recorded_{task.product.product.rows, task.product.product.columns, task.product.product.bits},
        is_folder_(format_of(task.product.options.format).folder) {}

  Joined join() {
    expect_place();
    const bool made_here = fs::create_directories(folder_);
    if (is_folder_) places_ = row_places(frame_path(), task_.product.product, task_.product.options).value();
    fs::path complete;
    try {
      return join_into(complete);
    } catch (...) {
      tidy(complete, made_here);
      throw;
    }
  }

 private:
  // What is no file cannot get its content by a change of names.
  void expect_place() const {
    std::error_code ignored;
    const fs::file_status status = fs::status(task_.output, ignored);
    if (!fs::exists(status)) return;
    if (is_folder_ ? is_own_zarr_store(core::end_of_links(task_.output)) : fs::is_regular_file(status)) return;
    core::Problem problem = file_problem(
        task_.output.string(), is_folder_ ? "something that is not a Zarr store of this program has the output's name"
                                          : "parts can only become a file");
    problem.hint = "give the output another name";
    throw core::InvalidRequest({problem});
  }

  // Takes away what a join that fails has made; the parts stay.
  void tidy(const fs::path& complete, bool made_here) const {
    std::error_code ignored;
    if (complete == joined_path()) core::remove_folder(complete);
    fs::remove(frame_path(), ignored);
    if (made_here) fs::remove(folder_, ignored);
  }

  // @param[out] complete  the whole file, as soon as there is one
  Joined join_into(fs::path& complete) {
    const radar::ConversionTally tally = tally_of(pieces_);
    const double given_v = task_.product.product.lsb_v;
    Joined joined;
    if (task_.product.estimate_lsb) {
      complete = convert(joined.report, lsb_of_maximum_v(tally.maximum_v, recorded_.bits));
    } else {
      joined.report = report_of(recorded_, given_v, tally);
      complete = in_place() ? frame(joined.report) : concatenate(joined.report);
    }
    joined.report.seconds = seconds_of(pieces_);
    // Before the file has its name: who dies in between leaves a file that --resume knows, or none.
    write_receipt(complete, joined);
    publish(complete);
    return joined;
  }

  [[nodiscard]] fs::path joined_path() const { return folder_ / joined_name; }
  [[nodiscard]] fs::path frame_path() const { return folder_ / frame_name; }

  [[nodiscard]] bool in_place() const {
    return std::ranges::all_of(pieces_, [&](const Piece& piece) {
      return piece.journal->head.store == RowStore::placed &&
             fs::equivalent(piece.journal->path.parent_path(), folder_);
    });
  }

  fs::path frame(const RunReport& report) {
    verify(unchecked(), places_, control_);
    const fs::path path = shared_rows_of(folder_);
    if (is_folder_) {
      complete_folder(path, task_.product.product, task_.product.options, report);
      core::sync_folder(path);
      return path;
    }
    core::RawFile file(path, core::RawFile::Mode::write);
    write_frame(file, frame_path(), task_.product.product, task_.product.options, report);
    file.sync();
    return path;
  }

  [[nodiscard]] std::unique_ptr<Sink> sink_at(const fs::path& path) const {
    SinkOptions options = task_.product.options;
    options.replace = true;
    // A link or a pipe of this name would lead the recording elsewhere.
    core::remove_folder(path);
    return make_sink(path, task_.product.product, options);
  }

  fs::path concatenate(const RunReport& report) {
    fs::path path = joined_path();
    const auto sink = sink_at(path);
    const auto places = row_places(frame_path(), task_.product.product, task_.product.options);
    const std::size_t row_bytes = places ? static_cast<std::size_t>(places->row_bytes) : 0;
    for (const Piece& piece : pieces_) {
      append(piece, row_bytes, *sink);
      if (control_.stop != nullptr && control_.stop->requested()) throw core::Interrupted();
      if (control_.progress) control_.progress({piece.claim.rows.end(), recorded_.rows, recorded_.columns});
    }
    sink->finish(report);
    return path;
  }

  // Rows of a known size go on as whole rows; text in any pieces, of which the last one counts as the rows.
  void append(const Piece& piece, std::size_t row_bytes, Sink& sink) const {
    const PlacedRows file = rows_of(*piece.journal, places_);
    const RowRange rows = piece.claim.rows;
    const std::size_t step =
        row_bytes > 0 ? std::max(piece_bytes / row_bytes, std::size_t{1}) * row_bytes : piece_bytes;
    std::size_t row = rows.first;
    const bool good = each_piece(file, piece.claim, step, [&](std::span<const std::byte> bytes) {
      const std::size_t count = row_bytes > 0 ? bytes.size() / row_bytes : 0;
      sink.append(bytes, row, count);
      row += count;
    });
    if (!good) throw_damaged(piece);
    if (row_bytes == 0) sink.append({}, rows.first, rows.count);
  }

  fs::path convert(RunReport& report, double lsb_v) {
    verify(pieces_, places_, control_);
    fs::path path = joined_path();
    const auto sink = sink_at(path);
    report = run_stored(
        recorded_, [&] { return reader(); }, lsb_v, *sink, control_);
    return path;
  }

  // Of one thread, with one file open at a time: there may be more parts than a process may have files.
  [[nodiscard]] RowReader reader() const {
    struct Open {
      const Journal* journal = nullptr;
      core::RawFile file;
    };
    return [this, open = std::make_shared<Open>()](std::size_t row, std::span<std::complex<double>> volts) {
      const auto after = std::ranges::upper_bound(pieces_, row, {}, [](const Piece& p) { return p.claim.rows.first; });
      const Piece& piece = *std::prev(after);
      if (open->journal != piece.journal) {
        open->file = core::RawFile();
        open->file = core::RawFile(file_of(*piece.journal), core::RawFile::Mode::read);
        open->journal = piece.journal;
      }
      const std::uint64_t offset = piece.claim.offset + (row - piece.claim.rows.first) * volts.size_bytes();
      if (!open->file.read_at(offset, std::as_writable_bytes(volts))) throw_damaged(piece);
    };
  }

  // Pieces that nobody has looked at since they were written.
  [[nodiscard]] std::vector<Piece> unchecked() const {
    const auto first_row = [](const Claim& claim) { return claim.rows.first; };
    std::vector<Claim> checked = task_.checked;
    std::ranges::sort(checked, {}, first_row);
    std::vector<Piece> pieces;
    std::ranges::copy_if(pieces_, std::back_inserter(pieces), [&](const Piece& piece) {
      const auto alike = std::ranges::equal_range(checked, piece.claim.rows.first, {}, first_row);
      return std::ranges::none_of(alike, [&](const Claim& claim) { return same_bytes(claim, piece.claim); });
    });
    return pieces;
  }

  void publish(const fs::path& complete) const;

  void write_receipt(const fs::path& complete, const Joined& joined) const;

  const JoinTask& task_;
  const RunControl& control_;
  std::vector<Piece> pieces_;
  fs::path folder_;
  Recorded recorded_;
  bool is_folder_;
  RowPlaces places_;  // Of rows that stand in pieces.
};

void Joiner::publish(const fs::path& complete) const {
  try {
    if (is_folder_)
      core::publish_folder(complete, task_.output, task_.replace, is_own_zarr_store);
    else
      core::publish_file(complete, task_.output, task_.replace);
  } catch (...) {
    std::error_code ignored;
    fs::remove(receipt_of(task_.output), ignored);
    throw;
  }
}

std::string state_text(std::uint64_t bytes, const core::FileTime& changed) {
  return fmt::format("{} bytes at {}.{:09d}", bytes, changed.seconds, changed.nanoseconds);
}

// Size and latest time of what a folder holds, without the times of its folders, which change with names.
std::string state_of_folder(const fs::path& path) {
  std::uint64_t bytes = 0;
  core::FileTime latest;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(path, failure), end; !failure && entry != end; entry.increment(failure)) {
    const std::optional<core::FileStatus> status = core::link_status(entry->path());
    if (!status || !status->regular) continue;
    bytes += status->bytes;
    latest = std::max(latest, status->changed);
  }
  return state_text(bytes, latest);
}

// Size and time of a file's content; both survive a change of its name.
std::string state_of(const fs::path& path) {
  const std::optional<core::FileStatus> status = core::file_status(path);
  if (!status) return {};
  return status->folder ? state_of_folder(path) : state_text(status->bytes, status->changed);
}

void Joiner::write_receipt(const fs::path& complete, const Joined& joined) const {
  JournalHead head;
  if (!task_.journals.empty()) head.identity = task_.journals.front().head.identity;
  head.identity.emplace_back(finished_name, state_of(complete));
  head.part = "all";
  head.range = {0, recorded_.rows};
  Claim claim;
  claim.rows = head.range;
  claim.seconds = joined.report.seconds;
  claim.tally = {joined.report.maximum_v, joined.report.saturated, joined.report.zero};
  const std::string text = text_of(head) + text_of(claim);
  static_cast<void>(core::replace_file(receipt_of(task_.output), std::as_bytes(std::span(text))));
}

// What the receipt of a file says that was not changed since.
std::optional<Journal> receipt_journal(const fs::path& output) {
  std::error_code missing;
  if (!fs::exists(receipt_of(output), missing)) return std::nullopt;
  const auto read = read_journal(receipt_of(output));
  const auto* journal = std::get_if<Journal>(&read);
  if (journal == nullptr || journal->claims.size() != 1) return std::nullopt;
  const Identity& identity = journal->head.identity;
  const auto finished = std::ranges::find(identity, finished_name, &Identity::value_type::first);
  if (finished == identity.end() || finished->second != state_of(output)) return std::nullopt;
  return *journal;
}

void add_identity_problems(const std::vector<Journal>& journals, core::Problems& problems) {
  for (std::size_t i = 1; i < journals.size(); ++i) {
    const JournalHead& first = journals.front().head;
    const JournalHead& other = journals[i].head;
    for (const std::string& difference :
         differences(first.identity, "in part " + first.part, other.identity, "in part " + other.part))
      problems.push_back(
          file_problem(journals[i].path.string(), "parts of different runs cannot be joined: " + difference));
  }
}

// Removes a folder of parts whose rows and journals are gone. The description tells whose rest the folder is to whoever
// finds it behind a process that was killed, so it goes with the folder's name, all at once. What others have put there
// stays.
void remove_emptied(const fs::path& folder) noexcept {
  std::error_code failure;
  const fs::path place = folder.filename().empty() ? folder.parent_path() : folder;
  fs::path rest = place.parent_path();
  rest /= fmt::format(".{}.partial-{}", place.filename().string(), core::process_id());
  const core::TemporaryName name(rest);
  const bool renamed = !fs::is_symlink(place, failure) && (fs::rename(place, rest, failure), !failure);
  const fs::path& now = renamed ? rest : place;
  core::remove_folder(product_file_of(now));
  core::remove_folder(now / door_name);
  if (!fs::remove(now, failure) && renamed) fs::rename(rest, place, failure);
}

// Whose the missing rows would be.
std::string owner_text(const std::vector<Journal>& journals, RowRange missing) {
  for (const Journal& journal : journals) {
    const RowRange range = journal.head.range;
    if (missing.first >= range.first && missing.first < range.end())
      return fmt::format("part {} has not finished; continue it with --resume", journal.head.part);
  }
  return "no part of them is here; run it, or bring its files here";
}

}  // namespace

fs::path parts_folder_of(const fs::path& output) {
  fs::path folder = core::end_of_links(output);
  folder += ".parts";
  return folder;
}

fs::path receipt_of(const fs::path& output) {
  fs::path path = core::end_of_links(output);
  path += ".journal";
  return path;
}

fs::path shared_rows_of(const fs::path& folder) { return folder / "samples"; }
fs::path product_file_of(const fs::path& folder) { return folder / "product"; }

core::RawFile open_door(const fs::path& folder) {
  for (;;) {
    fs::create_directories(folder);
    try {
      core::RawFile door(folder / door_name, core::RawFile::Mode::write);
      door.lock();
      if (door.still_there()) return door;
    } catch (const std::system_error& error) {
      if (error.code() != std::errc::no_such_file_or_directory) throw;
    }
  }
}

bool is_left_by_join(const std::string& name) {
  return name == joined_name || name == frame_name || name.starts_with(fmt::format(".{}.partial-", joined_name)) ||
         name.starts_with(fmt::format(".{}.partial-", frame_name));
}

void remove_joins(const fs::path& folder) noexcept {
  std::error_code ignored;
  std::vector<fs::path> left;
  bool parts = false;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (is_left_by_join(name))
      left.push_back(entry->path());
    else
      parts = parts || name != door_name;
  }
  if (ignored) return;
  for (const fs::path& path : left) core::remove_folder(path);
  if (parts) return;
  core::remove_folder(folder / door_name);
  fs::remove(folder, ignored);
}

std::vector<Journal> read_journals(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".journal") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Journal> journals;
  core::Problems problems;
  for (const fs::path& path : paths) {
    auto read = read_journal(path);
    if (auto* problem = std::get_if<core::Problem>(&read))
      problems.push_back(std::move(*problem));
    else
      journals.push_back(std::move(std::get<Journal>(read)));
  }
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  return journals;
}

void remove_parts(const fs::path& folder) noexcept {
  std::error_code ignored;
  std::vector<fs::path> paths{shared_rows_of(folder), folder / frame_name, folder / joined_name};
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    const bool ours = name.ends_with(".journal") || name.ends_with(".rows") ||
                      name.find(".new-") != std::string::npos || name.find(".partial-") != std::string::npos;
    if (ours) paths.push_back(entry->path());
  }
  for (const fs::path& path : paths) core::remove_folder(path);
  remove_emptied(folder);
}

std::vector<RowRange> missing_rows(RowRange range, std::span<const Journal> journals) {
  std::vector<RowRange> missing;
  std::size_t next = range.first;
  for (const Piece& piece : pieces_of(journals)) {
    const RowRange rows = piece.claim.rows;
    if (rows.first >= range.end()) break;
    if (rows.first > next) missing.push_back({next, rows.first - next});
    next = std::max(next, rows.end());
  }
  if (next < range.end()) missing.push_back({next, range.end() - next});
  return missing;
}

core::Problems join_problems(const std::vector<Journal>& journals, std::size_t rows) {
  constexpr std::size_t most = 10;
  core::Problems problems;
  add_identity_problems(journals, problems);
  if (!problems.empty()) return problems;
  const std::vector<Piece> pieces = pieces_of(journals);
  for (std::size_t i = 1; i < pieces.size() && problems.size() < most; ++i) {
    const RowRange before = pieces[i - 1].claim.rows;
    const RowRange here = pieces[i].claim.rows;
    if (here.first >= before.end()) continue;
    const RowRange both{here.first, std::min(before.end(), here.end()) - here.first};
    problems.push_back(file_problem(pieces[i].journal->path.string(),
                                    fmt::format("parts overlap: {} are in part {} and in part {}", rows_text(both),
                                                pieces[i - 1].journal->head.part, pieces[i].journal->head.part)));
    problems.back().hint = "leave one of them out";
  }
  for (const RowRange& missing : missing_rows({0, rows}, journals)) {
    if (problems.size() >= most) break;
    core::Problem problem =
        file_problem({}, fmt::format("parts are missing: no part holds {} of {}", rows_text(missing), rows));
    problem.hint = owner_text(journals, missing);
    problems.push_back(std::move(problem));
  }
  return problems;
}

core::Problems product_problems(const StoredProduct& product, const fs::path& file, const Journal& journal) {
  core::Problems problems;
  for (const std::string& difference :
       differences(product.identity, "in the description", journal.head.identity, "in part " + journal.head.part))
    problems.push_back(file_problem(file.string(), "the description of the recording is of another run: " + difference,
                                    {}, {}, "bring the file 'product' of the folder of these parts"));
  return problems;
}

bool holds(const Journal& journal, const Claim& claim, const RowPlaces& places) {
  std::error_code missing;
  if (!fs::exists(file_of(journal), missing)) return false;
  return each_piece(rows_of(journal, places), claim, piece_bytes, {});
}

Joined join_parts(const JoinTask& task, const RunControl& control) { return Joiner(task, control).join(); }

bool is_finished(const fs::path& output) { return receipt_journal(output).has_value(); }

std::optional<Receipt> read_receipt(const fs::path& output, const StoredProduct& stored) {
  const std::optional<Journal> journal = receipt_journal(output);
  if (!journal) return std::nullopt;
  Receipt receipt{journal->head.identity, {}};
  std::erase_if(receipt.identity, [](const auto& one) { return one.first == finished_name; });
  const Claim& claim = journal->claims.front();
  const Product& product = stored.product;
  const double lsb_v = stored.estimate_lsb ? lsb_of_maximum_v(claim.tally.maximum_v, product.bits) : product.lsb_v;
  receipt.report = report_of({product.rows, product.columns, product.bits}, lsb_v, claim.tally);
  receipt.report.seconds = claim.seconds;
  return receipt;
}

}  // namespace sarsim::raster
