#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sarsim::scene::script {

/// Makes room for `more` elements at the end of a list that grows to a size known only by estimate: lists of millions
/// are then neither moved again and again nor given twice the memory they need.
/// @param share  estimate of the part of the whole list that the list with them is, above 0 to 1
template <class T>
void make_room(std::vector<T>& list, std::size_t more, double share) {
  const std::size_t needed = list.size() + more;
  if (needed <= list.capacity()) return;
  // A bad estimate must neither ask for memory without end nor make every call move the list: the first few pieces of
  // many are believed little, a fiftieth of the whole is.
  constexpr double believed_share = 0.02;
  constexpr double slack = 1.02;
  const double max_ahead = share < believed_share ? 8.0 : slack / believed_share;
  const double ahead = std::clamp(slack / share, 1.0, max_ahead);
  const auto estimate = share < 1.0 ? static_cast<std::size_t>(static_cast<double>(needed) * ahead) : needed;
  list.reserve(std::max(estimate, list.capacity() + list.capacity() / 2));
}

}  // namespace sarsim::scene::script
