#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/part_identity.hpp"
#include "cli/command/part_options.hpp"
#include "cli/command/part_recording.hpp"
#include "cli/command/products.hpp"
#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/scene_input.hpp"
#include "core/build/version.hpp"
#include "core/os/disk_room.hpp"
#include "core/os/output_file.hpp"
#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/run/geometry_table.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

struct RunArguments {
  std::string scene;
  std::vector<std::string> products;
  std::string folder = ".";
  SceneOverrides overrides;
  std::optional<std::int64_t> threads;
  std::optional<simulate::Engine> engine;
  std::string simd;
  bool force = false;
  bool quiet = false;
  bool json = false;
  bool strict = false;
  bool keep_paths = false;
  bool counts = false;
  bool header = false;
  bool discard = false;
  PartChoice part;
};

// One run of a script, from its text to its products.
class Runner {
 public:
  Runner(const RunArguments& arguments, Streams& streams, Team* team)
      : arguments_(arguments),
        streams_(streams),
        team_(team),
        journaled_(team != nullptr || arguments.part.journaled()) {
    threads_ = core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0)));
    if (team != nullptr && arguments.threads.value_or(0) == 0)
      threads_ = std::max(threads_ / team->processes_here(), 1U);
  }

  ExitStatus run() {
    try {
      prepare_together();
      for (const ProductJob& job : jobs_) make(job);
    } catch (const core::Refused& error) {
      finish_json("bad input", error.problems);
      throw;
    } catch (const simulate::ImpossibleEcho& error) {
      take_problems({error.problem});
      finish_json("bad input", input_.problems);
      throw core::Refused({input_.problems.front()});
    } catch (const core::Interrupted&) {
      finish_json("interrupted", input_.problems);
      throw;
    } catch (const std::exception&) {
      finish_json("failed", input_.problems);
      throw;
    }
    finish_json("done", input_.problems);
    return exit_done;
  }

 private:
  // Where processes run together, all of them are ready, or none goes on.
  void prepare_together() {
    try {
      choose_simd(arguments_.simd);
      expect_partable();
      prepare();
    } catch (...) {
      if (team_ != nullptr) static_cast<void>(team_->all_well(false));
      throw;
    }
    if (team_ != nullptr && !team_->all_well(true)) throw core::Refused(core::Problems());
  }

  void expect_partable() const {
    const PartChoice& part = arguments_.part;
    if (team_ != nullptr && (part.share || part.span || part.own_file))
      throw core::Refused("MPI deals the pulses out by itself", "leave out --part, --pulses and --part-file");
    if (team_ != nullptr && arguments_.discard)
      throw core::Refused("--discard writes nothing: there is nothing that processes could share",
                          "measure with sarsim run --discard, of one process");
    if (journaled_ && arguments_.discard)
      throw core::Refused("--discard writes nothing: there is nothing to share, keep or resume",
                          "leave out --discard, or --part, --pulses and --resume");
    if (!journaled_ && (part.own_file || part.save_every_s))
      throw core::Refused("--part-file and --save-every concern parts and runs that can be resumed",
                          "give --part, --pulses or --resume as well");
  }

  void make(const ProductJob& job) {
    if (journaled_)
      job.table ? make_table_of_part(job) : make_part_of(job);
    else
      job.table ? make_table(job) : make_recording(job);
  }

  [[nodiscard]] simulate::Plan planned(std::size_t simulation) {
    if (kept_plan_ && kept_plan_->first == simulation) {
      simulate::Plan plan = std::move(kept_plan_->second);
      kept_plan_.reset();
      return plan;
    }
    return simulate::make_plan(input_.scene, simulation, input_.resolved,
                               arguments_.engine.value_or(simulate::Engine::automatic));
  }

  void prepare() {
    OutputNames names;
    // What is not made is not looked at either.
    const auto choose = [&](const scene::Scene& scene) {
      names = output_names(scene, {arguments_.folder, arguments_.keep_paths, arguments_.overrides.format});
      jobs_ = chosen_products(scene, names, arguments_.products);
      WantedProducts wanted;
      for (const ProductJob& job : jobs_) (job.table ? wanted.geometries : wanted.simulations).push_back(job.index);
      return wanted;
    };
    input_ = read_scene(arguments_.scene, arguments_.overrides, Scrutiny::echoes, {threads_, streams_.stop}, choose);
    expect_sound();
    if (jobs_.empty()) expect_objects();
    std::erase_if(names.problems, [this](const core::Problem& p) { return !concerns_any(p); });
    take_problems(names.problems);
    expect_sound();
    expect_usable(input_, arguments_.strict);
    if (!arguments_.discard) expect_free_outputs();
    if (!arguments_.quiet) print_problems(streams_, input_.problems);
    resolve_once(input_, {threads_, streams_.stop});
    announce();
  }

  // A scene without products is nothing to do; a script that describes nothing at all is a mistake.
  void expect_objects() const {
    const scene::Scene& scene = input_.scene;
    if (scene.platforms.empty() && scene.targets.empty() && scene.surfaces.empty() && scene.radars.empty()) {
      core::Refused nothing("the script asks for nothing", "add a $SIMULATION or a $GEOMETRY");
      nothing.problems.front().place.file = arguments_.scene;
      throw nothing;
    }
    if (!arguments_.quiet)
      streams_.err << arguments_.scene << ": nothing to do: the script has no $SIMULATION and no $GEOMETRY\n";
  }

  // Errors end the run; where only they are wanted, without what else was found.
  void expect_sound() {
    if (arguments_.quiet && core::has_errors(input_.problems))
      std::erase_if(input_.problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
    expect_usable(input_);
  }

  void take_problems(core::Problems more) {
    scene::locate(more, input_.places);
    std::ranges::move(more, std::back_inserter(input_.problems));
    input_.problems = core::ranked(std::move(input_.problems));
  }

  [[nodiscard]] bool concerns(const core::Problem& problem, const ProductJob& job) const {
    return problem.subject.kind == (job.table ? "geometry" : "simulation") && problem.subject.index == job.index;
  }

  [[nodiscard]] bool concerns_any(const core::Problem& problem) const {
    return std::ranges::any_of(jobs_, [&](const ProductJob& job) { return concerns(problem, job); });
  }

  void expect_free_outputs() {
    core::Problems problems;
    // Whether a recording that is made in parts is finished is looked at when its turn comes.
    for (const ProductJob& job : jobs_) {
      const bool later = journaled_ && (!job.table || arguments_.part.resume || !makes_tables());
      std::ranges::move(problems_of_output(job.path, {input_.sources, arguments_.force || later}),
                        std::back_inserter(problems));
    }
    if (fs::exists(arguments_.folder) && !fs::is_directory(arguments_.folder)) {
      problems = {};
      throw core::Refused("'" + arguments_.folder + "' is not a folder",
                          "name a folder with --out; it is made when missing");
    }
    if (!problems.empty()) throw core::Refused(std::move(problems));
  }

  // One line for each recording, and the room that all of them need.
  void announce() {
    double bytes_wanted = 0.0;
    std::optional<std::size_t> most_rows;
    std::string lines;
    core::Problems missing;
    for (const ProductJob& job : jobs_) {
      if (job.table) {
        bytes_wanted += smallest_table_bytes(input_.scene.geometries[job.index]);
        continue;
      }
      simulate::Plan plan = planned(job.index);
      most_rows = std::max(most_rows.value_or(0), plan.rows);
      const double bytes = raster::expected_bytes(simulate::product_of(plan, {}), sink_options(plan.simulation));
      bytes_wanted += room_bytes(job, plan, bytes);
      lines += announcement(job, plan, bytes);
      add_missing_pulses(job, plan, missing);
      // The first recording comes first; the plans of all of them could be too much to keep.
      if (!kept_plan_) kept_plan_.emplace(job.index, std::move(plan));
    }
    const auto& span = arguments_.part.span;
    if (span && most_rows && *most_rows < static_cast<std::size_t>(span->first))
      throw core::Refused(
          {core::problem_of(core::Severity::error, "no recording has as many pulses as --pulses asks for",
                            words_of(arguments_.part), fmt::format("pulses 1 to {}", *most_rows), {})});
    if (!arguments_.quiet) print_problems(streams_, missing);
    if (!arguments_.quiet) streams_.err << lines;
    take_problems(std::move(missing));
    expect_usable(input_, arguments_.strict);
    if (!arguments_.discard)
      core::expect_room(arguments_.folder, bytes_wanted, "choose another folder with --out or a smaller --format");
  }

  void add_missing_pulses(const ProductJob& job, const simulate::Plan& plan, core::Problems& missing) const {
    const auto& span = arguments_.part.span;
    if (!span || !span->last || static_cast<std::size_t>(*span->last) <= plan.rows) return;
    missing.push_back(core::problem_of(core::Severity::warning,
                                       fmt::format("'{}' has fewer pulses than --pulses asks for", job.path.string()),
                                       words_of(arguments_.part), fmt::format("pulses 1 to {}", plan.rows), {}));
  }

  // What a recording needs on the disk at least.
  [[nodiscard]] double room_bytes(const ProductJob& job, const simulate::Plan& plan, double bytes) const {
    const double least = raster::least_bytes(plan.simulation.format, bytes);
    if (!journaled_) return least;
    if (fs::exists(raster::parts_folder_of(job.path))) return 0.0;  // Taken already, or in part.
    const double rows = static_cast<double>(plan.rows);
    const double made = static_cast<double>(rows_of(arguments_.part, plan.rows).count);
    if (estimates_lsb(plan.simulation)) return 16.0 * made * static_cast<double>(plan.columns);
    return raster::format_of(plan.simulation.format).is_text() || arguments_.part.own_file ? least * made / rows
                                                                                           : least;
  }

  [[nodiscard]] bool estimates_lsb(const scene::Simulation& simulation) const {
    return simulation.lsb_v <= 0.0 && raster::holds_counts(simulation.format, arguments_.counts);
  }

  [[nodiscard]] std::string announcement(const ProductJob& job, const simulate::Plan& plan, double bytes) const {
    const bool twice = estimates_lsb(plan.simulation) && !journaled_;
    const double made = static_cast<double>(rows_of(arguments_.part, plan.rows).count) / static_cast<double>(plan.rows);
    const double seconds =
        made * simulate::estimated_cost(plan, threads_).seconds_one_thread / threads_ * (twice ? 2.0 : 1.0);
    return fmt::format("{}: {}, {}, {} x {} samples, {}, {} on {} thread{}\n", job.path.string(), plan.radar.name,
                       processing_word(plan.simulation.processing), plan.rows, plan.columns, core::bytes_text(bytes),
                       core::about_duration_text(seconds), threads_, threads_ == 1 ? "" : "s");
  }

  // No line of a table is shorter than its pulse number and its end.
  [[nodiscard]] double smallest_table_bytes(const scene::GeometryTable& table) const {
    const std::size_t radar = scene::find_radar(input_.scene, table.radar);
    if (radar == scene::not_found) return 0.0;
    const radar::PulseRange pulses = simulate::resolve_radar(input_.scene, *input_.resolved, radar)
                                         .repetition.pulses_in(table.time_start_s, table.time_end_s);
    return 10.0 * static_cast<double>(pulses.count());
  }

  [[nodiscard]] raster::SinkOptions sink_options(const scene::Simulation& simulation) const {
    return {simulation.format, arguments_.force, arguments_.counts, arguments_.header};
  }

  [[nodiscard]] simulate::RunControl control(ProgressDisplay& display) const {
    return {threads_, streams_.stop, [&display](const core::Progress& progress) { display.update(progress); }};
  }

  [[nodiscard]] ProgressDisplay::Style style() const {
    if (arguments_.quiet) return ProgressDisplay::Style::none;
    return streams_.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines;
  }

  [[nodiscard]] std::unique_ptr<simulate::Sink> sink_of(const ProductJob& job, const simulate::Product& product,
                                                        const scene::Simulation& simulation) const {
    if (arguments_.discard) return raster::make_discarding_sink(product, sink_options(simulation));
    if (job.path.has_parent_path()) fs::create_directories(job.path.parent_path());
    return raster::make_sink(job.path, product, sink_options(simulation));
  }

  // The LSB that the sink's counts need; 0 where neither script nor sink want one.
  [[nodiscard]] double lsb_v(const simulate::Plan& plan, const simulate::Sink& sink, const std::string& name) const {
    if (plan.simulation.lsb_v > 0.0 || !sink.wants_counts()) return plan.simulation.lsb_v;
    ProgressDisplay display(streams_.err, style(), name + " (finding the largest magnitude)");
    return simulate::resolved_lsb_v(plan, control(display));
  }

  void make_recording(const ProductJob& job) {
    const double begin_s = core::now_s();
    const simulate::Plan plan = planned(job.index);
    const bool with_script = raster::format_of(plan.simulation.format).carries_script;
    const simulate::Product product = simulate::product_of(plan, with_script ? script() : std::string());
    const std::unique_ptr<simulate::Sink> sink = sink_of(job, product, plan.simulation);
    RecordingReport report = report_on(job, plan, product);
    report.counts = sink->wants_counts();
    const double lsb = lsb_v(plan, *sink, job.path.string());
    {
      ProgressDisplay display(streams_.err, style(), job.path.string());
      report.run = sarsim::simulate::run(plan, lsb, *sink, control(display));
    }
    if (!arguments_.discard) take_file(job.path, report.file, report.bytes);
    report.seconds = core::now_s() - begin_s;
    tell(report);
  }

  // What a report says before anything was computed.
  [[nodiscard]] RecordingReport report_on(const ProductJob& job, const simulate::Plan& plan,
                                          const simulate::Product& product) const {
    RecordingReport report;
    report.simulation = plan.simulation;
    report.simulation.radar = plan.radar.name;
    report.options = input_.scene.options;
    report.engine = product.engine;
    report.engine_reason = plan.engine.reason;
    std::ranges::copy_if(input_.problems, std::back_inserter(report.warnings), [&](const core::Problem& p) {
      return p.severity == core::Severity::warning && (p.subject.kind != "simulation" || concerns(p, job));
    });
    return report;
  }

  void tell(const RecordingReport& report) {
    if (!arguments_.quiet) streams_.err << report_text(report);
    write_json(products_, report);
  }

  // The text of the scene as understood, made when it is first needed.
  const std::string& script() {
    if (script_.empty()) script_ = scene::write_script(input_.scene, {threads_, streams_.stop});
    return script_;
  }

  void make_part_of(const ProductJob& job) {
    const double begin_s = core::now_s();
    const simulate::Plan plan = planned(job.index);
    raster::StoredProduct stored;
    stored.product =
        simulate::product_of(plan, raster::format_of(plan.simulation.format).carries_script ? script() : std::string());
    stored.options = sink_options(plan.simulation);
    stored.estimate_lsb = estimates_lsb(plan.simulation);
    stored.engine_reason = plan.engine.reason;
    const raster::Identity identity = identity_of(input_.scene, job.index, script(), stored);
    const PartJob part{plan, job.path, stored, identity, arguments_.part, arguments_.force};
    const PartResult result = make_part(part, {streams_, style(), threads_, team_});
    if (!arguments_.quiet) streams_.err << part_text(part, result);
    write_json(products_, part, result);
    if (!result.whole) return;
    RecordingReport report = report_on(job, plan, stored.product);
    report.counts = stored.estimate_lsb || raster::holds_counts(plan.simulation.format, arguments_.counts);
    report.run = *result.whole;
    take_file(job.path, report.file, report.bytes);
    report.seconds = result.finished_before ? result.whole->seconds : core::now_s() - begin_s;
    tell(report);
  }

  // Tables take no time: the share that holds the first pulse makes them, anew where it resumes.
  void make_table_of_part(const ProductJob& job) {
    if (makes_tables()) make_table(job);
  }

  [[nodiscard]] bool makes_tables() const { return arguments_.part.first() && (team_ == nullptr || team_->leads()); }

  void make_table(const ProductJob& job) {
    const double begin_s = core::now_s();
    const scene::GeometryTable& table = input_.scene.geometries[job.index];
    TableReport report;
    report.radar = table.radar;
    if (arguments_.discard) {
      const auto count = [&](std::string_view piece) { report.bytes += static_cast<double>(piece.size()); };
      simulate::write_geometry_text(input_.scene, table, count, streams_.stop);
    } else {
      if (job.path.has_parent_path()) fs::create_directories(job.path.parent_path());
      core::OutputFile file(job.path, arguments_.force || arguments_.part.resume);
      const auto write = [&](std::string_view piece) { file.write(std::as_bytes(std::span(piece))); };
      simulate::write_geometry_text(input_.scene, table, write, streams_.stop);
      file.commit();
      take_file(job.path, report.file, report.bytes);
    }
    report.seconds = core::now_s() - begin_s;
    if (!arguments_.quiet)
      streams_.err << fmt::format("{}: geometry table of {}, {}\n", job.path.string(), table.radar,
                                  core::bytes_text(report.bytes));
    write_json(products_, report);
  }

  // Name and true size of a finished file.
  static void take_file(const fs::path& path, std::string& name, auto& bytes) {
    name = path.string();
    std::error_code failure;
    const auto size = fs::file_size(path, failure);
    if (!failure) bytes = static_cast<double>(size);
  }

  void finish_json(const char* status, const core::Problems& problems) {
    if (!arguments_.json) return;
    products_.end_array().member("status", status).key("problems");
    write_json(products_, problems);
    products_.end_object();
    write_out(streams_, products_.text());
    flush_out(streams_);
  }

  static core::JsonWriter begun_json(const std::string& script) {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("script", script).key("products").begin_array();
    return json;
  }

  const RunArguments& arguments_;
  Streams& streams_;
  Team* team_;
  bool journaled_;
  unsigned threads_ = 1;
  std::string script_;
  SceneInput input_;
  std::vector<ProductJob> jobs_;
  std::optional<std::pair<std::size_t, simulate::Plan>>
      kept_plan_;  // of a simulation; made to be announced, run afterwards
  core::JsonWriter products_ = begun_json(arguments_.scene);
};

void add_run_options(CLI::App& app, RunArguments& a) {
  add_text(app, "--out", a.folder, "DIR", "folder for the products; made when missing (default: the current one)");
  add_format(app, "--format", a.overrides.format, "format of all recordings, with its extension");
  add_engine(app, a.engine,
             "how echoes are added up: the faster one (default), or one of them; all within --tolerance");
  add_text(app, "--simd", a.simd, "LEVEL",
           "instruction set to use (avx512, avx2, sse4, ...), for the same bytes on other processors");
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  add_scene_overrides(app, a.overrides);
  add_settings(app, a.overrides);
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--keep-paths", a.keep_paths, "keep the folders of output names");
  app.add_flag("--counts", a.counts, "converter counts instead of volts in HDF5 and NPY");
  app.add_flag("--header", a.header, "a header line in CSV");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--strict", a.strict, "warnings end the run before it begins (status 2)");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
  app.add_flag("--discard", a.discard, "compute and encode everything, write nothing");
  add_part_options(app, a.part);
}

}  // namespace

Action add_run(CLI::App& app, Team* team) {
  auto arguments = std::make_shared<RunArguments>();
  add_text(app, "scene", arguments->scene, "SCENE", "script to simulate")->required();
  app.add_option("products", arguments->products,
                 "which products: numbers of simulations from 1, or output names (default: all)")
      ->type_name("NUMBER|NAME");
  add_run_options(app, *arguments);
  add_examples(app,
               {{"sarsim run sar_r.scr", "everything that the script asks for"},
                {"sarsim run sar_r.scr 2 --out results", "its second simulation, into another folder"},
                {"sarsim run sar_r.scr --format hdf5 --force", "volts as HDF5, replacing older files"},
                {"sarsim run old.scr --profile classic", "as the program of 1998 computed it"},
                {"sarsim run sar_r.scr --part 3/8", "the third of eight shares, on any machine that sees the folder"},
                {"sarsim run sar_r.scr --resume", "with a journal; the same again goes on where it ended"}});
  return [arguments, team](Streams& streams) { return Runner(*arguments, streams, team).run(); };
}

}  // namespace sarsim::cli
