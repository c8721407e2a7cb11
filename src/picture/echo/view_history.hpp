#pragma once

#include <cstddef>
#include <vector>

namespace sarsim::picture {

/// Views that were shown before, to go back to.
/// @tparam View  a value that can be copied and compared
template <class View>
class ViewHistory {
 public:
  static constexpr std::size_t longest = 100;

  /// Keeps the view that is left, unless it is the one that was kept last; what lay ahead is forgotten. The oldest of
  /// more than `longest` is dropped.
  void leave(const View& view) {
    future_.clear();
    if (!past_.empty() && past_.back() == view) return;
    past_.push_back(view);
    if (past_.size() > longest) past_.erase(past_.begin());
  }
  /// Forgets everything.
  void clear() { *this = {}; }
  /// Whether a view was left.
  [[nodiscard]] bool can_go_back() const { return !past_.empty(); }
  /// Whether a view was left by going back.
  [[nodiscard]] bool can_go_forward() const { return !future_.empty(); }
  /// The view before `present`, which is kept on the other side; `present` where there is none.
  [[nodiscard]] View back(const View& present) { return step(past_, future_, present); }
  /// The view after `present`, which is kept on the other side; `present` where there is none.
  [[nodiscard]] View forward(const View& present) { return step(future_, past_, present); }

  friend bool operator==(const ViewHistory&, const ViewHistory&) = default;

 private:
  static View step(std::vector<View>& from, std::vector<View>& to, const View& present) {
    if (from.empty()) return present;
    const View view = from.back();
    from.pop_back();
    to.push_back(present);
    return view;
  }

  std::vector<View> past_;
  std::vector<View> future_;
};

}  // namespace sarsim::picture
