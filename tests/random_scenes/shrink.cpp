#include "random_scenes/shrink.hpp"

#include <cmath>
#include <vector>

#include "random_scenes/scene_maker.hpp"
#include "scene/schema/field_table.hpp"

namespace sarsim::test {

namespace {

using Change = std::function<void(scene::Scene&)>;

// What other objects refer to, and where things are.
bool is_place(const scene::FieldSpec& spec) {
  return spec.type == scene::FieldType::text || spec.type == scene::FieldType::name ||
         (spec.quantity == scene::Quantity::length && !std::isfinite(spec.range.low));
}

// Puts the initial value in the place of a field; what then becomes meaningful begins as it does in a form.
template <class Object>
void make_initial(const scene::FieldOf<Object>& field, Object& object) {
  const Object before = object;
  field.reset(object);
  scene::table_of<Object>().settle(before, object);
}

template <class Object>
void leave_out(std::vector<Change>& changes, std::vector<Object> scene::Scene::*list, const scene::Scene& scene) {
  const std::size_t count = (scene.*list).size();
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  if (count > 3) {
    changes.push_back([list, half](scene::Scene& s) { (s.*list).erase((s.*list).begin(), (s.*list).begin() + half); });
    changes.push_back([list, half](scene::Scene& s) { (s.*list).erase((s.*list).begin() + half, (s.*list).end()); });
  }
  for (std::size_t i = 0; i < count; ++i)
    changes.push_back(
        [list, i](scene::Scene& s) { (s.*list).erase((s.*list).begin() + static_cast<std::ptrdiff_t>(i)); });
}

// Of many objects all at once, and then field by field.
template <class Object>
void plainer_objects(std::vector<Change>& changes, std::vector<Object> scene::Scene::*list, const scene::Scene& scene) {
  for (std::size_t i = 0; i < (scene.*list).size(); ++i)
    changes.push_back([list, i](scene::Scene& s) {
      for (const auto& field : scene::table_of<Object>().fields())
        if (!is_place(field.spec)) make_initial(field, (s.*list)[i]);
    });
  for (std::size_t i = 0; i < (scene.*list).size(); ++i)
    for (const auto& field : scene::table_of<Object>().fields())
      if (!is_place(field.spec))
        changes.push_back([list, i, &field](scene::Scene& s) { make_initial(field, (s.*list)[i]); });
}

std::vector<Change> plainer(const scene::Scene& scene) {
  std::vector<Change> changes{keep_inline};
  leave_out(changes, &scene::Scene::targets, scene);
  leave_out(changes, &scene::Scene::surfaces, scene);
  leave_out(changes, &scene::Scene::geometries, scene);
  leave_out(changes, &scene::Scene::simulations, scene);
  leave_out(changes, &scene::Scene::radars, scene);
  leave_out(changes, &scene::Scene::platforms, scene);
  scene::for_each_kind([&](const auto& kind) { plainer_objects(changes, kind.list, scene); });
  for (const auto& field : scene::table_of<scene::RunOptions>().fields())
    changes.push_back([&field](scene::Scene& s) { field.reset(s.options); });
  return changes;
}

}  // namespace

scene::Scene shrunk(scene::Scene scene, const std::function<bool(const scene::Scene&)>& fails, int trials) {
  for (bool progress = true; progress;) {
    progress = false;
    // After a change that leaves an object out, later ones may mean objects that are no longer there: begin anew.
    for (const Change& change : plainer(scene)) {
      scene::Scene candidate = scene;
      change(candidate);
      if (candidate == scene || trials-- <= 0 || !fails(candidate)) continue;
      scene = std::move(candidate);
      progress = true;
      break;
    }
  }
  return scene;
}

}  // namespace sarsim::test
