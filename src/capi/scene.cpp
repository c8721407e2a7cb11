// The scenes of sarsim.h.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "capi/call.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "core/text/json.hpp"
#include "scene/language/explanation.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/field_names.hpp"
#include "workflow/check/check_scene.hpp"
#include "workflow/convert/convert_scene.hpp"

using namespace sarsim;

namespace {

workflow::SceneOverrides overrides_of(const sarsim_scene_options* given) {
  const auto options = capi::taken(given, "options");
  workflow::SceneOverrides overrides;
  for (std::size_t i = 0; i < capi::told_count(options.let_count, capi::max_words, "options->let_count"); ++i)
    overrides.let.emplace_back(&capi::given((&capi::given(options.let, "options->let"))[i], "options->let"));
  return overrides;
}

// By all threads, unless the caller says how.
core::WorkControl control_of(const sarsim_scene_options* given) {
  const auto options = capi::taken(given, "options");
  if (options.work == nullptr) return {core::thread_count(0), nullptr};
  const sarsim_work how = capi::taken(options.work, "options->work");
  return capi::observer_of(how).control(core::thread_count(how.threads));
}

// Nothing could end the work that waits for one.
void expect_no_pipe(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_fifo(file, ignored)) return;
  throw core::InvalidRequest(
      {core::error("the file is a pipe, which may never end")
           .hint("read it and give its text to sarsim_scene_read_text, or say with options->work how to stop")
           .in(file)});
}

// A scene whose text holds no mistake; else all of them, those of the values of sound objects too.
template <class Read>
std::unique_ptr<sarsim_scene> sound_scene(const Read& read, core::Problems& found) {
  auto scene = std::make_unique<sarsim_scene>();
  scene->input = read(workflow::CheckLevel::files);
  if (core::has_errors(scene->input.problems)) throw core::InvalidRequest(read(workflow::CheckLevel::values).problems);
  found = scene->input.problems;
  return scene;
}

scene::ObjectKind kind_of(const char* word) {
  const std::string given = &capi::given(word, "kind");
  const auto kind = scene::kind_called(given);
  if (!kind) throw capi::BadArgument("'" + given + "' is not a kind of object");
  return *kind;
}

}  // namespace

sarsim_status sarsim_scene_read_file(const char* path, const sarsim_scene_options* options, sarsim_scene** scene,
                                     sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    sarsim_scene*& result = capi::cleared(scene, "sarsim_scene_read_file: scene");
    const std::string file = &capi::given(path, "sarsim_scene_read_file: path");
    const workflow::SceneOverrides overrides = overrides_of(options);
    const core::WorkControl control = control_of(options);
    if (control.stop == nullptr) expect_no_pipe(file);
    const auto read = [&](workflow::CheckLevel check_level) {
      return workflow::read_scene(file, overrides, check_level, control);
    };
    result = sound_scene(read, found).release();
  });
}

sarsim_status sarsim_scene_read_text(const char* text, size_t length, const char* name,
                                     const sarsim_scene_options* options, sarsim_scene** scene,
                                     sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    sarsim_scene*& result = capi::cleared(scene, "sarsim_scene_read_text: scene");
    static_cast<void>(capi::told_count(length, PTRDIFF_MAX, "sarsim_scene_read_text: length"));
    const std::string_view all(length > 0 ? &capi::given(text, "sarsim_scene_read_text: text") : "", length);
    const std::string file = name != nullptr ? name : "scene";
    const workflow::SceneOverrides overrides = overrides_of(options);
    const core::WorkControl control = control_of(options);
    const auto read = [&](workflow::CheckLevel check_level) {
      return workflow::read_scene_text(all, file, overrides, check_level, control);
    };
    result = sound_scene(read, found).release();
  });
}

sarsim_status sarsim_scene_copy(const sarsim_scene* scene, sarsim_scene** copy, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_scene*& result = capi::cleared(copy, "sarsim_scene_copy: copy");
    result = new sarsim_scene(capi::given(scene, "sarsim_scene_copy: scene"));
  });
}

void sarsim_scene_free(sarsim_scene* scene) { delete scene; }

sarsim_status sarsim_scene_text(const sarsim_scene* scene, sarsim_language language, sarsim_text** text,
                                sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(text, "sarsim_scene_text: text");
    if (language != SARSIM_FORMAT_2 && language != SARSIM_SCRIPT)
      throw capi::BadArgument("sarsim_scene_text: no such language");
    result = capi::text_handle(
        workflow::scene_text(capi::given(scene, "sarsim_scene_text: scene").input,
                             language == SARSIM_SCRIPT ? scene::Language::script : scene::Language::format_2));
  });
}

sarsim_status sarsim_scene_check(const sarsim_scene* scene, const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    const sarsim_work how = capi::work_of(work);
    const core::Observer observer = capi::observer_of(how);
    const core::WorkControl control = observer.control(core::thread_count(how.threads));
    workflow::SceneInput input = workflow::check_again(capi::given(scene, "sarsim_scene_check: scene").input,
                                                       workflow::CheckLevel::echoes, control);
    workflow::add_remarks(input, control);
    workflow::expect_usable(input);
    found = std::move(input.problems);
  });
}

sarsim_status sarsim_scene_count(const sarsim_scene* scene, const char* kind, size_t* count,
                                 sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    size_t& result = capi::given(count, "sarsim_scene_count: count");
    result = scene::count_of(capi::given(scene, "sarsim_scene_count: scene").input.scene, kind_of(kind));
  });
}

sarsim_status sarsim_scene_name(const sarsim_scene* scene, const char* kind, size_t index, sarsim_text** name,
                                sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(name, "sarsim_scene_name: name");
    const scene::Scene& whole = capi::given(scene, "sarsim_scene_name: scene").input.scene;
    const scene::ObjectId id{kind_of(kind), index};
    if (!scene::has_object(whole, id)) throw capi::BadArgument("sarsim_scene_name: the scene has no such object");
    result = capi::text_handle(scene::address_of(whole, id));
  });
}

sarsim_status sarsim_scene_get(const sarsim_scene* scene, const char* field, sarsim_text** value,
                               sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(value, "sarsim_scene_get: value");
    const workflow::SceneInput& input = capi::given(scene, "sarsim_scene_get: scene").input;
    result = capi::text_handle(workflow::field_value(input, &capi::given(field, "sarsim_scene_get: field")));
  });
}

sarsim_status sarsim_scene_set(sarsim_scene* scene, const char* field, const char* value, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    workflow::SceneInput& input = capi::given(scene, "sarsim_scene_set: scene").input;
    found = workflow::set_field_value(input, &capi::given(field, "sarsim_scene_set: field"),
                                      &capi::given(value, "sarsim_scene_set: value"));
  });
}

sarsim_status sarsim_explain(const char* word, sarsim_style style, sarsim_text** text, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(text, "sarsim_explain: text");
    if (style != SARSIM_WORDS && style != SARSIM_JSON) throw capi::BadArgument("sarsim_explain: no such style");
    const auto explanation = scene::language::explain(&capi::given(word, "sarsim_explain: word"));
    if (!explanation.failure.empty()) throw core::InvalidRequest(explanation.failure, explanation.hint);
    core::JsonWriter json;
    if (style == SARSIM_JSON) scene::language::write_json(json, explanation);
    result = capi::text_handle(style == SARSIM_JSON ? json.text() : scene::language::text_of(explanation));
  });
}
