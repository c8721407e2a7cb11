#include "cli/command/part_recording.hpp"

#include <memory>

#include <fmt/format.h>

#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "simulate/run/memory_sink.hpp"

namespace sarsim::cli {

namespace {

// What encodes the rows of a part: as the file will hold them, or as volts that somebody converts later.
class PartEncoder {
 public:
  explicit PartEncoder(const raster::StoredProduct& stored)
      : final_(stored.estimate_lsb ? nullptr : raster::make_discarding_sink(stored.product, stored.options)) {}

  [[nodiscard]] const simulate::Sink& sink() const {
    if (final_) return *final_;
    return volts_;
  }

 private:
  std::unique_ptr<simulate::Sink> final_;
  simulate::Recording unused_;
  simulate::MemorySink volts_{unused_};
};

// One share on its way.
class PartMaker {
 public:
  PartMaker(const PartJob& job, const PartWorkshop& workshop) : job_(job), workshop_(workshop) {}

  PartResult make() {
    const double begin_s = core::now_s();
    result_.range = rows_of(job_.choice, job_.plan.rows);
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

  // A step that all processes take, or none.
  template <class Step>
  void together(const Step& step) {
    try {
      step();
    } catch (const raster::UnfitParts& unfit) {
      static_cast<void>(tell_others(false));
      throw core::Refused(unfit.problems);
    } catch (...) {
      static_cast<void>(tell_others(false));
      throw;
    }
    if (!tell_others(true)) throw core::Refused(core::Problems());  // Who is not well says why.
  }

  [[nodiscard]] bool tell_others(bool well) { return workshop_.team == nullptr || workshop_.team->all_well(well); }

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
      problems.push_back(problem("the processes differ: " + difference, "give all of them the same files and options"));
    if (!problems.empty()) throw core::Refused(std::move(problems));
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
    if (!std::filesystem::is_regular_file(job_.output, ignored))
      throw core::Refused({problem("parts can only become a file", "run without --part, --pulses and --resume")});
    const auto receipt = raster::read_receipt(job_.output, job_.product);
    if (!job_.choice.resume || !receipt) {
      if (job_.force) return;
      throw core::Refused(
          {problem("the output exists already", "replace it with --force, or choose another folder with --out")});
    }
    const auto changes = raster::differences(job_.identity, "now", receipt->identity, "in the file");
    if (changes.empty()) {
      result_.finished_before = true;
      result_.there = job_.plan.rows;
      result_.whole = receipt->report;
      raster::remove_parts(raster::parts_folder_of(job_.output));
      return;
    }
    if (job_.force) return;
    core::Problems problems;
    for (const std::string& change : changes)
      problems.push_back(problem("the output is finished, but of another run: " + change,
                                 "replace it with --force, or choose another folder with --out"));
    throw core::Refused(std::move(problems));
  }

  [[nodiscard]] core::Problem problem(std::string message, std::string hint) const {
    core::Problem p;
    p.message = std::move(message);
    p.found = job_.output.string();
    p.hint = std::move(hint);
    return p;
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

  [[nodiscard]] core::WorkControl work() const { return {workshop_.threads, workshop_.streams.stop}; }

  void enter() {
    if (job_.output.has_parent_path()) std::filesystem::create_directories(job_.output.parent_path());
    part_.emplace(task(), work());
    result_.rejected = part_->rejected_rows();
    if (result_.rejected > 0)
      workshop_.streams.err << fmt::format("{}: {} pulses are not as the journal says; they are computed again\n",
                                           job_.output.string(), result_.rejected);
  }

  void compute() {
    const PartEncoder encoder(job_.product);
    try {
      ProgressDisplay display(workshop_.streams.err, workshop_.style, label());
      std::size_t total = 0;
      for (const simulate::RowRange& range : part_->missing()) total += range.count;
      const auto show = [&](std::size_t done) {
        if (total > 0) display.update({done, total, job_.plan.columns});
      };
      if (workshop_.team == nullptr) {
        for (const simulate::RowRange& range : part_->missing()) make_rows(range, encoder, show);
      } else {
        workshop_.team->deal(
            part_->missing(), [&](simulate::RowRange range) { make_rows(range, encoder, {}); },
            [&](const core::Progress& progress) { show(progress.done); });
        result_.made = total;
      }
      part_->writer().settle();
    } catch (const core::Interrupted&) {
      keep();
      throw;
    } catch (const std::exception&) {
      keep();
      workshop_.streams.err << fmt::format("{}: what is done is kept in {}; go on with --resume\n",
                                           job_.output.string(), raster::parts_folder_of(job_.output).string());
      throw;
    }
  }

  void make_rows(simulate::RowRange range, const PartEncoder& encoder,
                 const std::function<void(std::size_t)>& progress) {
    const std::size_t before = result_.made;
    const double lsb_v = job_.product.estimate_lsb ? 0.0 : job_.plan.simulation.lsb_v;
    const simulate::RunControl control{workshop_.threads, workshop_.streams.stop, [&](const core::Progress& p) {
                                         result_.made = before + p.done;
                                         if (progress) progress(result_.made);
                                       }};
    simulate::run_rows(job_.plan, range, lsb_v, encoder.sink(), control,
                       [&](const simulate::EncodedRows& rows) { part_->writer().take(rows); });
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
    ProgressDisplay display(workshop_.streams.err, workshop_.style, job_.output.string() + " (joining its parts)");
    const simulate::RunControl control{workshop_.threads, workshop_.streams.stop,
                                       [&](const core::Progress& progress) { display.update(progress); }};
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
  PartResult result_;
  std::optional<raster::PartRun> part_;
};

}  // namespace

PartResult make_part(const PartJob& job, const PartWorkshop& workshop) {
  try {
    return PartMaker(job, workshop).make();
  } catch (const core::Interrupted&) {
    throw KeptInterruption(raster::parts_folder_of(job.output).string());
  }
}

std::string part_text(const PartJob& job, const PartResult& result) {
  const std::string output = job.output.string();
  if (result.finished_before) return output + ": finished before; nothing was computed\n";
  if (result.range.count == 0)
    return fmt::format("{}: part {} has none of its {} pulses\n", output, words_of(job.choice), job.plan.rows);
  std::string text =
      fmt::format("{}: part {}: pulses {} to {} are made, {} of them now, in {}\n", output, words_of(job.choice),
                  result.range.first + 1, result.range.end(), result.made, core::duration_text(result.seconds));
  if (result.elsewhere)
    text += fmt::format("{}: complete; another part has put it together\n", output);
  else if (!result.whole && job.choice.own_file)
    text += fmt::format("  kept in {}, for sarsim merge\n", raster::parts_folder_of(job.output).string());
  else if (!result.whole)
    text += fmt::format("  {} of {} pulses are there; the part that comes last completes the file\n", result.there,
                        job.plan.rows);
  return text;
}

void write_json(core::JsonWriter& json, const PartJob& job, const PartResult& result) {
  json.begin_object().member("kind", "part").member("file", job.output.string());
  json.member("part", words_of(job.choice)).member("rows", job.plan.rows);
  json.member("first_row", result.range.first).member("part_rows", result.range.count);
  json.member("computed_rows", result.made).member("rejected_rows", result.rejected);
  json.member("rows_there", result.there).member("complete", result.whole.has_value() || result.elsewhere);
  json.member("seconds", result.seconds).member("journal_seconds", result.journal_seconds);
  json.member("journal_entries", result.journal_entries).end_object();
}

}  // namespace sarsim::cli
