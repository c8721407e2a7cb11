#pragma once

#include <cstddef>

#include "core/task/stop.hpp"

namespace sarsim::core {

/// Throws Interrupted where a stop has been requested; without a flag never.
inline void end_if_asked(const StopFlag* stop) {
  if (stop != nullptr && stop->requested()) throw Interrupted();
}

/// Of a loop over very many things, each of which takes too little time to ask before it: asks before the first one,
/// and then whenever so much was done.
class StopPoints {
 public:
  /// @param stop   null: cannot be stopped
  /// @param every  what is done between two questions, in whatever is counted, at least 1; some milliseconds of work
  StopPoints(const StopFlag* stop, std::size_t every) : stop_(stop), every_(every) {}

  /// Before the next thing, or before so many. Throws Interrupted where a stop has been requested.
  void pass(std::size_t count = 1) {
    if (left_ > 0) {
      left_ -= count < left_ ? count : left_;
      return;
    }
    end_if_asked(stop_);
    left_ = every_;
  }

 private:
  const StopFlag* stop_;
  std::size_t every_;
  std::size_t left_ = 0;
};

}  // namespace sarsim::core
