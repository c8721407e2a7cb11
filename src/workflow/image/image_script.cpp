#include "workflow/image/image_script.hpp"

#include <cstdint>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/product_attributes.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/sources.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/input/sample_input.hpp"
#include "workflow/input/script_sum.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& image) { return image.has_parent_path() ? image.parent_path() : fs::path("."); }

std::string seen_from(const fs::path& image, const std::string& path) {
  if (path.empty()) return {};
  std::error_code failure;
  const fs::path seen = fs::proximate(path, folder_of(image), failure);
  return failure ? std::string() : seen.string();
}

// @param file  that the scene was read from
std::optional<std::string> sum_of_scene(scene::ScriptReading reading, const std::string& file,
                                        const core::StopFlag* stop) {
  const core::WorkControl control{core::thread_count(0), stop};
  if (core::has_errors(reading.problems)) return std::nullopt;
  if (core::has_errors(read_files_of(reading.scene, fs::path(file).parent_path(), control))) return std::nullopt;
  return workflow::script_sum(reading.scene);
}

// Of the scene inside a recording.
std::optional<std::string> scene_sum_in(const raster::Raster& recording, const std::string& file,
                                        const core::StopFlag* stop) {
  const std::string text = raster::attribute_of(recording.info().attributes, "script");
  if (text.empty() || scene::language::includes_files(text)) return std::nullopt;
  return sum_of_scene(scene::read_scene_text(text, file, scene::disk_loader(fs::path(file).parent_path())), file, stop);
}

// Of the scene that the source describes or carries; nothing where that cannot be read.
// @param recording  the source, where it is open already
std::optional<std::string> checksum_of(const std::string& source, const std::string& script, const core::StopFlag* stop,
                                       const raster::Raster* recording = nullptr) {
  const std::string& file = script.empty() ? source : script;
  if (!script.empty() || holds_script(file)) return sum_of_scene(scene::read_scene_file(file), file, stop);
  if (recording != nullptr) return scene_sum_in(*recording, file, stop);
  const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, file, {}, stop);
  return opened.raster ? scene_sum_in(*opened.raster, file, stop) : std::nullopt;
}

// Of the samples of a recording; nothing of a script.
// @throw  whatever says why they cannot be read
std::optional<std::string> sum_of_samples(const std::string& source, const std::string& script, std::size_t simulation,
                                          const core::StopFlag* stop) {
  std::error_code ignored;
  if (!fs::exists(source, ignored) || holds_script(source)) return std::nullopt;
  SampleArguments samples;
  samples.script = script;
  core::Observer alone;
  alone.stop = stop;
  const raster::RasterHints hints = script.empty()
                                        ? raster::RasterHints{}
                                        : hints_for(source, samples, static_cast<std::int64_t>(simulation) + 1, alone);
  raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, source, hints, stop);
  if (!opened.raster) throw core::InvalidRequest(core::ranked(std::move(opened.problems)));
  return samples_sum(*opened.raster, stop);
}

// The same; nothing also where they cannot be read.
std::optional<std::string> samples_checksum_of(const std::string& source, const std::string& script,
                                               std::size_t simulation, const core::StopFlag* stop) {
  try {
    return sum_of_samples(source, script, simulation, stop);
  } catch (const core::Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// A file that may be the one of the header.
struct FoundFile {
  std::string path;
  bool same_place = true;  // As seen from the image, or, where that is not known, as it was named.
};

std::vector<FoundFile> found(const std::string& path, const std::string& from_image, const fs::path& image) {
  const fs::path folder = folder_of(image);
  std::vector<FoundFile> files;
  const auto add = [&files](const fs::path& place, bool same_place) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) return;
    for (const FoundFile& file : files)
      if (fs::equivalent(file.path, place, ignored)) return;
    files.push_back({place.string(), same_place});
  };
  if (!from_image.empty()) add((folder / from_image).lexically_normal(), true);
  if (!path.empty()) {
    add(path, from_image.empty() || fs::path(path).is_absolute());
    add(folder / fs::path(path).filename(), false);
  }
  return files;
}

std::vector<FoundFile> expected(std::vector<FoundFile> files, const std::string& path, const fs::path& image) {
  if (files.empty())
    throw core::InvalidRequest(fmt::format("'{}', which '{}' was made from, is not there", path, image.string()),
                               "bring it back, or name the script that it was made from with --script");
  return files;
}

[[noreturn]] void refuse_namesake(const FoundFile& file, const char* what, const std::string& path,
                                  const fs::path& image) {
  throw core::InvalidRequest(
      fmt::format("'{}' is not the file that '{}' was made from: it has other {}", file.path, image.string(), what),
      fmt::format("bring back '{}' as it was, or name the script that the image was made from with --script", path));
}

core::Problem note_of(std::string text) { return core::note(std::move(text)); }

core::Problem warning_of_scene(const std::string& file, const fs::path& image) {
  return core::warning(fmt::format("the script is not the one that '{}' was made from", image.string()))
      .found(file)
      .hint("targets may be elsewhere: focus again, or name the script of that time with --script");
}

// The recording with the samples that the header has the sum of.
std::string source_with_samples(const std::vector<FoundFile>& sources, const std::string& sum,
                                const std::string& script, const ImageOrigin& origin, const fs::path& image,
                                core::Problems& problems, const core::StopFlag* stop) {
  for (const FoundFile& file : sources) {
    if (samples_checksum_of(file.path, script, origin.simulation, stop) != sum) continue;
    if (!file.same_place)
      problems.push_back(note_of(fmt::format("'{}' is taken for '{}': it has the samples that '{}' was made from",
                                             file.path, origin.source, image.string())));
    return file.path;
  }
  // Nobody knows the samples of a file that cannot be read: then this says why.
  static_cast<void>(sum_of_samples(sources.front().path, script, origin.simulation, stop));
  refuse_namesake(sources.front(), "samples", origin.source, image);
}

// Of an image of an earlier version, which says only of which scene it is.
std::string source_by_name(const std::string& file, const std::string& scene_sum, const std::string& script,
                           const fs::path& image, core::Problems& problems, const core::StopFlag* stop) {
  const auto now = scene_sum.empty() || !script.empty() ? std::nullopt : checksum_of(file, script, stop);
  problems.push_back(now && *now != scene_sum
                         ? warning_of_scene(file, image)
                         : note_of(fmt::format("'{}' does not say which samples it was made from (images of earlier "
                                               "versions do not): '{}' is taken by its name",
                                               image.string(), file)));
  return file;
}

// The same of a scene; one that was edited where it was is taken with a warning.
std::string scene_with_sum(const std::vector<FoundFile>& files, const std::string& sum, const std::string& path,
                           const fs::path& image, core::Problems& problems, const core::StopFlag* stop) {
  if (sum.empty()) return files.front().path;
  bool known = false;
  for (const FoundFile& file : files) {
    const auto now = checksum_of(file.path, {}, stop);
    known |= now.has_value();
    if (!now || *now != sum) continue;
    if (!file.same_place)
      problems.push_back(note_of(fmt::format("'{}' is taken for '{}': it has the scene that '{}' was made from",
                                             file.path, path, image.string())));
    return file.path;
  }
  const FoundFile& first = files.front();
  if (!known) return first.path;
  if (!first.same_place) refuse_namesake(first, "objects", path, image);
  problems.push_back(warning_of_scene(first.path, image));
  return first.path;
}

}  // namespace

void add_way_back(raster::EnviHeader& header, const ImageOrigin& origin, const fs::path& image,
                  const core::StopFlag* stop) {
  header.fields.emplace_back("source from image", seen_from(image, origin.source));
  header.fields.emplace_back("script from image", seen_from(image, origin.script));
  header.fields.emplace_back("script checksum",
                             checksum_of(origin.source, origin.script, stop, origin.recording.get()).value_or(""));
  // Of a scene that is the source itself there are no samples.
  if (origin.recording != nullptr)
    header.fields.emplace_back("source checksum", samples_sum(*origin.recording, stop));
  else if (auto sum = samples_checksum_of(origin.source, origin.script, origin.simulation, stop))
    header.fields.emplace_back("source checksum", std::move(*sum));
}

WayBack way_back(const raster::EnviHeader& header, const ImageOrigin& origin, const fs::path& image,
                 const std::string& script, const core::StopFlag* stop) {
  const std::string scene_sum = header.field("script checksum").value_or("");
  WayBack way;
  // A script alone: the source was a script, too, or carries its own.
  if (!script.empty() && origin.script.empty()) {
    way.source = script;
    if (const auto now = scene_sum.empty() ? std::nullopt : checksum_of(script, {}, stop); now && *now != scene_sum)
      way.problems.push_back(
          note_of(fmt::format("the expected values are those of '{}', another scene than that which "
                              "'{}' was made from",
                              script, image.string())));
    return way;
  }
  const std::vector<FoundFile> sources =
      expected(found(origin.source, header.field("source from image").value_or(""), image), origin.source, image);
  way.script = script;
  if (script.empty() && !origin.script.empty())
    way.script = scene_with_sum(
        expected(found(origin.script, header.field("script from image").value_or(""), image), origin.script, image),
        scene_sum, origin.script, image, way.problems, stop);
  if (holds_script(sources.front().path)) {
    way.source = scene_with_sum(sources, scene_sum, origin.source, image, way.problems, stop);
    return way;
  }
  // A header that was edited, or copied by another program, may have the name alone.
  std::optional<std::string> sum = header.field("source checksum");
  if (sum && core::trimmed(*sum).empty()) sum.reset();
  if (!sum)
    way.source = source_by_name(sources.front().path, scene_sum, way.script, image, way.problems, stop);
  else
    way.source = source_with_samples(sources, *sum, way.script, origin, image, way.problems, stop);
  // The scene inside the recording may have been edited, too: then targets are expected elsewhere.
  if (sum && way.script.empty() && !scene_sum.empty())
    if (const auto now = checksum_of(way.source, {}, stop); now && *now != scene_sum)
      way.problems.push_back(warning_of_scene(way.source, image));
  return way;
}

}  // namespace sarsim::workflow
