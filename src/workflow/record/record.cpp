#include "workflow/record/record.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/os/disk_room.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/model/object.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/run/geometry_table.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_words.hpp"
#include "workflow/input/simd_choice.hpp"
#include "workflow/record/part_identity.hpp"
#include "workflow/record/part_recording.hpp"
#include "workflow/record/products.hpp"
#include "workflow/record/record_size.hpp"
#include "workflow/record/recording.hpp"
#include "workflow/record/side_files.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// One run of a scene, from its text to its products.
class Recorder {
 public:
  Recorder(const RecordRequest& request, const core::Observer& observer, const RecordEvents& events)
      : request_(request),
        observer_(observer),
        events_(events),
        output_(run_output(request.folder)),
        overrides_(request.overrides),
        journaled_(request.team != nullptr || request.part.journaled()) {
    threads_ = core::thread_count(request.threads);
    if (request.team != nullptr && request.threads == 0)
      threads_ = std::max(threads_ / request.team->processes_here(), 1U);
  }

  RecordReport run() {
    try {
      prepare_together();
      for (const ProductJob& job : jobs_) make(job);
    } catch (const simulate::ImpossibleEcho& error) {
      // Places are not kept during the run: those of a target take more memory than all else of it.
      if (!request_.scene) input_.places = scene::read_scene_file(request_.script, {work()}).places;
      take_problems({error.problem});
      throw core::InvalidRequest({input_.problems.front()});
    }
    report_.problems = input_.problems;
    return std::move(report_);
  }

 private:
  // Where processes run together, all of them are ready, or none goes on.
  void prepare_together() {
    take_together(request_.team, [this] {
      choose_simd(request_.simd);
      expect_partable();
      prepare();
    });
  }

  void expect_partable() const {
    const PartChoice& part = request_.part;
    if (request_.team != nullptr && (part.share || part.span || part.own_file))
      throw core::InvalidRequest("MPI distributes the pulses itself", "leave out --part, --pulses and --part-file");
    if (request_.team != nullptr && request_.discard)
      throw core::InvalidRequest("--discard writes nothing: there is nothing that processes could share",
                                 "measure with sarsim run --discard, of one process");
    if (journaled_ && request_.discard)
      throw core::InvalidRequest("--discard writes nothing: there is nothing to share, keep or resume",
                                 "leave out --discard, or --part, --pulses and --resume");
    if (!journaled_ && (part.own_file || part.save_every_s))
      throw core::InvalidRequest("--part-file and --save-every concern parts and runs that can be resumed",
                                 "give --part, --pulses or --resume as well");
  }

  void make(const ProductJob& job) {
    ProductReport made;
    made.path = job.path;
    if (job.table) {
      // Tables take no time: the share that holds the first pulse makes them, anew where it resumes.
      if (journaled_ && !makes_tables()) return;
      made.table = make_table(job);
    } else if (journaled_) {
      make_part_of(job, made);
    } else {
      made.recording = make_whole(job);
    }
    report_.products.push_back(std::move(made));
    if (events_.made) events_.made(report_.products.back());
  }

  [[nodiscard]] simulate::Plan planned(std::size_t simulation) {
    if (kept_plan_ && kept_plan_->first == simulation) {
      simulate::Plan plan = std::move(kept_plan_->second);
      kept_plan_.reset();
      return plan;
    }
    return simulate::make_plan(input_.scene, simulation, input_.resolved, request_.engine);
  }

  [[nodiscard]] core::WorkControl work() const { return observer_.control(threads_); }

  // The ending of a file's name says its format, where nothing else does.
  void take_format_of_file() {
    if (!output_.file) return;
    const auto format = raster::format_from_path(*output_.file);
    if (overrides_.format && *overrides_.format != *format)
      throw core::InvalidRequest(
          fmt::format("--out: '{}' has the ending of {}, and --format says {}", output_.file->string(),
                      format_word(*format), format_word(*overrides_.format)),
          fmt::format("leave out --format, or end the name with {}", raster::extension_of(*overrides_.format)));
    overrides_.format = format;
  }

  // The only recording gets the name that --out gives it.
  void name_file() {
    if (!output_.file) return;
    const auto recordings = std::ranges::count_if(jobs_, [](const ProductJob& job) { return !job.table; });
    if (recordings != 1)
      throw core::InvalidRequest(fmt::format("--out: '{}' is the name of a file, and there are {} recordings",
                                             output_.file->string(), recordings),
                                 recordings == 0
                                     ? "name a folder"
                                     : "choose one recording, as in sarsim run SCENE 1 --out FILE, or name a folder");
    std::ranges::find_if(jobs_, [](const ProductJob& job) { return !job.table; })->path = *output_.file;
  }

  void prepare() {
    take_format_of_file();
    OutputNames names;
    // What is not made is not looked at either.
    const auto choose = [&](const scene::Scene& scene) {
      names = output_names(scene, {output_.folder, request_.keep_paths, overrides_.format});
      jobs_ = chosen_products(scene, names, request_.products);
      name_file();
      WantedProducts wanted;
      for (const ProductJob& job : jobs_) (job.table ? wanted.geometries : wanted.simulations).push_back(job.index);
      return wanted;
    };
    input_ = request_.scene ? take_scene(*request_.scene, fs::path(request_.script).parent_path(), overrides_,
                                         CheckLevel::echoes, work(), choose)
                            : read_scene(request_.script, overrides_, CheckLevel::echoes, work(), choose);
    if (request_.doubles)  // What single precision cannot hold is held then.
      std::erase_if(input_.problems, [](const core::Problem& p) {
        return p.severity == core::Severity::note && p.subject.kind == "simulation" && p.subject.field == "format";
      });
    tell_problems();
    expect_usable(input_);
    if (jobs_.empty()) expect_objects();
    std::erase_if(names.problems, [this](const core::Problem& p) { return !concerns_any(p); });
    take_problems(names.problems);
    expect_usable(input_, request_.strict);
    if (!request_.discard) expect_free_files();
    observer_.remarks(input_.problems);
    resolve_once(input_, work());
    announce();
    forget_what_is_resolved();
  }

  // Targets may be many: a run keeps them as its engine takes them, unless a product tells of them.
  void forget_what_is_resolved() {
    input_.places = {};
    const bool told =
        journaled_ || std::ranges::any_of(jobs_, [&](const ProductJob& job) {
          return job.table || raster::format_of(input_.scene.simulations[job.index].format).carries_script;
        });
    if (!told) std::vector<scene::Target>().swap(input_.scene.targets);
  }

  // A script of 1998 without products is nothing to do; a scene is a mistake, and so is a script of nothing at all.
  void expect_objects() const {
    const scene::Scene& scene = input_.scene;
    const bool empty = std::ranges::all_of(scene::all_object_kinds, [&](scene::ObjectKind kind) {
      return scene::belongs_to_radar(kind) || scene::count_of(scene, kind) == 0;
    });
    const bool of_1998 = !request_.scene && input_.language == scene::Language::script;
    if (empty || !of_1998) {
      core::InvalidRequest nothing(
          of_1998 ? "the script defines nothing to compute"
                  : "the scene defines no recording and no geometry table: nothing to do",
          of_1998 ? "add a $SIMULATION or a $GEOMETRY; in format 2, a [[recording]] or a [[geometry]]"
                  : "add a [[recording]] or a [[geometry]]");
      nothing.problems.front().place.file = request_.script;
      throw nothing;
    }
    observer_.announces(request_.script + ": nothing to do: the scene has no recording and no geometry table");
  }

  void take_problems(core::Problems more) {
    scene::locate(more, input_.places);
    core::append(input_.problems, std::move(more));
    input_.problems = core::ranked(std::move(input_.problems));
    tell_problems();
  }

  void tell_problems() const {
    if (events_.found) events_.found(input_.problems);
  }

  [[nodiscard]] static bool concerns(const core::Problem& problem, const ProductJob& job) {
    return problem.subject.kind == (job.table ? "geometry" : "simulation") && problem.subject.index == job.index;
  }

  [[nodiscard]] bool concerns_any(const core::Problem& problem) const {
    return std::ranges::any_of(jobs_, [&](const ProductJob& job) { return concerns(problem, job); });
  }

  void expect_free_files() const {
    core::Problems problems;
    std::vector<fs::path> files;
    const InputList sources = input_.sources;
    // Whether a recording that is made in parts is finished is looked at when its turn comes.
    for (const ProductJob& job : jobs_) {
      const bool later = journaled_ && (!job.table || request_.part.resume || !makes_tables());
      const raster::Format* const format =
          job.table ? nullptr : &raster::format_of(input_.scene.simulations[job.index].format);
      for (const fs::path& file : raster::files_of(format, job.path)) {
        core::append(problems,
                     problems_of_output(file, {sources, request_.force || later, "", chosen_folder(output_.folder)}));
        files.push_back(file);
      }
      if (journaled_ && format != nullptr && format->in_files != nullptr)
        problems.push_back(core::error("parts and runs that can be resumed make one file")
                               .found(fmt::format("{}, which is several files", raster::word_of(*format)))
                               .hint("record HDF5 in this way, and convert it: sarsim convert"));
      if (!journaled_ || job.table) continue;
      core::append(problems, problems_of_side_files(job.path));
      for (const fs::path& file : side_files_of(job.path)) {
        if (auto harm = sources.harm_of(file, true)) problems.push_back(*std::move(harm));
        files.push_back(file);
      }
    }
    if (!request_.discard) core::append(problems, problems_of_same_files(files));
    expect_output_folder(output_.folder);
    if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  }

  // One line for each recording, and the room that all of them need.
  void announce() {
    double bytes_wanted = 0.0;
    std::optional<std::size_t> max_rows;
    std::vector<std::string> lines;
    core::Problems missing;
    for (const ProductJob& job : jobs_) {
      if (job.table) {
        bytes_wanted += min_table_bytes(input_.scene, *input_.resolved, input_.scene.geometries[job.index]);
        continue;
      }
      simulate::Plan plan = planned(job.index);
      max_rows = std::max(max_rows.value_or(0), plan.acquisition.timing.rows);
      const double bytes =
          raster::expected_bytes(simulate::product_of(plan, {}), sink_options(plan.acquisition.simulation));
      bytes_wanted += room_bytes(job, plan, bytes);
      lines.push_back(announcement(job, plan, bytes));
      add_missing_pulses(job, plan, missing);
      // The first recording comes first; the plans of all of them could be too much to keep.
      if (!kept_plan_) kept_plan_.emplace(job.index, std::move(plan));
    }
    const auto& span = request_.part.span;
    if (span && max_rows && *max_rows < static_cast<std::size_t>(span->first))
      throw core::InvalidRequest({core::error("no recording has as many pulses as --pulses asks for")
                                      .found(words_of(request_.part))
                                      .expected(fmt::format("pulses 1 to {}", *max_rows))});
    observer_.remarks(missing);
    for (const std::string& line : lines) observer_.announces(line);
    take_problems(std::move(missing));
    expect_usable(input_, request_.strict);
    if (!request_.discard)
      core::expect_room(output_.folder, bytes_wanted, "choose another folder with --out or a smaller --format");
  }

  void add_missing_pulses(const ProductJob& job, const simulate::Plan& plan, core::Problems& missing) const {
    const auto& span = request_.part.span;
    if (!span || !span->last || static_cast<std::size_t>(*span->last) <= plan.acquisition.timing.rows) return;
    missing.push_back(core::warning("recording.fewer-pulses",
                                    fmt::format("'{}' has fewer pulses than --pulses asks for", job.path.string()))
                          .found(words_of(request_.part))
                          .expected(fmt::format("pulses 1 to {}", plan.acquisition.timing.rows)));
  }

  // Rows of a recording that are to be made here.
  [[nodiscard]] std::size_t shared_rows(const simulate::Plan& plan) const {
    const std::size_t piece =
        raster::piece_rows(simulate::product_of(plan, {}), sink_options(plan.acquisition.simulation));
    return rows_of(request_.part, plan.acquisition.timing.rows, piece).count;
  }

  // What a recording needs on the disk at least.
  [[nodiscard]] double room_bytes(const ProductJob& job, const simulate::Plan& plan, double bytes) const {
    const double least = raster::min_bytes(plan.acquisition.simulation.format, bytes);
    if (!journaled_) return least;
    if (fs::exists(raster::parts_folder_of(job.path))) return 0.0;  // Taken already, or in part.
    const double rows = static_cast<double>(plan.acquisition.timing.rows);
    const double made = static_cast<double>(shared_rows(plan));
    if (seeks_lsb(plan.acquisition.simulation, request_.counts))
      return 16.0 * made * static_cast<double>(plan.acquisition.reception.columns);
    return raster::format_of(plan.acquisition.simulation.format).is_text() || request_.part.own_file
               ? least * made / rows
               : least;
  }

  [[nodiscard]] std::string announcement(const ProductJob& job, const simulate::Plan& plan, double bytes) const {
    const double passes = journaled_ ? 1.0 : passes_of(plan.acquisition.simulation, request_.counts);
    const double made = static_cast<double>(shared_rows(plan)) / static_cast<double>(plan.acquisition.timing.rows);
    const double seconds = made * estimated_seconds(plan, threads_, passes);
    return fmt::format("{}: {}, {}, {} x {} samples, {}, {} on {} thread{}", job.path.string(),
                       plan.acquisition.link.name, processing_word(plan.acquisition.simulation.processing),
                       plan.acquisition.timing.rows, plan.acquisition.reception.columns, core::bytes_text(bytes),
                       core::about_duration_text(seconds), threads_, threads_ == 1 ? "" : "s");
  }

  [[nodiscard]] raster::SinkOptions sink_options(const scene::Simulation& simulation) const {
    return {simulation.format, request_.force, request_.counts, request_.header, request_.doubles};
  }

  // The text of the scene as understood, made when it is first needed.
  const std::string& script() {
    if (script_.empty()) script_ = scene::recorded_text(input_.scene, work());
    return script_;
  }

  [[nodiscard]] std::string script_for(scene::FileFormat format) {
    return raster::format_of(format).carries_script ? script() : std::string();
  }

  void add_warnings(const ProductJob& job, RecordingReport& report) const {
    std::ranges::copy_if(input_.problems, std::back_inserter(report.warnings), [&](const core::Problem& p) {
      return p.severity == core::Severity::warning && (p.subject.kind != "simulation" || concerns(p, job));
    });
  }

  RecordingReport make_whole(const ProductJob& job) {
    const double begin_s = core::now_s();
    const simulate::Plan plan = planned(job.index);
    if (!request_.discard) make_folder_of(job.path);
    RecordingReport report = make_recording({plan, job.path, sink_options(plan.acquisition.simulation),
                                             script_for(plan.acquisition.simulation.format), request_.discard},
                                            threads_, observer_);
    add_warnings(job, report);
    report.seconds = core::now_s() - begin_s;
    return report;
  }

  void make_part_of(const ProductJob& job, ProductReport& made) {
    const double begin_s = core::now_s();
    const simulate::Plan plan = planned(job.index);
    raster::StoredProduct stored;
    stored.product = simulate::product_of(plan, script_for(plan.acquisition.simulation.format));
    stored.options = sink_options(plan.acquisition.simulation);
    stored.estimate_lsb = seeks_lsb(plan.acquisition.simulation, request_.counts);
    stored.engine_reason = plan.engine.reason;
    const raster::Identity identity = identity_of(input_.scene, job.index, stored, work());
    const PartJob part{plan, job.path, stored, identity, request_.part, request_.force};
    made.part = make_part(part, {observer_, events_, threads_, request_.team});
    const auto& whole = made.part->whole;
    if (!whole) return;
    RecordingReport report = begun_report(plan, stored.product);
    add_warnings(job, report);
    report.counts = stored.estimate_lsb || raster::holds_counts(plan.acquisition.simulation.format, request_.counts);
    report.run = *whole;
    take_file(job.path, report);
    report.seconds = made.part->finished_before ? whole->seconds : core::now_s() - begin_s;
    made.recording = std::move(report);
  }

  [[nodiscard]] bool makes_tables() const {
    return request_.part.first() && (request_.team == nullptr || request_.team->leads());
  }

  [[nodiscard]] TableReport make_table(const ProductJob& job) const {
    const double begin_s = core::now_s();
    const scene::GeometryTable& table = input_.scene.geometries[job.index];
    TableReport report;
    report.radar = table.radar;
    const auto count = [&](std::string_view piece) { report.bytes += static_cast<double>(piece.size()); };
    if (request_.discard) {
      simulate::write_geometry_text(input_.scene, table, count, observer_.stop);
    } else {
      make_folder_of(job.path);
      core::OutputFile file(job.path, request_.force || request_.part.resume);
      const auto write = [&](std::string_view piece) {
        count(piece);
        file.write(std::as_bytes(std::span(piece)));
      };
      simulate::write_geometry_text(input_.scene, table, write, observer_.stop);
      file.commit();
      report.file = job.path.string();
    }
    report.seconds = core::now_s() - begin_s;
    return report;
  }

  static void make_folder_of(const fs::path& path) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
  }

  const RecordRequest& request_;
  const core::Observer& observer_;
  const RecordEvents& events_;
  RunOutput output_;
  SceneOverrides overrides_;  // with the format that the name of the file asks for
  bool journaled_;
  unsigned threads_ = 1;
  std::string script_;
  SceneInput input_;
  std::vector<ProductJob> jobs_;
  // Of a simulation; made to be announced, run afterwards.
  std::optional<std::pair<std::size_t, simulate::Plan>> kept_plan_;
  RecordReport report_;
};

}  // namespace

RecordReport record(const RecordRequest& request, const core::Observer& observer, const RecordEvents& events) {
  return Recorder(request, observer, events).run();
}

}  // namespace sarsim::workflow
