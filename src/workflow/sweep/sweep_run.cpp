#include "workflow/sweep/sweep_run.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/hash/fnv1a.hpp"
#include "core/os/output_file.hpp"
#include "core/os/raw_file.hpp"
#include "core/os/temporary_files.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/edit/data_functions.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/model/cloud_points.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/run/geometry_table.hpp"
#include "workflow/record/recording.hpp"
#include "workflow/sweep/sweep_journal.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t no_axis = static_cast<std::size_t>(-1);

// A folder for files that are made again to be compared; gone with the object.
class AgainFolder {
 public:
  AgainFolder(const fs::path& folder, const std::string& file)
      : path_(core::temporary_name(folder / file)), name_(path_) {
    fs::create_directories(path_);
  }
  AgainFolder(const AgainFolder&) = delete;
  AgainFolder& operator=(const AgainFolder&) = delete;
  ~AgainFolder() { core::remove_folder(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  core::TemporaryName name_;
};

bool same_content(const fs::path& a, const fs::path& b) {
  constexpr std::size_t piece = std::size_t{1} << 20U;
  const core::RawFile left(a, core::RawFile::Mode::read);
  const core::RawFile right(b, core::RawFile::Mode::read);
  const std::uint64_t size = left.size();
  if (right.size() != size) return false;
  std::vector<std::byte> of_left(piece);
  std::vector<std::byte> of_right(piece);
  for (std::uint64_t at = 0; at < size; at += piece) {
    const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(piece, size - at));
    const auto first = std::span(of_left).first(count);
    const auto second = std::span(of_right).first(count);
    if (!left.read_at(at, first) || !right.read_at(at, second) || !std::ranges::equal(first, second)) return false;
  }
  return true;
}

bool same_files(const fs::path& a, const fs::path& b) {
  std::error_code none;
  if (!fs::is_directory(a)) return fs::is_regular_file(b, none) && same_content(a, b);
  if (!fs::is_directory(b, none)) return false;
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(a)) {
    if (!same_files(entry.path(), b / entry.path().filename())) return false;
    ++count;
  }
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(b), fs::directory_iterator())) == count;
}

// Moves files to a folder where they are missing there. Returns the first that differs from what is there.
fs::path move_new_files(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const fs::path there = to / entry.path().filename();
    if (!fs::exists(there))
      missing.push_back(entry.path());
    else if (!same_files(entry.path(), there))
      return there;
  }
  for (const fs::path& file : missing) fs::rename(file, to / file.filename());
  core::sync_folder_of(to / "any");
  return {};
}

// One variation at work.
class VariationRunner {
 public:
  VariationRunner(const SweptScene& swept, const VariationRules& rules, const core::StopFlag* stop)
      : swept_(swept), scene_(swept.scene), rules_(rules), stop_(stop) {}

  // @param done  told what is complete: a recording before it is followed up, too
  void make(const ProductJob& job, SweepRow& row, const std::function<void(const SweepRow&)>& done) {
    const double begin_s = core::now_s();
    try {
      if (!row.recorded) make_file(job, row);
      if (!rules_.discard) row.written = modification_time(rules_.folder / row.file);
      if (rules_.post_processing && !job.table) {
        if (!rules_.discard && !row.recorded) tell_recorded(row, done);
        post_processing(job.index, row);
      }
      row.done = true;
    } catch (const simulate::ImpossibleEcho& error) {
      row.failure = error.problem.message;
    } catch (const std::overflow_error& error) {
      row.failure = error.what();
    } catch (const core::InvalidRequest& refused) {
      row.failure = refused.problems.front().message;
    }
    row.seconds = core::now_s() - begin_s;
  }

  [[nodiscard]] core::Problems take_remarks() { return std::move(remarks_); }

 private:
  void make_file(const ProductJob& job, SweepRow& row) {
    if (!rules_.discard && rules_.begin) rules_.begin(row);
    if (!row.begun || rules_.replace || rules_.discard) return make_file_in(rules_.folder, job, row);
    // What an earlier process was making may have got its name before it was known to be done: it is kept where it is
    // the same, byte for byte.
    const AgainFolder again(rules_.folder, row.file);
    make_file_in(again.path(), job, row);
    if (const fs::path other = move_new_files(again.path(), rules_.folder); !other.empty())
      throw core::InvalidRequest(fmt::format("'{}' is not what this sweep makes", other.string()),
                                 "it was changed since; move it away, or replace with --force");
  }

  void make_file_in(const fs::path& folder, const ProductJob& job, SweepRow& row) {
    if (job.table)
      make_table(scene_.geometries.at(job.index), folder, row);
    else
      make_recording(job.index, folder, row);
  }

  void make_recording(std::size_t simulation, const fs::path& folder, SweepRow& row) {
    if (!resolved_)
      resolved_ = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene_, {rules_.threads, stop_}));
    const simulate::Plan plan = simulate::make_plan(scene_, simulation, resolved_, rules_.engine, stop_);
    const scene::FileFormat format = plan.acquisition.simulation.format;
    core::Observer alone;  // Of a sweep whole variations are told.
    alone.stop = stop_;
    const RecordingReport report = workflow::make_recording(
        {plan, folder / row.file, raster::SinkOptions{format, rules_.replace, rules_.counts, rules_.header},
         raster::format_of(format).carries_script ? scene::recorded_text(scene_) : std::string(), rules_.discard},
        rules_.threads, alone);
    row.run = report.run;
    row.engine = report.engine;
    row.lsb_estimated = plan.acquisition.simulation.lsb_v <= 0.0;
    row.bytes = report.bytes.value_or(0.0);
  }

  // What ends the process from here on leaves a recording that is known.
  static void tell_recorded(SweepRow row, const std::function<void(const SweepRow&)>& done) {
    row.done = true;
    done(row);
  }

  // Works on what was written, or, where nothing was, on the scene.
  void post_processing(std::size_t simulation, SweepRow& row) {
    FollowedRecording recording{swept_.source, rules_.post_processing_folder / fs::path(row.file).stem(),
                                rules_.threads, rules_.jobs, rules_.replace || row.recorded};
    recording.input.simulation = static_cast<std::int64_t>(simulation) + 1;
    if (!rules_.discard && !recording.input.held) {
      recording.input.script = std::exchange(recording.input.path, (rules_.folder / row.file).string());
      // Counts are volts again by the LSB that was found for them.
      const scene::FileFormat format = scene_.simulations.at(simulation).format;
      if (row.lsb_estimated && row.run.lsb_v > 0.0 && raster::holds_counts(format, rules_.counts))
        recording.input.overrides.settings.push_back(
            fmt::format("Simulation{}.lsb={}V", simulation + 1, core::format_number(row.run.lsb_v)));
    }
    PostProcessed followed = follow(rules_.post_processing, recording, stop_);
    row.figures = std::move(followed.figures);
    row.followed = mark_of(rules_.post_processing);
    core::append(remarks_, std::move(followed.remarks));
  }

  void make_table(const scene::GeometryTable& table, const fs::path& folder, SweepRow& row) const {
    const auto count = [&](std::string_view piece) { row.bytes += static_cast<double>(piece.size()); };
    if (rules_.discard) {
      simulate::write_geometry_text(scene_, table, count, stop_);
      return;
    }
    core::OutputFile file(folder / row.file, rules_.replace);
    const auto write = [&](std::string_view piece) {
      file.write(std::as_bytes(std::span(piece)));
      count(piece);
    };
    simulate::write_geometry_text(scene_, table, write, stop_);
    file.commit();
  }

  const SweptScene& swept_;
  const scene::Scene& scene_;
  const VariationRules& rules_;
  const core::StopFlag* stop_;
  std::shared_ptr<const simulate::ResolvedScene> resolved_;
  core::Problems remarks_;
};

// What data files hold; a script only names them.
std::uint64_t hash_of_functions(const scene::SharedObject& object, std::uint64_t hash) {
  for (const scene::FunctionUse& use : scene::functions_of(object)) {
    if (use.file->empty()) continue;
    for (const core::SampledFunction& part : use.parts)
      for (const core::Knot& knot : part.knots)
        hash = core::fnv1a({reinterpret_cast<const char*>(&knot), sizeof knot}, hash);
  }
  return hash;
}

std::uint64_t hash_of_scene(const scene::Scene& scene) {
  std::uint64_t hash = core::fnv1a(scene::recorded_text(scene));
  for (const scene::Platform& platform : scene.platforms) hash = hash_of_functions(platform, hash);
  for (const scene::Radar& radar : scene.radars) hash = hash_of_functions(radar, hash);
  for (const scene::Target& target : scene.targets)
    if (!target.traits->gain_db.file.empty()) hash = hash_of_functions(target, hash);
  for (const scene::Cloud& cloud : scene.clouds) {
    hash = hash_of_functions(cloud, hash);
    if (cloud.points)
      hash = core::fnv1a({reinterpret_cast<const char*>(&cloud.points->sum), sizeof cloud.points->sum}, hash);
  }
  return hash;
}

}  // namespace

VariationRules variation_rules(const SweepRequest& request) {
  VariationRules rules{request.folder, request.engine, request.counts, request.header, request.force, request.discard};
  rules.post_processing = request.post_processing;
  rules.post_processing_folder = request.folder;
  return rules;
}

VariationNames::VariationNames(const scene::Scene& base, const Sweep& sweep, const std::vector<ProductJob>& products,
                               const VariationRules& rules)
    : sweep_(sweep), products_(products) {
  stamp_ = core::fnv1a(
      fmt::format("{} {} {} {}", core::program_version, simulate::name_of(rules.engine), rules.counts, rules.header),
      hash_of_scene(base));
  std::set<std::string> taken;
  for (const ProductJob& job : products) {
    // One stem for two products is fine where their extensions always differ, which is simplest never to rely on.
    const std::string stem = safe_word(job.path.stem().string());  // As it stands in the files' names.
    stems_.push_back(stem);
    for (int number = 2; !taken.insert(stems_.back()).second; ++number)
      stems_.back() = fmt::format("{}-{}", stem, number);
    format_axes_.push_back(no_axis);
    extensions_.push_back({job.path.extension().string()});
    for (std::size_t axis = 0; axis < sweep.axes().size() && !job.table; ++axis) {
      const scene::NamedField& field = sweep.axes()[axis].field;
      const bool ours = std::ranges::find(field.objects, scene::ObjectId{scene::ObjectKind::simulation, job.index}) !=
                        field.objects.end();
      if (!ours || field.field->id != "format") continue;
      format_axes_.back() = axis;
      extensions_.back().clear();
      for (const std::string& value : sweep.axes()[axis].values) {
        scene::Scene scene;
        scene.simulations.resize(job.index + 1);
        scene::NamedField alone = field;
        alone.objects = {{scene::ObjectKind::simulation, job.index}};
        // A value that is refused is reported when the variations are checked.
        const bool known = scene::set_named_field(scene, alone, value).empty();
        extensions_.back().emplace_back(known ? raster::extension_of(scene.simulations.back().format)
                                              : std::string_view());
      }
    }
  }
}

SweepRow VariationNames::row(std::size_t variation, std::size_t product) const {
  const ProductJob& job = products_.at(product);
  const std::size_t axis = format_axes_[product];
  const std::string& extension = extensions_[product][axis == no_axis ? 0 : sweep_.value_of(variation, axis)];
  SweepRow row;
  row.variation = variation;
  row.product = product;
  row.table = job.table;
  row.file = sweep_.file_name(stems_[product], extension, variation);
  row.stamp =
      core::fnv1a(fmt::format("{}\n{}{}", sweep_.label(variation), job.table ? "geometry" : "simulation", job.index),
                  stamp_ ^ sweep_.stamp(variation));
  return row;
}

core::Problems run_variation(const SweptScene& swept, const std::vector<ProductJob>& products,
                             std::vector<SweepRow*>& rows, const VariationRules& rules, const core::StopFlag* stop,
                             const std::function<void(const SweepRow&)>& done) {
  VariationRunner runner(swept, rules, stop);
  for (SweepRow* row : rows) {
    runner.make(products.at(row->product), *row, done);
    done(*row);
  }
  return runner.take_remarks();
}

}  // namespace sarsim::workflow
