#include "workflow/sweep/sweep.hpp"

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <future>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/os/disk_room.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/counted.hpp"
#include "workflow/sweep/sweep_causes.hpp"
#include "workflow/sweep/sweep_files.hpp"
#include "workflow/sweep/sweep_journal.hpp"
#include "workflow/sweep/sweep_run.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// Counts what several threads finish and tells it on the thread that waits for them.
class FinishedCount {
 public:
  // Runs `work` on another thread, which may call `add`, and calls `tell` with each count until it has ended. Throws
  // what it throws.
  void watch(const std::function<void()>& work, const std::function<void(std::size_t)>& tell) {
    std::future<void> end = std::async(std::launch::async, [&] {
      const struct Ending {
        FinishedCount& count;
        ~Ending() { count.close(); }
      } ending{*this};
      work();
    });
    for (std::size_t told = 0; wait_for_more_than(told);) tell(++told);
    end.get();
  }

  void add() {
    {
      const std::scoped_lock hold(lock_);
      ++finished_;
    }
    news_.notify_one();
  }

  [[nodiscard]] std::size_t finished() {
    const std::scoped_lock hold(lock_);
    return finished_;
  }

 private:
  void close() {
    {
      const std::scoped_lock hold(lock_);
      ended_ = true;
    }
    news_.notify_one();
  }

  bool wait_for_more_than(std::size_t told) {
    std::unique_lock hold(lock_);
    news_.wait(hold, [&] { return ended_ || finished_ > told; });
    return finished_ > told;
  }

  std::mutex lock_;
  std::condition_variable news_;
  std::size_t finished_ = 0;
  bool ended_ = false;
};

void write_whole(const fs::path& path, const std::string& text, bool replace) {
  core::OutputFile file(path, replace);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

std::size_t mean_samples(const SweepPlan& plan) {
  double samples = 0.0;
  for (const auto& sizes : plan.checks.sizes)
    for (const ProductSize& size : sizes) samples += static_cast<double>(size.rows) * static_cast<double>(size.columns);
  return static_cast<std::size_t>(samples / static_cast<double>(std::max<std::size_t>(plan.open.size(), 1)));
}

// A folder for temporary files, gone with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "sarsim-sweep-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(),
                              fmt::format("cannot make a folder for temporary files '{}'", name));
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Goes on with the journal of an earlier sweep; whatever else has its name is only there where it may be replaced.
SweepJournal journal_of(const SweepRequest& request) {
  const fs::path path = SweepFiles(request).of_part(".journal");
  return {path, request.resume && takes_journal_lines(path)};
}

// The variations of a plan at work.
class SweepRunner {
 public:
  SweepRunner(const SweepRequest& request, SweepPlan& plan, const core::Observer& observer)
      : request_(request),
        plan_(plan),
        observer_(observer),
        rules_(variation_rules(request)),
        journal_(journal_of(request)) {
    rules_.threads = plan.threads;
    rules_.begin = [this](const SweepRow& row) { journal_.add_begun(row); };
    rules_.jobs = plan.jobs;
    if (request.discard && request.post_processing) {
      scratch_.emplace();
      rules_.post_processing_folder = scratch_->path();
    }
  }

  void run() {
    const std::size_t samples = mean_samples(plan_);
    const auto tell = [&, stage = observer_.stage("sweep")](std::size_t finished) {
      if (stage) stage({finished, plan_.open.size(), samples});
    };
    tell(0);
    try {
      finished_.watch([this] { make_variations(); }, tell);
    } catch (const core::Interrupted&) {
      const std::size_t before = plan_.variations.size() - plan_.open.size();
      observer_.announces(fmt::format("sweep: {} of {} done; continue with --resume", before + finished_.finished(),
                                      core::counted(plan_.variations.size(), "variation")));
      throw;
    }
    core::Problems remarks = remarks_.problems(plan_.sweep, plan_.open.size());
    std::erase_if(remarks, [this](const core::Problem& remark) {
      return std::ranges::find(plan_.checks.problems, remark.message, &core::Problem::message) !=
             plan_.checks.problems.end();  // Was told before the first variation.
    });
    observer_.remarks(shortened(std::move(remarks)));
  }

 private:
  void make_variations() {
    core::parallel_ranges(plan_.open.size(), 1, observer_.control(plan_.jobs), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) make_variation(plan_.open[i]);
      finished_.add();
    });
  }

  void make_variation(std::size_t variation) {
    const std::size_t products = plan_.products.size();
    const std::size_t place = (variation - request_.part.index) / request_.part.count;
    std::vector<SweepRow*> rows;
    for (SweepRow& row : std::span(plan_.rows).subspan(place * products, products))
      if (!row.done) rows.push_back(&row);
    core::Problems none;  // The plan is sound; only a text that changed since could say something.
    const auto note = [this](const SweepRow& row) {
      if (row.done) journal_.add(row);
    };
    const scene::Scene scene = plan_.sweep.scene(request_.scene, variation, none, observer_.stop);
    if (!none.empty()) throw core::InvalidRequest(std::move(none));
    SweptScene swept{scene, {request_.script, {}, {}, request_.overrides, {}, request_.held}};
    plan_.sweep.add_to(swept.source.overrides, variation);
    remarks_.add(variation, 1, run_variation(swept, plan_.products, rows, rules_, observer_.stop, note));
  }

  const SweepRequest& request_;
  SweepPlan& plan_;
  const core::Observer& observer_;
  VariationRules rules_;
  SweepJournal journal_;
  std::optional<ScratchFolder> scratch_;  // Of images that are measured and then of no use.
  Causes remarks_;                        // Of follow-ups.
  FinishedCount finished_;
};

core::Problems failures_of(const SweepPlan& plan) {
  core::Problems failures;
  for (const SweepRow& row : plan.rows) {
    if (row.failure.empty()) continue;
    failures.push_back({});
    failures.back().message = fmt::format("{}: {}", plan.sweep.label(row.variation), row.failure);
  }
  return failures;
}

}  // namespace

SweepReport run_sweep(const SweepRequest& request, SweepPlan plan, const core::Observer& observer) {
  expect_nobody_at_work(request.folder, SweepFiles(request).stem(), request.part);
  take_finished(request, plan.rows);  // Another process may have made some since the plan was made.
  expect_free_files(request, plan.sweep, plan.rows);
  if (!request.discard)
    core::expect_room(request.folder, sum_of(plan.checks, &ProductSize::min_bytes),
                      "choose another folder with --out, or keep the tables alone with --discard");
  observer.announces(announcement(request, plan));
  const double begin_s = core::now_s();
  fs::create_directories(request.folder);
  SweepRunner(request, plan, observer).run();
  SweepReport report{std::move(plan), {}, SweepFiles(request).of_part(".csv"), 0.0};
  report.failures = failures_of(report.plan);
  const SweepFrame frame = frame_of(request, report.plan, report.status());
  const bool replace = request.force || request.resume;
  write_whole(report.table, sweep_csv(frame, report.plan.rows), replace);
  write_whole(SweepFiles(request).of_part(".json"), sweep_json(frame, report.plan.rows), replace);
  report.seconds = core::now_s() - begin_s;
  return report;
}

SweepReport sweep(const SweepRequest& request, const core::Observer& observer) {
  SweepPlan plan = plan_sweep(request, observer);
  expect_sound(plan);
  return run_sweep(request, std::move(plan), observer);
}

}  // namespace sarsim::workflow
