#include "scene/model/read_path.hpp"

#include <algorithm>
#include <limits>

namespace sarsim::scene {

radar::TimeSpan needed_times(const Scene& scene) {
  constexpr double far_s = std::numeric_limits<double>::infinity();
  radar::TimeSpan span{far_s, -far_s};
  const auto include = [&](const auto& products) {
    for (const auto& product : products) {
      span.first_s = std::min(span.first_s, product.time_start_s);
      span.last_s = std::max(span.last_s, product.time_end_s);
    }
  };
  include(scene.simulations);
  include(scene.geometries);
  return span.first_s <= span.last_s ? span : radar::TimeSpan{};
}

}  // namespace sarsim::scene
