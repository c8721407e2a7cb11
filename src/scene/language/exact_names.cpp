#include "scene/language/exact_names.hpp"

#include <string>

#include "core/text/number_text.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

Scene with_exact_names(Scene scene) {
  Scene named;
  named.platforms = scene.platforms;
  named.radars = scene.radars;
  SceneIndex index(named);
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    constexpr bool of_radar = Kind<Object>::belongs_to_radar;
    const Object* last = nullptr;  // that was given another name
    for (Object& object : scene.*kind.list) {
      const std::string* const name = carrier_in(object);
      if (name == nullptr || name->empty()) continue;
      const std::size_t meant = of_radar ? index.radar(*name) : index.platform(*name);
      std::string exact = *name;
      if (meant != not_found)
        exact = of_radar ? named.radars[meant].name : named.platforms[meant].name;
      else if (!of_radar && core::equal_ignoring_case(*name, world_name()))
        exact = world_name();
      if (exact == *name) continue;
      set_carrier(object, exact);
      if (last != nullptr) share_equal(object, *last);
      last = &object;
    }
  });
  return scene;
}

}  // namespace sarsim::scene
