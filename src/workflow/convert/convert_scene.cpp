#include "workflow/convert/convert_scene.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "scene/language/exact_names.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/script/writer.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_words.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// The fields of an object that come back from a script otherwise than they were.
template <class Object>
void add_unsayable(const Object& object, const Object& back, const core::Subject& subject, core::Problems& problems) {
  for (const auto& field : scene::table_of<Object>().fields()) {
    if (!scene::table_of<Object>().applies(object, field) || field.get(object) == field.get(back)) continue;
    core::Problem problem =
        core::error(fmt::format("a script of the language of 1998 cannot say the {} as it is", field.spec.words))
            .hint("change it, or keep the scene in format 2")
            .at(subject);
    problem.subject.field = field.spec.problem_place();
    problems.push_back(std::move(problem));
  }
}

std::string script_text(const SceneInput& input) {
  std::string text = scene::write_script(input.scene);
  const fs::path folder = input.sources.empty() ? fs::path() : input.sources.front().parent_path();
  const scene::ScriptReading back = scene::read_script(text, "", scene::disk_loader(folder));
  core::Problems problems;
  scene::for_each_kind([&](const auto& kind) {
    const auto& objects = input.scene.*kind.list;
    const auto& others = back.scene.*kind.list;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const core::Subject subject{std::string(kind.name), i, {}};
      if (i < others.size())
        add_unsayable(objects[i], others[i], subject, problems);
      else
        problems.push_back(core::error(fmt::format("a script cannot hold {} {}", kind.name, i + 1)));
    }
  });
  if (problems.empty()) return text;
  scene::locate(problems, input.places);
  throw core::InvalidRequest(std::move(problems));
}

// All names of a scene in a row.
std::string text_of_names(const scene::Scene& scene) {
  std::string text;
  for (const scene::Platform& platform : scene.platforms) text += platform.name + "\n";
  for (const scene::Radar& radar : scene.radars) text += radar.name + "\n";
  for (const scene::Simulation& simulation : scene.simulations) text += simulation.file + "\n";
  return text;
}

}  // namespace

std::string scene_text(const SceneInput& input, scene::Language language, bool everything) {
  if (language == scene::Language::script) return script_text(input);
  const scene::Saying saying = everything ? scene::Saying::everything : scene::Saying::differences;
  if (input.language == scene::Language::format_2) return scene::write_format_2(input.scene, saying);
  return scene::write_format_2(scene::with_exact_names(input.scene), saying);
}

core::Problems convert_scene(const ConvertSceneRequest& request, const core::WorkControl& control) {
  const auto language = language_of_name(request.output);
  if (!language) {
    const auto format = raster::format_from_path(request.output);
    throw core::InvalidRequest(
        fmt::format("'{}' has no extension of a scene format", request.output),
        format ? fmt::format("to record the scene, use sarsim run {} --format {}", request.input, format_word(*format))
               : "end it with .toml for format 2 or .scr for the language of 1998");
  }
  const SceneInput input = read_scene(request.input, request.overrides, CheckLevel::files, control);
  expect_usable(input);
  expect_free_outputs({request.output}, {input.sources, request.force, "OUT"});
  const std::string text = scene_text(input, *language);
  core::OutputFile file(request.output, request.force);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
  core::Problems remarks = input.problems;
  if (*language == scene::Language::format_2 &&
      core::valid_utf8(text_of_names(input.scene)) != text_of_names(input.scene))
    remarks.push_back(
        core::warning("names that are not in UTF-8 were taken for Latin-1").hint("check the names in the new file"));
  const fs::path from = fs::absolute(request.input).parent_path().lexically_normal();
  const fs::path to = fs::absolute(request.output).parent_path().lexically_normal();
  if (from != to && !data_files_of(input.scene, fs::path(request.input).parent_path()).empty())
    remarks.push_back(core::warning("the scene names data files, which are looked for beside it")
                          .hint(fmt::format("copy them to {}", to.string())));
  return remarks;
}

}  // namespace sarsim::workflow
