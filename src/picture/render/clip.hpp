#pragma once

#include <vector>

namespace sarsim::picture {

/// The part of a polygon where `room(corner)` is not negative (Sutherland and Hodgman 1974); `between(a, b, t)` mixes
/// corners.
template <class Corner, class Room, class Between>
[[nodiscard]] std::vector<Corner> clip_polygon(const std::vector<Corner>& corners, const Room& room,
                                               const Between& between) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const double room_a = room(a);
    const double room_b = room(b);
    if (room_a >= 0.0) kept.push_back(a);
    if ((room_a >= 0.0) != (room_b >= 0.0)) kept.push_back(between(a, b, room_a / (room_a - room_b)));
  }
  return kept;
}

}  // namespace sarsim::picture
