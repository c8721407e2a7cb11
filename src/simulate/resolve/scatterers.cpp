#include "simulate/resolve/scatterers.hpp"

#include <algorithm>
#include <utility>

#include "core/report/expect.hpp"

namespace sarsim::simulate {

namespace {

// What a list keeps beside position, cross-section and platform.
Scatterer rest_of(const Scatterer& scatterer) {
  Scatterer rest = scatterer;
  rest.platform = 0;
  rest.position_m = {};
  rest.rcs_m2 = 1.0;
  return rest;
}

bool is_plain(const Scatterer& s) { return s.law == radar::ReflectivityLaw::isotropic && !s.jittered; }

}  // namespace

void ScattererList::push_back(const Scatterer& scatterer) {
  CORE_EXPECT(clouds_.empty());
  std::uint32_t rest = 0;
  if (!is_plain(scatterer)) {
    const Scatterer more = rest_of(scatterer);
    if (!(rests_.back() == more)) rests_.push_back(more);
    rest = static_cast<std::uint32_t>(rests_.size() - 1);
  }
  note_platform(scatterer.platform);
  single_.push_back({scatterer.position_m, scatterer.rcs_m2, scatterer.platform, rest});
  count_ = single_.size();
}

void ScattererList::add_cloud(ScattererCloud cloud) {
  CORE_EXPECT(cloud.points != nullptr && cloud.points->root_rcs_m.size() == cloud.points->size());
  if (cloud.points->size() > 0) note_platform(cloud.common.platform);
  cloud.first = count_;
  count_ += cloud.points->size();
  clouds_.push_back(std::move(cloud));
}

Scatterer ScattererList::operator[](std::size_t index) const {
  if (index < single_.size()) {
    const Single& single = single_[index];
    Scatterer scatterer = rests_[single.rest];
    scatterer.platform = single.platform;
    scatterer.position_m = single.position_m;
    scatterer.rcs_m2 = single.rcs_m2;
    return scatterer;
  }
  auto cloud = clouds_.end() - 1;
  while (index < cloud->first) --cloud;
  const std::size_t i = index - cloud->first;
  const radar::PointArrays& points = *cloud->points;
  Scatterer scatterer = cloud->common;
  scatterer.position_m = {points.x_m[i], points.y_m[i], points.z_m[i]};
  scatterer.rcs_m2 = points.root_rcs_m[i] * points.root_rcs_m[i];
  return scatterer;
}

void ScattererList::note_platform(std::uint32_t platform) {
  const auto at = std::ranges::lower_bound(platforms_, platform);
  if (at == platforms_.end() || *at != platform) platforms_.insert(at, platform);
}

ScattererList ScattererList::thinned(std::size_t max_points) const {
  CORE_EXPECT(max_points > 1);
  ScattererList list;
  list.single_ = single_;
  list.rests_ = rests_;
  list.platforms_ = platforms_;
  list.count_ = single_.size();
  for (const ScattererCloud& cloud : clouds_) {
    const radar::PointArrays& all = *cloud.points;
    if (all.size() <= max_points) {
      list.add_cloud(cloud);
      continue;
    }
    auto some = std::make_shared<radar::PointArrays>();
    for (std::size_t n = 0; n < max_points; ++n) {
      const std::size_t i = n * (all.size() - 1) / (max_points - 1);
      some->x_m.push_back(all.x_m[i]);
      some->y_m.push_back(all.y_m[i]);
      some->z_m.push_back(all.z_m[i]);
      some->root_rcs_m.push_back(all.root_rcs_m[i]);
    }
    ScattererCloud few = cloud;
    few.points = std::move(some);
    list.add_cloud(std::move(few));
  }
  return list;
}

}  // namespace sarsim::simulate
