#include "workflow/input/recording_input.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <complex>
#include <filesystem>
#include <iterator>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/os/input_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/pose_axes.hpp"
#include "raster/table/product_attributes.hpp"
#include "raster/table/sample_gate.hpp"
#include "scene/check/check.hpp"
#include "scene/language/format_mark.hpp"
#include "scene/language/json_text.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/sources.hpp"
#include "scene/schema/option_words.hpp"
#include "simulate/plan/product.hpp"
#include "workflow/input/carried_problems.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

void expect_sound(core::Problems problems) {
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
}

// The simulation that is named, or else the first that suits, or else the first.
// @param script  where it stands
std::size_t simulation_of_scene(const scene::Scene& scene, const std::string& script,
                                std::optional<std::int64_t> wanted, const Suits& suits) {
  if (scene.simulations.empty()) {
    core::InvalidRequest none("the scene defines no recording", "add a [[recording]]; in a .scr, a $SIMULATION");
    none.problems.front().place.file = script;
    throw none;
  }
  if (wanted) {
    const auto number = static_cast<std::size_t>(*wanted);
    if (number >= 1 && number <= scene.simulations.size()) return number - 1;
    throw core::InvalidRequest(fmt::format("--simulation: the scene has no recording {}", number),
                               fmt::format("it has {}", scene.simulations.size()));
  }
  const auto first =
      std::ranges::find_if(scene.simulations, [&](const scene::Simulation& s) { return suits(scene, s); });
  return first == scene.simulations.end() ? 0 : static_cast<std::size_t>(first - scene.simulations.begin());
}

// The one that writes a file of that name.
std::size_t simulation_of_file(const scene::Scene& scene, const RecordingArguments& arguments, const Suits& suits) {
  if (!arguments.simulation) {
    const std::string hint = "say which one did with --simulation N";
    const fs::path file(arguments.path);
    if (const auto found = simulation_that_writes(file, scene, hint)) return *found;
    if (scene.simulations.size() > 1)
      throw core::InvalidRequest(fmt::format("no simulation of the script writes '{}'", file.filename().string()),
                                 hint);
  }
  const std::string& script = arguments.script.empty() ? arguments.path : arguments.script;
  return simulation_of_scene(scene, script, arguments.simulation, suits);
}

scene::Scene scene_of_script(const RecordingArguments& arguments, StoredRecording& recording,
                             const core::WorkControl& control) {
  SceneInput input = read_scene(arguments.script, arguments.overrides, CheckLevel::values, control);
  expect_usable(input);
  core::append(recording.problems, std::move(input.problems));
  recording.of_files = std::move(input.of_files);
  std::ranges::move(input.sources, std::back_inserter(recording.sources));
  return std::move(input.scene);
}

// Of a file that carries its script.
scene::Scene scene_in_file(const std::string& path, const raster::RasterInfo& info, StoredRecording& recording,
                           const core::WorkControl& control) {
  const auto script = std::ranges::find(info.attributes, "script", [](const auto& pair) { return pair.first; });
  if (script == info.attributes.end() || script->second.empty())
    throw core::InvalidRequest(fmt::format("'{}' does not say how it was recorded", path),
                               "give the script that wrote it with --script");
  scene::ScriptReading reading = read_carried_script(script->second, path);
  expect_sound(std::move(reading.problems));
  core::Problems of_clouds = without_quotes(read_files_of(reading.scene, fs::path(path).parent_path(), control));
  expect_sound(of_clouds);
  recording.of_files = of_clouds;
  core::append(recording.problems, std::move(of_clouds));
  expect_sound(scene::check(reading.scene));
  std::ranges::move(data_files_of(reading.scene, fs::path(path).parent_path()), std::back_inserter(recording.sources));
  return std::move(reading.scene);
}

// A file that carries its script was recorded with the options that stand there.
void expect_no_overrides(const RecordingArguments& arguments) {
  const SceneOverrides& overrides = arguments.overrides;
  const std::pair<const char*, bool> given[] = {
      {"--profile", overrides.profile.has_value()},     {"--pulse", overrides.pulse.has_value()},
      {"--tolerance", overrides.tolerance.has_value()}, {"--seed", overrides.seed.has_value()},
      {"--targets", !overrides.targets.empty()},        {"--set", !overrides.settings.empty()}};
  for (const auto& [option, there] : given)
    if (there)
      throw core::InvalidRequest(
          fmt::format("{} means nothing for '{}', which was recorded already", option, arguments.path),
          "leave it out, or give the script that it applies to with --script");
}

struct OpenedFile {
  std::shared_ptr<const raster::Raster> raster;
  std::optional<raster::RasterAxes> axes;
};

[[noreturn]] void refuse_image(const std::string& path, const std::string& says) {
  throw core::InvalidRequest(
      fmt::format("'{}' is a focused image, as its {} says, not a recording", path, says),
      fmt::format("sarsim measure {0} measures it, sarsim plot {0} -o FILE.png draws it; or name the "
                  "scene or the recording that it was made from",
                  path));
}

OpenedFile opened(const std::string& path, const raster::RasterHints& hints, core::Problems& problems,
                  const core::StopFlag* stop) {
  raster::OpenedRaster result = raster::open_raster(raster::Integrity::whole, path, hints, stop);
  if (!result.raster) throw core::InvalidRequest(core::ranked(std::move(result.problems)));
  const raster::RasterInfo& info = result.raster->info();
  if (!raster::attribute_of(info.attributes, "image_plane").empty()) refuse_image(path, "field image_plane");
  if (info.format == &raster::sicd_format()) refuse_image(path, "format SICD");
  core::append(problems, std::move(result.problems));
  return {result.raster, result.axes ? std::move(result.axes) : result.raster->axes()};
}

raster::RasterHints hints_of(const simulate::Acquisition& acquisition) {
  raster::RasterHints hints;
  hints.columns = acquisition.reception.columns;
  hints.rows = acquisition.timing.rows;
  hints.bits = acquisition.simulation.bits;  // The LSB is compared with the file's below, or taken where it has none.
  return hints;
}

void expect_shape(const raster::Raster& file, const simulate::Acquisition& acquisition, const std::string& path) {
  if (file.rows() == acquisition.timing.rows && file.columns() == acquisition.reception.columns) return;
  throw core::InvalidRequest(
      fmt::format("'{}' has {} rows of {} samples, but the script's simulation makes {} of {}", path, file.rows(),
                  file.columns(), acquisition.timing.rows, acquisition.reception.columns),
      "name the script and the simulation that wrote it with --script and --simulation");
}

// Compares what a file says of itself with its scene, which is what counts: a file that says something else was
// changed, or is not of this scene. One rule for all of it: a warning that names it, once each; but other processing is
// refused.
class Comparison {
 public:
  Comparison(const OpenedFile& file, const simulate::Acquisition& acquisition, core::Problems& problems)
      : file_(*file.raster),
        axes_(file.axes),
        acquisition_(acquisition),
        product_(simulate::product_of(acquisition, {})),
        problems_(problems) {}

  void run() {
    compare_facts();
    if (!axes_) return;
    compare("pulse_time_s", axes_->row_time_s, product_.row_time_s, acquisition_.link.repetition.mean_interval_s());
    compare("carrier_hz", axes_->row_carrier_hz, product_.row_carrier_hz, 0.0);
    const double spacing_m =
        acquisition_.reception.columns > 1 ? product_.column_range_m(1) - product_.column_range_m(0) : 1.0;
    compare("slant_range_m", axes_->column_range_m, product_.column_range_m, spacing_m);
    compare_poses(axes_->row_pose);
  }

 private:
  void remark(const std::string& what, std::string found, std::string expected) {
    problems_.push_back(core::warning("recording.not-of-script",
                                      fmt::format("{} of the file is not that of its script, which counts", what))
                            .found(std::move(found))
                            .expected(std::move(expected))
                            .hint("name the script that wrote it with --script")
                            .in(file_.info().path.string()));
  }

  static bool differ(double found, double expected, double step) {
    return !(std::abs(found - expected) <= 1e-3 * step + 1e-9 * std::abs(expected));  // True for NaN.
  }

  template <class Expected>
  void compare(const std::string& name, const std::vector<double>& found, const Expected& expected, double step) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double value = expected(i);
      if (!differ(found[i], value, step)) continue;
      return remark("the axis " + name, fmt::format("{} at position {}", core::format_number(found[i]), i),
                    core::format_number(value));
    }
  }

  // Numbers that only the scene gives otherwise: an LSB that the data have chosen is the file's own.
  void compare_facts() {
    const raster::RasterInfo& info = file_.info();
    const auto compare_fact = [&](const char* name, std::optional<double> found, double expected) {
      if (found && *found > 0.0 && expected > 0.0 && differ(*found, expected, 0.0))
        remark(name, core::format_number(*found), core::format_number(expected));
    };
    compare_fact("sample_rate_hz", info.sample_rate_hz, product_.sample_rate_hz);
    compare_fact("lsb_v", info.lsb_v, acquisition_.simulation.lsb_v);
    if (info.counts && info.bits > 0) compare_fact("bits", info.bits, acquisition_.simulation.bits);
    expect_processing();
    compare_word("radar", product_.radar);
    for (const auto& [name, word] : scene::option_words(product_.options)) compare_word(name, word);
    compare_word("seed", fmt::format("{}", product_.options.seed));
  }
  void compare_word(const std::string& name, const std::string& expected) {
    const std::string found = raster::attribute_of(file_.info().attributes, name);
    if (!found.empty() && found != expected) remark(name, found, expected);
  }

  // What is compressed would be compressed again, and raw echoes taken for pulses that are compressed.
  void expect_processing() {
    const std::string found = raster::attribute_of(file_.info().attributes, "processing");
    const std::string expected = raster::attribute_word(product_.processing);
    if (found.empty() || found == expected) return;
    throw core::InvalidRequest({core::error("processing of the file is not that of its script")
                                    .found(core::quoted_word(found))
                                    .expected(expected)
                                    .hint("give the scene that wrote it with --script")
                                    .in(file_.info().path.string())});
  }

  // To a thousandth of a wavelength, which is what focusing needs, and what rounding leaves of large numbers.
  void compare_poses(const std::vector<raster::RowPose>& found) {
    if (!product_.row_pose || found.size() != acquisition_.timing.rows) return;
    const double place_m = core::exact_light_speed_mps / acquisition_.link.carrier.highest_hz();
    std::vector<const raster::PoseAxis*> alike;
    for (const raster::PoseAxis& axis : raster::pose_axes) alike.push_back(&axis);
    for (std::size_t row = 0; row < found.size() && !alike.empty(); ++row) {
      const raster::RowPose expected = product_.row_pose(row);
      const auto same = [&](const raster::PoseAxis* axis) { return found[row].*axis->part == expected.*axis->part; };
      if (std::ranges::all_of(alike, same)) continue;  // As they are but for damage.
      std::erase_if(alike, [&](const raster::PoseAxis* axis) {
        const bool is_place = axis->part == &raster::RowPose::position_m;
        return is_another(*axis, found[row], expected, is_place ? place_m : 1.0, row);
      });
    }
  }
  bool is_another(const raster::PoseAxis& axis, const raster::RowPose& found, const raster::RowPose& expected,
                  double step, std::size_t row) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = (found.*axis.part)[k];
      const double own = (expected.*axis.part)[k];
      if (!differ(value, own, step)) continue;
      remark(fmt::format("the axis {}", axis.name),
             fmt::format("{} for {} at position {}", core::format_number(value), "xyz"[k], row),
             core::format_number(own));
      return true;
    }
    return false;
  }

  const raster::Raster& file_;
  const std::optional<raster::RasterAxes>& axes_;
  const simulate::Acquisition& acquisition_;
  raster::Product product_;
  core::Problems& problems_;
};

// Volts of a number of the file; 1 with a remark where counts have no known LSB.
double scale_of(const raster::RasterInfo& info, const simulate::Acquisition& acquisition, core::Problems& problems) {
  if (!info.counts) return 1.0;
  if (info.lsb_v && *info.lsb_v > 0.0) return *info.lsb_v;
  if (acquisition.simulation.lsb_v > 0.0) return acquisition.simulation.lsb_v;
  problems.push_back(
      core::warning("recording.unknown-lsb", "the volts of a count are not known: amplitudes are in counts")
          .hint("give the LSB in the script"));
  return 1.0;
}

// A single such sample would spoil every pixel of the result.
void expect_usable_row(const std::string& name, std::size_t row, std::span<const std::complex<double>> values) {
  const auto bad = std::ranges::find_if_not(values, raster::is_usable_sample);
  if (bad == values.end()) return;
  const auto column = static_cast<std::size_t>(bad - values.begin());
  throw core::InvalidRequest({raster::unusable_sample(name, row, column, *bad)});
}

core::SampleRows<double> rows_of(std::shared_ptr<const raster::Raster> file, double scale) {
  const std::size_t rows = file->rows();
  const std::size_t columns = file->columns();
  return {rows, columns, [file = std::move(file), scale](std::size_t row, std::span<std::complex<double>> out) {
            file->read_rows(row, 1, out);
            for (std::complex<double>& value : out) value *= scale;
            expect_usable_row(file->info().path.string(), row, out);
          }};
}

// What is in memory was decided with its plan.
StoredRecording held_recording(const RecordingArguments& arguments, const Suits& suits,
                               const std::function<core::Problems(const simulate::Acquisition&)>& problems_of,
                               const core::StopFlag* stop) {
  expect_no_overrides(arguments);
  if (!arguments.script.empty())
    throw core::InvalidRequest("--script is for files of samples", "a recording in memory has its scene with it");
  const SceneInput& input = arguments.held->input;
  StoredRecording recording;
  recording.scene = input.scene;
  recording.sources = input.sources;
  recording.of_files = input.of_files;
  recording.simulation = simulation_of_scene(recording.scene, arguments.path, arguments.simulation, suits);
  recording.acquisition = std::make_shared<const simulate::Acquisition>(
      simulate::acquisition_of(recording.scene, recording.simulation, nullptr, stop));
  core::append(recording.problems, problems_of(*recording.acquisition));
  expect_sound(recording.problems);
  const core::SampleRows<double>& rows = *arguments.held->rows;
  if (rows.rows != recording.acquisition->timing.rows || rows.columns != recording.acquisition->reception.columns)
    throw core::InvalidRequest(fmt::format("'{}' has {} rows of {} samples, but the scene's simulation makes {} of {}",
                                           arguments.path, rows.rows, rows.columns, recording.acquisition->timing.rows,
                                           recording.acquisition->reception.columns),
                               "give all rows of the recording that was planned");
  recording.rows = {rows.rows, rows.columns,
                    [rows, name = arguments.path](std::size_t row, std::span<std::complex<double>> out) {
                      rows.read(row, out);
                      expect_usable_row(name, row, out);
                    }};
  return recording;
}

// Whether the beginning of a file is format 2, or holds a command of the script language at the start of a line.
bool begins_like_script(const std::string& path) {
  const std::string text = core::beginning_of(path, std::size_t{1} << 16U);
  if (text.find('\0') != std::string::npos) return false;
  if (scene::is_format_2(text) || scene::language::is_json(text)) return true;
  for (std::size_t i = text.find('$'); i != std::string::npos; i = text.find('$', i + 1)) {
    const std::size_t before = text.find_last_not_of(" \t", i == 0 ? 0 : i - 1);
    const bool starts_line = i == 0 || before == std::string::npos || text[before] == '\n' || text[before] == '\r';
    if (starts_line && i + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0) return true;
  }
  return false;
}

}  // namespace

scene::ScriptReading read_carried_script(const std::string& script, const std::string& path) {
  const std::string name = path + " (its script)";
  if (scene::language::includes_files(script)) {
    throw core::InvalidRequest(
        {core::error("the script in the file includes other files")
             .expected("a script that is complete")
             .hint("record it again: what is recorded holds all that was included; or give its scene with --script")
             .in(name)});
  }
  scene::ScriptReading reading = scene::read_scene_text(script, name, scene::disk_loader(fs::path(path).parent_path()));
  for (core::Problem& problem : reading.problems)
    if (problem.place.file != name) drop_quotes(problem);
  return reading;
}

std::vector<fs::path> named_sources(const RecordingArguments& arguments) {
  if (arguments.held) return arguments.held->input.sources;
  std::vector<fs::path> sources{arguments.path};
  if (!arguments.script.empty()) sources.emplace_back(arguments.script);
  const fs::path script = arguments.script.empty() ? arguments.path : arguments.script;
  std::ranges::move(files_of(arguments.overrides, script.parent_path()), std::back_inserter(sources));
  return sources;
}

bool names_script(const RecordingArguments& arguments) {
  return arguments.held ? !arguments.held->rows : language_of_name(arguments.path).has_value();
}

// What was made from a recording may have its name and its shape.
void expect_no_image(const std::string& path) {
  std::string image = path;
  std::error_code ignored;
  if (core::equal_ignoring_case(fs::path(path).extension().string(), ".hdr"))
    for (const char* const ending : {".npy", ".img"})
      if (const fs::path beside = fs::path(path).replace_extension(ending); fs::exists(beside, ignored))
        image = beside.string();
  // The image of a scene or phase history has its name, and a header beside both.
  const raster::Format* const format = raster::row_from_path(image);
  const bool has_own = format == nullptr || format->envi_header || format == &raster::envi_format();
  if (language_of_name(image) || !has_own || !raster::has_envi_header(image)) return;
  refuse_image(image, fmt::format("header '{}'", raster::envi_header_of(image).filename().string()));
}

bool holds_script(const std::string& path) {
  const fs::path name(path);
  if (language_of_name(name)) return true;
  const auto format = raster::format_from_path(name);
  if (format && !raster::format_of(*format).script_like) return false;
  return begins_like_script(path);
}

bool records_pulses(const scene::Scene& /*scene*/, const scene::Simulation& simulation) {
  return simulation.processing != scene::Processing::srp;
}

ScriptedRecording open_script(const RecordingArguments& arguments, const Suits& suits,
                              const core::WorkControl& control) {
  if (!arguments.script.empty())
    throw core::InvalidRequest("--script is for files of samples", "a script needs no other script");
  if (!arguments.dataset.empty())
    throw core::InvalidRequest("--dataset is for HDF5 files of samples",
                               "leave it out: the echoes of a script are computed");
  ScriptedRecording recording{
      arguments.held ? check_again(arguments.held->input, CheckLevel::echoes, control, {}, arguments.overrides)
                     : read_scene(arguments.path, arguments.overrides, CheckLevel::echoes, control)};
  expect_usable(recording.input);
  recording.simulation = simulation_of_scene(recording.input.scene, arguments.path, arguments.simulation, suits);
  return recording;
}

StoredRecording open_recording(const RecordingArguments& arguments, const Suits& suits,
                               const std::function<core::Problems(const simulate::Acquisition&)>& problems_of,
                               const core::WorkControl& control) {
  if (arguments.held) return held_recording(arguments, suits, problems_of, control.stop);
  StoredRecording recording;
  recording.sources = {arguments.path};
  expect_no_image(arguments.path);
  OpenedFile file;
  if (arguments.script.empty()) {
    expect_no_overrides(arguments);
    raster::RasterHints hints;
    hints.dataset = arguments.dataset;
    file = opened(arguments.path, hints, recording.problems, control.stop);
  }
  recording.scene = file.raster ? scene_in_file(arguments.path, file.raster->info(), recording, control)
                                : scene_of_script(arguments, recording, control);
  recording.simulation = simulation_of_file(recording.scene, arguments, suits);
  recording.acquisition = std::make_shared<const simulate::Acquisition>(
      simulate::acquisition_of(recording.scene, recording.simulation, nullptr, control.stop));
  core::append(recording.problems, problems_of(*recording.acquisition));
  expect_sound(recording.problems);
  if (!file.raster) {
    raster::RasterHints hints = hints_of(*recording.acquisition);
    hints.dataset = arguments.dataset;
    file = opened(arguments.path, hints, recording.problems, control.stop);
  }
  expect_shape(*file.raster, *recording.acquisition, arguments.path);
  Comparison(file, *recording.acquisition, recording.problems).run();
  const double scale = scale_of(file.raster->info(), *recording.acquisition, recording.problems);
  recording.file = file.raster;
  recording.rows = rows_of(std::move(file.raster), scale);
  return recording;
}

}  // namespace sarsim::workflow
