// How programs put scenes of sarsim.h together.

#include <span>
#include <string>

#include "capi/call.hpp"
#include "core/report/invalid_request.hpp"
#include "workflow/input/scene_building.hpp"

using namespace sarsim;

namespace {

workflow::SceneInput& changed(sarsim_scene* scene, const char* name) { return capi::given(scene, name).input; }

scene::ObjectKind kind_named(const char* word) {
  const std::string given = &capi::given(word, "kind");
  if (const auto kind = scene::kind_called(given)) return *kind;
  throw capi::BadArgument("'" + given + "' is not a kind of object");
}

scene::ObjectId object_named(const scene::Scene& scene, const char* kind, size_t index) {
  const scene::ObjectId id{kind_named(kind), index};
  if (!scene::has_object(scene, id)) throw capi::BadArgument("the scene has no such object");
  return id;
}

// As many numbers as a caller says are there.
std::span<const double> numbers(const double* first, size_t count, const char* name) {
  if (count == 0) return {};
  if (count > SIZE_MAX / sizeof(double)) throw capi::BadArgument(std::string(name) + ": more than memory can hold");
  return {&capi::given(first, name), count};
}

// Three numbers for each point.
std::span<const double> places(const double* first, size_t count, const char* name) {
  if (count > SIZE_MAX / 3) throw capi::BadArgument(std::string(name) + ": more than memory can hold");
  return numbers(first, 3 * count, name);
}

core::Interpolation method_called(const char* word) {
  const std::string method = word == nullptr ? "linear" : word;
  if (method == "linear") return core::Interpolation::linear;
  if (method == "cubic") return core::Interpolation::cubic;
  if (method == "mfilter") return core::Interpolation::low_pass;
  throw core::InvalidRequest("'" + method + "' is not a method of interpolation", "linear, cubic or mfilter");
}

}  // namespace

sarsim_status sarsim_scene_new(const char* name, sarsim_scene** scene, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_scene*& result = capi::cleared(scene, "sarsim_scene_new: scene");
    result = new sarsim_scene{workflow::empty_scene(name != nullptr ? name : "scene")};
  });
}

sarsim_status sarsim_scene_get_number(const sarsim_scene* scene, const char* field, double* value,
                                      sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    double& result = capi::given(value, "sarsim_scene_get_number: value");
    result = workflow::field_number(capi::given(scene, "sarsim_scene_get_number: scene").input,
                                    &capi::given(field, "sarsim_scene_get_number: field"));
  });
}

sarsim_status sarsim_scene_set_number(sarsim_scene* scene, const char* field, double value,
                                      sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    workflow::set_field_number(changed(scene, "sarsim_scene_set_number: scene"),
                               &capi::given(field, "sarsim_scene_set_number: field"), value);
  });
}

sarsim_status sarsim_scene_set_points(sarsim_scene* scene, const char* field, size_t count, size_t parts,
                                      const double* x, const double* y, const char* method,
                                      sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    workflow::SceneInput& input = changed(scene, "sarsim_scene_set_points: scene");
    if (parts == 0 || count > SIZE_MAX / parts)
      throw capi::BadArgument("sarsim_scene_set_points: at least one part is expected");
    workflow::set_field_points(input, &capi::given(field, "sarsim_scene_set_points: field"),
                               x == nullptr ? std::span<const double>() : numbers(x, count, "x"),
                               numbers(y, parts * count, "sarsim_scene_set_points: y"), count, method_called(method));
  });
}

sarsim_status sarsim_scene_add(sarsim_scene* scene, const char* kind, const char* name, size_t* index,
                               sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const size_t made =
        workflow::add_object(changed(scene, "sarsim_scene_add: scene"), kind_named(kind), name != nullptr ? name : "");
    if (index != nullptr) *index = made;
  });
}

sarsim_status sarsim_scene_remove(sarsim_scene* scene, const char* kind, size_t index, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    workflow::SceneInput& input = changed(scene, "sarsim_scene_remove: scene");
    workflow::remove_object(input, object_named(input.scene, kind, index));
  });
}

sarsim_status sarsim_scene_add_targets(sarsim_scene* scene, const char* platform, size_t count,
                                       const double* positions_m, const double* rcs_m2, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    workflow::add_targets(changed(scene, "sarsim_scene_add_targets: scene"),
                          &capi::given(platform, "sarsim_scene_add_targets: platform"),
                          places(positions_m, count, "sarsim_scene_add_targets: positions_m"),
                          numbers(rcs_m2, rcs_m2 != nullptr ? count : 0, "sarsim_scene_add_targets: rcs_m2"));
  });
}

sarsim_status sarsim_scene_add_cloud(sarsim_scene* scene, const char* platform, const char* file, size_t count,
                                     const double* positions_m, const double* rcs_m2, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    workflow::add_cloud(changed(scene, "sarsim_scene_add_cloud: scene"),
                        &capi::given(platform, "sarsim_scene_add_cloud: platform"),
                        &capi::given(file, "sarsim_scene_add_cloud: file"),
                        places(positions_m, count, "sarsim_scene_add_cloud: positions_m"),
                        numbers(rcs_m2, rcs_m2 != nullptr ? count : 0, "sarsim_scene_add_cloud: rcs_m2"));
  });
}

sarsim_status sarsim_scene_fields(const sarsim_scene* scene, const char* kind, size_t index, sarsim_text** text,
                                  sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(text, "sarsim_scene_fields: text");
    const workflow::SceneInput& input = capi::given(scene, "sarsim_scene_fields: scene").input;
    const std::string word = &capi::given(kind, "kind");
    result = capi::text_handle(word == "options" ? workflow::option_fields_json(input)
                               : word == "atmosphere"
                                   ? workflow::atmosphere_fields_json(input)
                                   : workflow::fields_json(input, object_named(input.scene, kind, index)));
  });
}

sarsim_status sarsim_schema(sarsim_text** text, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(text, "sarsim_schema: text");
    result = capi::text_handle(workflow::schema_json());
  });
}
