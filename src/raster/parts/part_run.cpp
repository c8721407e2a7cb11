#include "raster/parts/part_run.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/os/process.hpp"
#include "core/os/temporary_files.hpp"
#include "core/report/retryable.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace fs = std::filesystem;

namespace {

std::string maker_text() { return fmt::format("{}, process {}", core::host_name(), core::process_id()); }

bool meet(RowRange a, RowRange b) { return a.count > 0 && b.count > 0 && a.first < b.end() && b.first < a.end(); }

bool meets(const Journal& journal, RowRange range) {
  return meet(journal.head.range, range) ||
         std::ranges::any_of(journal.claims, [&](const Claim& claim) { return meet(claim.rows, range); });
}

std::uint64_t rows_end(const Journal& journal) {
  std::uint64_t end = 0;
  for (const Claim& claim : journal.claims) end = std::max(end, claim.offset + claim.bytes);
  return end;
}

std::string journal_text(const Journal& journal) {
  std::string text = text_of(journal.head);
  for (const Claim& claim : journal.claims) text += text_of(claim);
  return text;
}

// Whether the description in a folder is that of a run; one that is damaged is not.
bool describes(const fs::path& product, const Identity& identity) try {
  return fs::exists(product) && differences(identity, "", load_product(product).identity, "").empty();
} catch (const core::InvalidRequest&) {
  return false;
}

// Who is dealt rows must find the journal of the one who deals them.
core::Problem not_shared(const fs::path& folder) {
  core::Problem problem = file_problem(folder.string(), "this process does not see what the first one has begun");
  problem.hint = "name a folder with --out that all machines share";
  return problem;
}

Journal read_again(const Journal& journal) {
  auto read = read_journal(journal.path);
  if (auto* problem = std::get_if<core::Problem>(&read)) throw core::InvalidRequest({std::move(*problem)});
  return std::move(std::get<Journal>(read));
}

}  // namespace

PartRun::PartRun(PartTask task, const core::WorkControl& control)
    : task_(std::move(task)), folder_(parts_folder_of(task_.output)) {
  enter();
  verify(control);
  missing_ = missing_rows(task_.range, journals_);
  writer_.emplace(rows_, journal_, places_, task_.pace);
}

const Journal* PartRun::own() const {
  const auto found = std::ranges::find(journals_, journal_path(), &Journal::path);
  return found == journals_.end() ? nullptr : &*found;
}

// Those whose rows are dealt never go on with an earlier journal; its rows are the dealer's concern.
void PartRun::choose_name() {
  if (!task_.dealt) return;
  const std::string base = task_.name;
  for (int number = 1; fs::exists(journal_path()); ++number) task_.name = fmt::format("{}-{}", base, number);
}

void PartRun::enter() {
  const core::RawFile door = open_door(folder_);
  choose_name();
  journals_ = read_journals(folder_);
  if (task_.anew && !task_.resume) forget_own(journals_);
  expect_same_run(journals_);
  const bool first = journals_.empty();
  if (task_.dealt && first) throw core::InvalidRequest({not_shared(folder_)});
  std::erase_if(journals_,
                [&](const Journal& journal) { return journal.path != journal_path() && !meets(journal, task_.range); });
  for (const Journal& journal : journals_) expect_free(journal);
  const auto places = row_places(folder_ / (task_.name + ".frame"), task_.product.product, task_.product.options);
  if (task_.product.estimate_lsb)
    store_ = RowStore::volts;
  else if (!places || task_.apart)
    store_ = RowStore::encoded;
  if (store_ == RowStore::placed) places_ = *places;
  task_.product.identity = task_.identity;
  if (first || !describes(product_file_of(folder_), task_.identity))
    store_product(product_file_of(folder_), task_.product);
  begin_rows(first);
  begin_journal();
}

// What an earlier process made of this very part; unless it is still at work.
void PartRun::forget_own(std::vector<Journal>& journals) const {
  std::erase_if(journals, [&](const Journal& journal) {
    if (journal.path != journal_path()) return false;
    core::RawFile file(journal.path, core::RawFile::Mode::write);
    if (!file.try_lock()) return false;
    file.unlink();
    return true;
  });
}

void PartRun::expect_same_run(const std::vector<Journal>& journals) const {
  core::Problems problems;
  for (const Journal& journal : journals) {
    for (const std::string& difference : differences(task_.identity, "now", journal.head.identity, "there"))
      problems.push_back(file_problem(journal.path.string(), "the journal belongs to another run: " + difference));
    if (problems.empty()) continue;
    problems.back().hint =
        fmt::format("run it as it was begun, or delete the folder {} to begin anew", folder_.string());
    throw core::InvalidRequest(std::move(problems));
  }
}

// A journal that concerns the part's rows must not belong to a process that lives. One that comes to life later finds
// this part at work, and is refused.
void PartRun::expect_free(const Journal& journal) {
  const bool own = journal.path == journal_path();
  core::Problem problem = file_problem(journal.path.string(), "");
  core::RawFile file(journal.path, core::RawFile::Mode::write);
  const std::string& part = journal.head.part;
  if (!file.try_lock()) {
    problem.message =
        own ? fmt::format("part {} is being made by another process ({})", part, journal.head.maker)
            : fmt::format("part {} overlaps part {}, which is being made ({})", task_.words, part, journal.head.maker);
    problem.hint = own ? "wait for it, or end it and continue with --resume"
                       : "wait for it, or choose parts that do not share pulses";
    throw core::RetryableError({problem});
  }
  if (!task_.resume) {
    const std::size_t rows = journal.claimed_rows();
    problem.message =
        own ? fmt::format("part {} was begun already: {} of its pulses are there", part, rows)
            : fmt::format("part {} overlaps part {}, of which {} pulses are there", task_.words, part, rows);
    problem.hint = fmt::format("continue with --resume, or delete the folder {} to begin anew", folder_.string());
    throw core::InvalidRequest({problem});
  }
  if (own) journal_ = core::JournalFile(std::move(file));
}

void PartRun::begin_journal() {
  if (own() != nullptr) {
    // What follows the last whole entry was being written when the process ended.
    journal_.cut(own()->bytes);
    return;
  }
  const JournalHead head{task_.identity, task_.words, task_.range, store_, maker_text()};
  const std::string text = text_of(head);
  journal_ = core::JournalFile(core::replace_file(journal_path(), std::as_bytes(std::span(text))));
  journals_.push_back({journal_path(), head, {}, text.size()});
}

// @param anew  nobody has any rows here
void PartRun::begin_rows(bool anew) {
  const Journal* earlier = own();
  if (earlier != nullptr && earlier->head.store != store_) {
    core::Problem problem = file_problem(journal_path().string(), "use of --part-file differs from the first run");
    problem.hint = fmt::format("go on as it was begun, or delete the folder {}", folder_.string());
    throw core::InvalidRequest({problem});
  }
  if (store_ != RowStore::placed) {
    rows_ = PlacedRows(rows_file_of(journal_path()), {}, core::RawFile::Mode::write);
    rows_.file().resize(earlier != nullptr ? rows_end(*earlier) : 0);
    return;
  }
  const fs::path shared = shared_rows_of(folder_);
  if (anew && fs::is_directory(fs::symlink_status(shared))) core::remove_folder(shared);
  rows_ = PlacedRows(shared, places_, core::RawFile::Mode::write);
  if (places_.piece_bytes > 0) return;  // Pieces are made as they are needed.
  const std::uint64_t bytes = places_.of(task_.product.product.rows);
  if (anew) rows_.file().resize(0);
  if (rows_.file().size() < bytes) rows_.file().allocate(bytes);
}

// What is vouched for must be there; entries that are not true are taken out.
void PartRun::verify(const core::WorkControl& control) {
  for (Journal& journal : journals_) {
    std::vector<Claim> claims;
    std::ranges::copy_if(journal.claims, std::back_inserter(claims),
                         [&](const Claim& claim) { return meet(claim.rows, task_.range); });
    std::vector<char> good(claims.size(), 1);
    core::parallel_ranges(claims.size(), 1, control, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) good[i] = holds(journal, claims[i], places_) ? 1 : 0;
    });
    std::vector<Claim> bad;
    for (std::size_t i = 0; i < claims.size(); ++i)
      if (good[i] == 0) bad.push_back(claims[i]);
    if (bad.empty()) continue;
    for (const Claim& claim : bad) rejected_rows_ += claim.rows.count;
    take_out(journal, bad);
  }
  for (Journal& journal : journals_) {
    journal = read_again(journal);
    std::ranges::copy_if(journal.claims, std::back_inserter(checked_),
                         [&](const Claim& claim) { return meet(claim.rows, task_.range); });
  }
}

// The one case in which a journal is not only added to: another one without these entries takes its place.
void PartRun::take_out(const Journal& journal, const std::vector<Claim>& bad) {
  const core::RawFile door = open_door(folder_);
  Journal now = read_again(journal);
  std::erase_if(now.claims, [&](const Claim& claim) {
    return std::ranges::any_of(bad, [&](const Claim& other) { return other.rows == claim.rows; });
  });
  const std::string text = journal_text(now);
  core::RawFile file = core::replace_file(now.path, std::as_bytes(std::span(text)));
  if (now.path == journal_path()) journal_ = core::JournalFile(std::move(file));
}

// The files of a part go when the recording is complete; otherwise somebody has taken them away.
void PartRun::expect_complete() const {
  const auto receipt = read_receipt(task_.output, task_.product);
  if (receipt && differences(task_.identity, "", receipt->identity, "").empty()) return;
  throw std::runtime_error(
      fmt::format("files of part {} were taken out of the folder {} while it was being made: its "
                  "pulses are lost. Make the part again.",
                  task_.words, folder_.string()));
}

PartOutcome PartRun::finish(bool replace, const RunControl& control) {
  writer_->settle();
  PartOutcome outcome;
  const core::RawFile door = open_door(folder_);
  if (!journal_.file().still_there() || !rows_.still_there()) {
    // The folder that the door has just been made in anew is empty.
    if (!fs::exists(product_file_of(folder_))) remove_parts(folder_);
    expect_complete();
    outcome.elsewhere = true;
    return outcome;
  }
  JoinTask join{task_.output, task_.product, read_journals(folder_), replace, checked_};
  std::ranges::copy(writer_->claims(), std::back_inserter(join.checked));
  const std::size_t rows = task_.product.product.rows;
  outcome.rows_there = rows;
  for (const RowRange& missing : missing_rows({0, rows}, join.journals)) outcome.rows_there -= missing.count;
  if (outcome.rows_there < rows || task_.apart) return outcome;
  if (core::Problems problems = join_problems(join.journals, rows); !problems.empty())
    throw core::InvalidRequest(std::move(problems));
  outcome.joined = join_parts(join, control);
  remove_parts(folder_);
  return outcome;
}

}  // namespace sarsim::raster
