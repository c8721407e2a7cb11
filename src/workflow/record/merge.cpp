#include "workflow/record/merge.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/os/raw_file.hpp"
#include "core/report/retryable.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/sinks.hpp"
#include "raster/parts/join_parts.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/record/side_files.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view parts_extension = ".parts";

// The parts of one recording, from folders to its file.
class Merger {
 public:
  Merger(const MergeRequest& request, const core::Observer& observer) : request_(request), observer_(observer) {}

  MergeReport run() {
    raster::JoinTask task;
    task.output = output();
    task.replace = request_.force;
    for (const std::string& folder : request_.folders) expect_outside(task.output, folder);
    if (is_done(task.output)) {
      RecordingReport report;
      report.file = task.output.string();
      return {std::move(report), true};
    }
    if (auto before = joined_before(task)) return {*std::move(before)};
    const std::vector<fs::path> folders(request_.folders.begin(), request_.folders.end());
    expect_free_outputs({task.output}, {folders, request_.force, "-o"});
    if (core::Problems problems = problems_of_side_files(task.output); !problems.empty())
      throw core::InvalidRequest(std::move(problems));
    for (const std::string& folder : request_.folders) collect(folder, task.journals);
    const fs::path product = raster::product_file_of(request_.folders.front());
    task.product = raster::load_product(product);
    if (core::Problems problems = raster::product_problems(task.product, product, task.journals.front());
        !problems.empty())
      throw core::InvalidRequest(std::move(problems));
    if (core::Problems problems = raster::join_problems(task.journals, task.product.product.rows); !problems.empty())
      throw core::InvalidRequest(std::move(problems));
    return {joined(task)};
  }

 private:
  [[nodiscard]] fs::path output() const {
    if (!request_.output.empty()) return request_.output;
    const fs::path folder = fs::path(request_.folders.front() + "/").parent_path();
    if (folder.extension() != parts_extension)
      throw core::InvalidRequest("'" + request_.folders.front() + "' is not a folder of parts",
                                 "such a folder is called NAME.parts; for another one give the output with -o");
    return fs::path(folder).replace_extension();
  }

  // In there the output would be taken for a part, or take the place of one, and go with the parts.
  static void expect_outside(const fs::path& output, const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    const fs::path inside = fs::canonical(folder);
    const fs::path place = fs::weakly_canonical(fs::absolute(core::end_of_links(output)));
    if (std::mismatch(inside.begin(), inside.end(), place.begin(), place.end()).first == inside.end())
      throw core::InvalidRequest(
          fmt::format("the output '{}' is in the folder of parts '{}'", output.string(), folder.string()),
          "choose another place with -o");
  }

  void collect(const std::string& folder, std::vector<raster::Journal>& journals) {
    if (!fs::is_directory(folder))
      throw core::InvalidRequest("there is no folder '" + folder + "'",
                                 "parts are in the folder NAME.parts beside their output");
    const std::size_t before = journals.size();
    enter(folder, journals);
    if (journals.size() == before)
      throw core::InvalidRequest("the folder '" + folder + "' holds no parts", "it has no journals");
  }

  // Nobody may be at work on the parts while they are joined. Who holds the door lets nobody in, which takes one open
  // file for a folder with however many parts.
  void enter(const std::string& folder, std::vector<raster::Journal>& journals) {
    close_door(folder);
    for (raster::Journal& journal : raster::read_journals(folder)) {
      if (!opened(journal.path).try_lock())
        throw core::RetryableError(
            fmt::format("part {} is still being made ({})", journal.head.part, journal.head.maker),
            "wait for it: the last part to finish completes the file");
      journals.push_back(std::move(journal));
    }
  }

  // Network file systems only lock what is open for writing; what is not ours to write is looked at without.
  static core::RawFile opened(const fs::path& path) {
    try {
      return {path, core::RawFile::Mode::write};
    } catch (const std::system_error&) {
      return {path, core::RawFile::Mode::read};
    }
  }

  // Folders of parts that were copied may have none.
  void close_door(const fs::path& folder) {
    for (const fs::path& other : closed_)
      if (fs::equivalent(folder, other))
        throw core::InvalidRequest("the folder '" + folder.string() + "' is named twice", "name each folder once");
    closed_.push_back(folder);
    if (!fs::exists(folder / "lock")) return;
    doors_.push_back(opened(folder / "lock"));
    doors_.back().lock();
  }

  // A merge that is repeated after it ended has nothing left to join.
  [[nodiscard]] bool is_done(const fs::path& output) const {
    const auto gone = [](const std::string& folder) { return !fs::exists(fs::symlink_status(folder)); };
    return std::ranges::all_of(request_.folders, gone) && raster::is_finished(output);
  }

  // A process that was killed after it gave the output its name has left parts whose rows are in the output now: all
  // of them, or what it had not removed yet.
  [[nodiscard]] std::optional<RecordingReport> joined_before(raster::JoinTask task) {
    if (!fs::exists(task.output) || !fs::exists(raster::receipt_of(task.output))) return std::nullopt;
    std::vector<std::string> left;
    for (const std::string& folder : request_.folders)
      if (fs::is_directory(folder)) left.push_back(folder);
    const auto described = std::ranges::find_if(
        left, [](const std::string& folder) { return fs::exists(raster::product_file_of(folder)); });
    if (described == left.end()) return std::nullopt;
    task.product = raster::load_product(raster::product_file_of(*described));
    for (const std::string& folder : left)
      std::ranges::move(raster::read_journals(folder), back_inserter(task.journals));
    const auto receipt = raster::read_receipt(task.output, task.product);
    if (!receipt || !is_of(*receipt, task) || !(request_.remove || gave_its_rows(task))) return std::nullopt;
    task.journals.clear();
    for (const std::string& folder : left) enter(folder, task.journals);
    clear(task);
    return report_of(task, receipt->report);
  }

  static bool is_of(const raster::Receipt& receipt, const raster::JoinTask& task) {
    const auto same = [&](const raster::Identity& other) {
      return raster::differences(receipt.identity, "", other, "").empty();
    };
    return same(task.product.identity) && std::ranges::all_of(task.journals, [&](const raster::Journal& journal) {
             return same(journal.head.identity);
           });
  }

  // Whether the shared file of rows at their places has become the output.
  [[nodiscard]] bool gave_its_rows(const raster::JoinTask& task) const {
    const fs::path own = raster::parts_folder_of(task.output);
    std::error_code ignored;
    return request_.folders.size() == 1 && fs::equivalent(own, request_.folders.front(), ignored) &&
           !fs::exists(raster::shared_rows_of(own)) && placed(task);
  }

  [[nodiscard]] RecordingReport joined(const raster::JoinTask& task) {
    // Whatever a process leaves that is killed from here on stands in a folder that has a door.
    const fs::path own = raster::parts_folder_of(task.output);
    const bool entered = std::ranges::any_of(closed_, [&](const fs::path& folder) {
      std::error_code missing;
      return fs::equivalent(own, folder, missing);
    });
    try {
      if (!entered) doors_.push_back(raster::open_door(own));
      const raster::RunReport run = raster::join_parts(task, {core::thread_count(request_.threads), observer_.stop,
                                                              observer_.stage(task.output.string())})
                                        .report;
      clear(task);
      return report_of(task, run);
    } catch (...) {
      raster::remove_joins(own);
      throw;
    }
  }

  [[nodiscard]] RecordingReport report_of(const raster::JoinTask& task, const raster::RunReport& run) const {
    RecordingReport report;
    report.run = run;
    const raster::Product& product = task.product.product;
    report.file = task.output.string();
    report.simulation.format = task.product.options.format;
    report.simulation.processing = product.processing;
    report.simulation.radar = product.radar;
    report.simulation.bits = product.bits;
    report.simulation.lsb_v = product.lsb_v;
    report.options = product.options;
    report.engine = product.engine;
    report.engine_reason = task.product.engine_reason;
    report.counts =
        task.product.estimate_lsb || raster::holds_counts(task.product.options.format, task.product.options.counts);
    report.bytes = static_cast<double>(raster::stored_bytes(task.output));
    report.seconds = report.run.seconds;
    return report;
  }

  // Rows that stood at their places have become the output: what is left of their folder is of no use.
  void clear(const raster::JoinTask& task) {
    const fs::path own = raster::parts_folder_of(task.output);
    raster::remove_joins(own);
    doors_.clear();
    for (const std::string& folder : request_.folders)
      if (request_.remove || (fs::exists(own) && fs::equivalent(folder, own) &&
                              !fs::exists(raster::shared_rows_of(folder)) && placed(task)))
        raster::remove_parts(folder);
  }

  static bool placed(const raster::JoinTask& task) {
    for (const raster::Journal& journal : task.journals)
      if (journal.head.store == raster::RowStore::placed) return true;
    return false;
  }

  const MergeRequest& request_;
  const core::Observer& observer_;
  std::vector<fs::path> closed_;  // Folders whose doors are held.
  std::vector<core::RawFile> doors_;
};

}  // namespace

MergeReport merge(const MergeRequest& request, const core::Observer& observer) {
  return Merger(request, observer).run();
}

}  // namespace sarsim::workflow
