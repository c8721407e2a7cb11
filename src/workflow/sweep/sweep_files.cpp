#include "workflow/sweep/sweep_files.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/os/file_identity.hpp"
#include "core/os/input_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/counted.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/sweep/sweep_journal.hpp"
#include "workflow/sweep/sweep_table.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Whether an earlier sweep wrote a table, or nothing is lost with it.
bool is_own_table(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(path, none)) return true;
  constexpr std::size_t enough = 1'000'000;
  const std::string beginning = core::beginning_of(path, enough);
  if (beginning.empty()) return fs::is_regular_file(path, none) && fs::is_empty(path, none);
  return path.extension() == ".json" ? begins_as_sweep_json(beginning) : begins_as_sweep_csv(beginning);
}

// Looks at outputs; the first of all problems stands for the others.
class OutputWatch {
 public:
  OutputWatch(const SweepRequest& request, InputList sources) : request_(request), sources_(std::move(sources)) {}

  // A file that is made; `replace`: it may be there already.
  void look_at(const fs::path& path, bool replace) {
    std::error_code none;
    const std::string remove = "remove the link, or choose another folder with --out";
    if (core::Problems never = problems_of_output(path, care(true)); !never.empty())
      return add(std::move(never.front()));
    if (fs::is_symlink(fs::symlink_status(path, none)))
      return add(core::error("a link has the name of a file that the sweep makes").found(path.string()).hint(remove));
    if (const fs::path other = taken_by(path); !other.empty())
      return add(core::error(fmt::format("this file and '{}' are one file", other.string()))
                     .found(path.string())
                     .hint(remove));
    if (replace) return;
    for (core::Problem& exists : problems_of_output(path, care(false))) {
      exists.hint = request_.resume
                        ? "it is not what this sweep would have made, or was changed since; replace with --force, or "
                          "choose another folder with --out"
                        : "replace with --force, go on with what is not done with --resume, or choose another folder "
                          "with --out";
      add(std::move(exists));
    }
  }

  // The tables and the journal, which a resumed sweep makes anew and goes on with where they are its own.
  void look_at_own(const fs::path& path, bool own) {
    look_at(path, request_.force || request_.resume);
    if (request_.resume && !request_.force && !own)
      add(core::error("--resume leaves this file alone: no sweep wrote it")
              .found(path.string())
              .hint("replace it with --force, or give the tables and the journal another name with --table"));
  }

  // A file that is there and stays.
  void keep(const fs::path& path) { static_cast<void>(taken_by(path)); }

  void refuse_any() && {
    if (problems_.empty()) return;
    if (more_ > 0) problems_.front().message += fmt::format(", and {}", core::counted(more_, "other"));
    throw core::InvalidRequest(std::move(problems_));
  }

 private:
  [[nodiscard]] OutputCare care(bool force) const { return {sources_, force, "", chosen_folder(request_.folder)}; }

  // Another output that is the same file, where there is one.
  fs::path taken_by(const fs::path& path) {
    const auto identity = core::identity_of_file(path);
    if (!identity) return {};
    const auto [known, is_new] = taken_.emplace(*identity, path);
    return is_new ? fs::path() : known->second;
  }

  void add(core::Problem problem) {
    if (problems_.empty())
      problems_.push_back(std::move(problem));
    else
      ++more_;
  }

  const SweepRequest& request_;
  InputList sources_;
  std::map<core::FileIdentity, fs::path> taken_;
  core::Problems problems_;
  std::size_t more_ = 0;
};

// The files of a row that are made, and those that stay.
void look_at_row(const SweepRequest& request, const SweepFiles& files, const SweepRow& row, OutputWatch& watch) {
  if (row.done || row.recorded)
    watch.keep(files.beside(row.file));
  else
    watch.look_at(files.beside(row.file), request.force || row.begun);
  if (row.done || row.table) return;
  // What a follow-up left of a recording that is kept is made anew.
  for (const fs::path& path : files_of(request.post_processing, files.beside(fs::path(row.file).stem().string())))
    watch.look_at(path, request.force || row.recorded);
}

}  // namespace

SweepFiles::SweepFiles(const SweepRequest& request)
    : folder_(request.folder), stem_(request.table.empty() ? "sweep" : safe_word(request.table)), part_stem_(stem_) {
  const SweepPart& part = request.part;
  if (part.count > 1) part_stem_ = fmt::format("{}-{}-of-{}", stem_, part.index + 1, part.count);
}

void expect_free_files(const SweepRequest& request, const Sweep& sweep, const std::vector<SweepRow>& rows) {
  expect_output_folder(request.folder);
  const SweepFiles files(request);
  InputList sources = request.sources;
  sources.add(sweep.sources());
  sources.add(files_read_by(request.post_processing));
  OutputWatch watch(request, std::move(sources));
  if (!request.discard)
    for (const SweepRow& row : rows) look_at_row(request, files, row, watch);
  for (const char* extension : {".csv", ".json", ".journal"}) {
    const fs::path path = files.of_part(extension);
    if (!request.discard &&
        std::ranges::any_of(rows, [&](const SweepRow& row) { return files.beside(row.file) == path; }))
      throw core::InvalidRequest(
          "'" + path.string() + "' is the name of a variation's file and of a table of the sweep",
          "give the table another name with --table");
    const bool journal = path.extension() == ".journal";
    watch.look_at_own(path, journal ? takes_journal_lines(path) : is_own_table(path));
  }
  std::move(watch).refuse_any();
}

}  // namespace sarsim::workflow
