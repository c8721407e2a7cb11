#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <system_error>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/os/output_file.hpp"
#include "core/os/raw_file.hpp"
#include "core/task/parallel.hpp"
#include "core/text/json.hpp"
#include "raster/parts/join_parts.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

struct MergeArguments {
  std::vector<std::string> folders;
  std::string output;
  std::optional<std::int64_t> threads;
  bool force = false;
  bool remove = false;
  bool json = false;
  bool quiet = false;
};

constexpr std::string_view extension = ".parts";

// The parts of one recording, from folders to its file.
class Merger {
 public:
  Merger(const MergeArguments& arguments, Streams& streams) : arguments_(arguments), streams_(streams) {}

  ExitStatus run() {
    try {
      raster::JoinTask task;
      task.output = output();
      task.replace = arguments_.force;
      for (const std::string& folder : arguments_.folders) expect_outside(task.output, folder);
      expect_free_outputs({task.output}, {{}, arguments_.force, "-o"});
      for (const std::string& folder : arguments_.folders) collect(folder, task.journals);
      task.product = raster::load_product(raster::product_file_of(arguments_.folders.front()));
      if (core::Problems problems = raster::join_problems(task.journals, task.product.product.rows); !problems.empty())
        throw core::Refused(std::move(problems));
      join(task);
    } catch (const raster::UnfitParts& unfit) {
      throw core::Refused(unfit.problems);
    }
    return exit_done;
  }

 private:
  [[nodiscard]] fs::path output() const {
    if (!arguments_.output.empty()) return arguments_.output;
    const fs::path folder = fs::path(arguments_.folders.front() + "/").parent_path();
    if (folder.extension() != extension)
      throw core::Refused("'" + arguments_.folders.front() + "' is not a folder of parts",
                          "such a folder is called NAME.parts; for another one give the output with -o");
    return fs::path(folder).replace_extension();
  }

  // In there the output would be taken for a part, or take the place of one, and go with the parts.
  static void expect_outside(const fs::path& output, const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    const fs::path inside = fs::canonical(folder);
    const fs::path place = fs::weakly_canonical(fs::absolute(core::end_of_links(output)));
    if (std::mismatch(inside.begin(), inside.end(), place.begin(), place.end()).first == inside.end())
      throw core::Refused(
          fmt::format("the output '{}' is in the folder of parts '{}'", output.string(), folder.string()),
          "choose another place with -o");
  }

  // Nobody may be at work on the parts while they are joined. Who holds the door lets nobody in, which takes one open
  // file for a folder with however many parts.
  void collect(const std::string& folder, std::vector<raster::Journal>& journals) {
    if (!fs::is_directory(folder))
      throw core::Refused("there is no folder '" + folder + "'",
                          "parts are in the folder NAME.parts beside their output");
    close_door(folder);
    std::vector<raster::Journal> found = raster::read_journals(folder);
    if (found.empty()) throw core::Refused("the folder '" + folder + "' holds no parts", "it has no journals");
    for (raster::Journal& journal : found) {
      if (!opened(journal.path).try_lock())
        throw core::Refused(fmt::format("part {} is still being made ({})", journal.head.part, journal.head.maker),
                            "wait for it: the part that comes last completes the file by itself");
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
        throw core::Refused("the folder '" + folder.string() + "' is named twice", "name each folder once");
    closed_.push_back(folder);
    if (!fs::exists(folder / "lock")) return;
    doors_.push_back(opened(folder / "lock"));
    doors_.back().lock();
  }

  void join(const raster::JoinTask& task) {
    const auto style = arguments_.quiet    ? ProgressDisplay::Style::none
                       : streams_.terminal ? ProgressDisplay::Style::bar
                                           : ProgressDisplay::Style::lines;
    RecordingReport report;
    {
      ProgressDisplay display(streams_.err, style, task.output.string());
      const unsigned threads = core::thread_count(static_cast<unsigned>(arguments_.threads.value_or(0)));
      report.run =
          raster::join_parts(task, {threads, streams_.stop, [&](const core::Progress& p) { display.update(p); }})
              .report;
    }
    remove(task);
    const simulate::Product& product = task.product.product;
    report.file = task.output.string();
    report.simulation.format = task.product.options.format;
    report.simulation.processing = product.processing;
    report.simulation.radar = product.radar;
    report.simulation.bits = product.bits;
    report.simulation.lsb_v = product.lsb_v;
    report.options = product.options;
    report.engine = product.engine;
    report.engine_reason = task.product.engine_reason;
    report.counts = task.product.estimate_lsb || !holds_volts(task.product.options);
    report.bytes = static_cast<double>(fs::file_size(task.output));
    report.seconds = report.run.seconds;
    if (!arguments_.quiet) streams_.err << report_text(report);
    if (arguments_.json) print_json(report);
  }

  static bool holds_volts(const raster::SinkOptions& options) {
    return !raster::holds_counts(options.format, options.counts);
  }

  // Rows that stood at their places have become the output: what is left of their folder is of no use.
  void remove(const raster::JoinTask& task) {
    doors_.clear();
    const fs::path own = raster::parts_folder_of(task.output);
    for (const std::string& folder : arguments_.folders)
      if (arguments_.remove ||
          (fs::equivalent(folder, own) && !fs::exists(raster::shared_rows_of(folder)) && placed(task)))
        raster::remove_parts(folder);
    remove_if_empty(own);
  }

  static bool placed(const raster::JoinTask& task) {
    for (const raster::Journal& journal : task.journals)
      if (journal.head.store == raster::RowStore::placed) return true;
    return false;
  }

  static void remove_if_empty(const fs::path& folder) {
    std::error_code ignored;
    fs::remove(folder, ignored);
  }

  void print_json(const RecordingReport& report) {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).key("products").begin_array();
    write_json(json, report);
    json.end_array().end_object();
    write_out(streams_, json.text());
  }

  const MergeArguments& arguments_;
  Streams& streams_;
  std::vector<fs::path> closed_;  // Folders whose doors are held.
  std::vector<core::RawFile> doors_;
};

}  // namespace

Action add_merge(CLI::App& app) {
  auto arguments = std::make_shared<MergeArguments>();
  app.add_option("folders", arguments->folders, "folders with the parts of one recording (NAME.parts)")
      ->required()
      ->type_name("FOLDER");
  add_text(app, "-o,--output", arguments->output, "FILE", "file to make (default: NAME beside the first folder)");
  add_integer(app, "--threads", arguments->threads, 0, 4096, "threads; 0 for one per core (default)");
  app.add_flag("--force", arguments->force, "replace the output where it exists");
  app.add_flag("--remove", arguments->remove, "remove the parts once they are joined");
  app.add_flag("--json", arguments->json, "a report as JSON on standard output");
  app.add_flag("--quiet", arguments->quiet, "only errors on standard error");
  add_examples(app, {{"sarsim merge out/sim.bin.parts", "parts that were copied into one folder become out/sim.bin"},
                     {"sarsim merge a/sim.bin.parts b/sim.bin.parts -o sim.bin", "from the folders of two machines"}});
  return [arguments](Streams& streams) { return Merger(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
