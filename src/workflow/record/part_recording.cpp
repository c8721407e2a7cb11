#include "workflow/record/part_recording.hpp"

#include <memory>

#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/task/deferred_signal.hpp"
#include "raster/format/sinks.hpp"
#include "raster/format/zarr_store.hpp"
#include "simulate/run/memory_sink.hpp"

namespace sarsim::workflow {

namespace {

// What encodes the rows of a part: as the file will hold them, or as volts that somebody converts later.
class PartEncoder {
 public:
  explicit PartEncoder(const raster::StoredProduct& stored)
      : final_(stored.estimate_lsb ? nullptr : raster::make_discarding_sink(stored.product, stored.options)) {}

  [[nodiscard]] const raster::Sink& sink() const {
    if (final_) return *final_;
    return volts_;
  }

 private:
  std::unique_ptr<raster::Sink> final_;
  simulate::Recording unused_;
  simulate::MemorySink volts_{unused_};
};

// One share on its way.
class PartMaker {
 public:
  PartMaker(const PartJob& job, const PartWorkshop& workshop) : job_(job), workshop_(workshop) {}

  PartReport make() {
    const double begin_s = core::now_s();
    result_.file = job_.output.string();
    result_.part = words_of(job_.choice);
    result_.rows = job_.plan.acquisition.timing.rows;
    result_.own_file = job_.choice.own_file;
    result_.range = rows_of(job_.choice, job_.plan.acquisition.timing.rows,
                            raster::piece_rows(job_.product.product, job_.product.options));
    if (result_.range.count == 0) return result_;
    together([&] { expect_alike(); });
    together([&] {
      if (leads()) find_finished();
    });
    if (!done_already()) {
      // The leader makes sure of what is there before the others come in.
      together([&] {
        if (leads()) enter();
      });
      together([&] {
        if (!leads()) enter();
      });
      compute();
      together([&] { result_.journal_seconds = part_->writer().settling_s(); });
      result_.journal_entries = part_->writer().claims().size();
      together([&] {
        if (leads()) finish();
      });
    }
    result_.seconds = core::now_s() - begin_s;
    return result_;
  }

 private:
  [[nodiscard]] bool leads() const { return workshop_.team == nullptr || workshop_.team->leads(); }

  template <class Step>
  void together(const Step& step) {
    take_together(workshop_.team, step);
  }

  [[nodiscard]] std::string from_leader(const std::string& text) {
    return workshop_.team == nullptr ? text : workshop_.team->from_leader(text);
  }

  // Processes on different machines must mean the same.
  void expect_alike() {
    raster::JournalHead head;
    head.identity = job_.identity;
    const auto leaders = raster::parse_journal("the leader", from_leader(raster::text_of(head)));
    core::Problems problems;
    for (const std::string& difference : raster::differences(
             job_.identity, "on " + process_name(), std::get<raster::Journal>(leaders).head.identity, "on the first"))
      problems.push_back(
          problem("the processes differ: " + difference).hint("give all of them the same files and options"));
    if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  }

  [[nodiscard]] std::string process_name() const { return workshop_.team == nullptr ? "" : workshop_.team->name(); }

  [[nodiscard]] bool done_already() {
    const std::string word = from_leader(result_.finished_before ? "finished" : "to do");
    result_.finished_before = word == "finished";
    return result_.finished_before;
  }

  // With --resume, a recording that its receipt knows needs nothing more.
  void find_finished() {
    std::error_code ignored;
    if (!std::filesystem::exists(job_.output, ignored)) return;
    if (!std::filesystem::is_regular_file(job_.output, ignored) && !raster::is_own_zarr_store(job_.output))
      throw core::InvalidRequest(
          {problem("parts can only become a file").hint("run without --part, --pulses and --resume")});
    const auto receipt = raster::read_receipt(job_.output, job_.product);
    if (!job_.choice.resume || !receipt) {
      if (job_.force) return;
      throw core::InvalidRequest(
          {problem("the output exists already").hint("replace it with --force, or choose another folder with --out")});
    }
    const auto changes = raster::differences(job_.identity, "now", receipt->identity, "in the file");
    if (changes.empty()) {
      result_.finished_before = true;
      result_.there = job_.plan.acquisition.timing.rows;
      result_.whole = receipt->report;
      raster::remove_parts(raster::parts_folder_of(job_.output));
      return;
    }
    if (job_.force) return;
    core::Problems problems;
    for (const std::string& change : changes)
      problems.push_back(problem("the output is finished, but of another run: " + change)
                             .hint("replace it with --force, or choose another folder with --out"));
    throw core::InvalidRequest(std::move(problems));
  }

  [[nodiscard]] core::ProblemBuilder problem(std::string message) const {
    return core::error(std::move(message)).found(job_.output.string());
  }

  [[nodiscard]] raster::PartTask task() const {
    raster::PartTask task;
    task.output = job_.output;
    task.name = file_name_of(job_.choice);
    task.words = words_of(job_.choice);
    task.range = result_.range;
    task.apart = job_.choice.own_file;
    task.resume = job_.choice.resume;
    task.anew = job_.force;
    task.identity = job_.identity;
    task.product = job_.product;
    // Who asks for a pace gets it, whatever the disk says.
    if (job_.choice.save_every_s) task.pace = {*job_.choice.save_every_s, 0.5};
    if (leads()) return task;
    task.name = workshop_.team->name();
    task.words = task.name;
    task.range = {};
    task.dealt = true;
    return task;
  }

  [[nodiscard]] core::WorkControl work() const { return workshop_.observer.control(workshop_.threads); }

  void enter() {
    if (job_.output.has_parent_path()) std::filesystem::create_directories(job_.output.parent_path());
    part_.emplace(task(), work());
    result_.rejected = part_->rejected_rows();
    if (result_.rejected > 0 && workshop_.events.rejected) workshop_.events.rejected(job_.output, result_.rejected);
  }

  void compute() {
    const PartEncoder encoder(job_.product);
    try {
      const core::ProgressReport display = workshop_.observer.stage(label());
      std::size_t total = 0;
      for (const raster::RowRange& range : part_->missing()) total += range.count;
      const auto show = [&](std::size_t done) {
        if (total > 0 && display) display({done, total, job_.plan.acquisition.reception.columns});
      };
      if (workshop_.team == nullptr) {
        for (const raster::RowRange& range : part_->missing()) make_rows(range, encoder, show);
      } else {
        workshop_.team->deal(
            part_->missing(), [&](raster::RowRange range) { make_rows(range, encoder, {}); },
            [&](const core::Progress& progress) { show(progress.done); });
        result_.made = total;
      }
      part_->writer().settle();
    } catch (const core::Interrupted&) {
      keep();
      throw;
    } catch (const std::exception&) {
      keep();
      if (workshop_.events.kept) workshop_.events.kept(job_.output, raster::parts_folder_of(job_.output));
      throw;
    }
  }

  void make_rows(raster::RowRange range, const PartEncoder& encoder, const std::function<void(std::size_t)>& progress) {
    const std::size_t before = result_.made;
    const double lsb_v = job_.product.estimate_lsb ? 0.0 : job_.plan.acquisition.simulation.lsb_v;
    const raster::RunControl control{workshop_.threads, workshop_.observer.stop, [&](const core::Progress& p) {
                                       result_.made = before + p.done;
                                       if (progress) progress(result_.made);
                                     }};
    simulate::run_rows(job_.plan, range, lsb_v, encoder.sink(), control,
                       [&](const raster::EncodedRows& rows) { part_->writer().take(rows); });
  }

  // Something ends the work early: what is done shall stay.
  void keep() {
    try {
      part_->writer().settle();
    } catch (const std::exception&) {
      // What the journal does not vouch for is computed again.
    }
  }

  void finish() {
    result_.journal_seconds = part_->writer().settling_s();
    const raster::RunControl control{workshop_.threads, workshop_.observer.stop,
                                     workshop_.observer.stage(job_.output.string() + " (joining its parts)")};
    const raster::PartOutcome outcome = part_->finish(job_.force, control);
    result_.there = outcome.rows_there;
    result_.elsewhere = outcome.elsewhere;
    if (outcome.joined) result_.whole = outcome.joined->report;
  }

  [[nodiscard]] std::string label() const {
    const std::string words = words_of(job_.choice);
    return job_.output.string() + (words == "1/1" ? "" : " (" + words + ")");
  }

  const PartJob& job_;
  const PartWorkshop& workshop_;
  PartReport result_;
  std::optional<raster::PartRun> part_;
};

}  // namespace

PartReport make_part(const PartJob& job, const PartWorkshop& workshop) {
  try {
    return PartMaker(job, workshop).make();
  } catch (const core::Interrupted&) {
    throw core::DeferredSignal(raster::parts_folder_of(job.output).string());
  }
}

}  // namespace sarsim::workflow
