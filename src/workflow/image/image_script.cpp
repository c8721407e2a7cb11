#include "workflow/image/image_script.hpp"

#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "core/report/refused.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/open_raster.hpp"
#include "raster/table/product_attributes.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/sources.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/recording_input.hpp"
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

// Of the scene that the source describes or carries; nothing where that cannot be read.
std::optional<std::string> checksum_of(const std::string& source, const std::string& script) {
  const std::string& file = script.empty() ? source : script;
  scene::ScriptReading reading;
  if (holds_script(file) || !script.empty()) {
    reading = scene::read_scene_file(file);
  } else {
    const raster::OpenedRaster opened = raster::open_raster(raster::Integrity::whole, file, {});
    if (!opened.raster) return std::nullopt;
    const std::string text = raster::attribute_of(opened.raster->info().attributes, "script");
    if (text.empty()) return std::nullopt;
    if (scene::language::includes_files(text)) return std::nullopt;
    reading = scene::read_scene_text(text, file, scene::disk_loader(fs::path(file).parent_path()));
  }
  if (core::has_errors(reading.problems)) return std::nullopt;
  if (core::has_errors(read_files_of(reading.scene, fs::path(file).parent_path(), {core::thread_count(0)})))
    return std::nullopt;
  return workflow::script_sum(reading.scene);
}

// The first place where a file of the header is.
std::optional<std::string> found(const std::string& path, const std::string& from_image, const fs::path& image) {
  const fs::path folder = folder_of(image);
  std::error_code ignored;
  if (!from_image.empty())
    if (const fs::path place = (folder / from_image).lexically_normal(); fs::exists(place, ignored))
      return place.string();
  if (fs::exists(path, ignored)) return path;
  if (const fs::path beside = folder / fs::path(path).filename(); fs::exists(beside, ignored)) return beside.string();
  return std::nullopt;
}

}  // namespace

void add_way_back(raster::EnviHeader& header, const ImageOrigin& origin, const fs::path& image) {
  header.fields.emplace_back("source from image", seen_from(image, origin.source));
  header.fields.emplace_back("script from image", seen_from(image, origin.script));
  header.fields.emplace_back("script checksum", checksum_of(origin.source, origin.script).value_or(""));
}

WayBack way_back(const raster::EnviHeader& header, const ImageOrigin& origin, const fs::path& image,
                 const std::string& script) {
  const auto find = [&](const std::string& path, const char* field) {
    const auto place = found(path, header.field(field).value_or(""), image);
    if (!place)
      throw core::Refused(fmt::format("'{}', which '{}' was made from, is not there", path, image.string()),
                          "bring it back, or name the script that it was made from with --script");
    return *place;
  };
  // A script alone: the source was a script, too, or carries its own.
  if (!script.empty() && origin.script.empty()) return {script, {}, {}};
  WayBack way;
  way.source = find(origin.source, "source from image");
  if (!script.empty()) return {way.source, script, {}};
  if (!origin.script.empty()) way.script = find(origin.script, "script from image");
  const std::string then = header.field("script checksum").value_or("");
  const auto now = then.empty() ? std::nullopt : checksum_of(way.source, way.script);
  if (now && *now != then)
    way.problems.push_back(core::problem_of(
        core::Severity::warning, fmt::format("the script is not the one that '{}' was made from", image.string()),
        way.script.empty() ? way.source : way.script, {},
        "targets may be elsewhere: focus again, or name the script of that time with --script"));
  return way;
}

}  // namespace sarsim::workflow
