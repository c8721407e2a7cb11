#include "workflow/sweep/sweep_files.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/report/refused.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// The first of all problems stands for the others.
class FirstProblem {
 public:
  FirstProblem(const SweepRequest& request, std::vector<fs::path> sources)
      : request_(request), sources_(std::move(sources)) {}

  void look_at(const fs::path& path, bool replace) {
    for (core::Problem& problem : problems_of_output(path, {sources_, replace, "", chosen_folder(request_.folder)})) {
      if (problems_.empty())
        problems_.push_back(std::move(problem));
      else
        ++more_;
    }
  }

  void refuse_any() && {
    if (problems_.empty()) return;
    core::Problem& first = problems_.front();
    if (more_ > 0) first.message = fmt::format("{}, and {} others", first.message, more_);
    if (!request_.force)
      first.hint = request_.resume
                       ? "it is not what this sweep would have made, or was changed since; replace with --force, or "
                         "choose another folder with --out"
                       : "replace with --force, go on with what is not done with --resume, or choose another folder "
                         "with --out";
    throw core::Refused(std::move(problems_));
  }

 private:
  const SweepRequest& request_;
  std::vector<fs::path> sources_;
  core::Problems problems_;
  std::size_t more_ = 0;
};

}  // namespace

SweepFiles::SweepFiles(const SweepRequest& request)
    : folder_(request.folder), stem_(request.table.empty() ? "sweep" : safe_word(request.table)), part_stem_(stem_) {
  const SweepPart& part = request.part;
  if (part.count > 1) part_stem_ = fmt::format("{}-{}-of-{}", stem_, part.index + 1, part.count);
}

void expect_free_files(const SweepRequest& request, const Sweep& sweep, const std::vector<SweepRow>& rows) {
  expect_output_folder(request.folder);
  const SweepFiles files(request);
  std::vector<fs::path> sources = request.sources;
  std::ranges::move(sweep.sources(), std::back_inserter(sources));
  FirstProblem problem(request, std::move(sources));
  for (const SweepRow& row : rows)
    if (!row.done && !row.recorded && !request.discard) {
      problem.look_at(files.beside(row.file), request.force);
      if (row.table) continue;
      for (const fs::path& path : files_of(request.follow_up, files.beside(fs::path(row.file).stem().string())))
        problem.look_at(path, request.force);
    }
  for (const char* extension : {".csv", ".json", ".journal"}) {
    const fs::path path = files.of_part(extension);
    if (!request.discard &&
        std::ranges::any_of(rows, [&](const SweepRow& row) { return files.beside(row.file) == path; }))
      throw core::Refused("'" + path.string() + "' is the name of a variation's file and of a table of the sweep",
                          "give the table another name with --table");
    problem.look_at(path, request.force || request.resume);
  }
  std::move(problem).refuse_any();
}

}  // namespace sarsim::workflow
