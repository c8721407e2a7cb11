#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "core/task/stop.hpp"
#include "picture/live/live_image.hpp"
#include "picture/live/live_request.hpp"

namespace sarsim::picture {

/// A scene with more targets has a coarse picture of some of them first.
inline constexpr std::size_t many_targets = 4096;

/// Makes one live image after another. Echoes add up: where only a few targets differ from the scene before, theirs
/// alone are computed and put in place of the old ones; noise and all other echoes stay. Used by one thread at a time.
class LiveEngine {
 public:
  /// Told at once of an image that a better one will follow, where `coarse` is set, or only what is to be said of it.
  using Coarse = std::function<void(LiveImage coarse)>;

  /// @param threads  at least 1
  explicit LiveEngine(unsigned threads);
  ~LiveEngine();
  LiveEngine(const LiveEngine&) = delete;
  LiveEngine& operator=(const LiveEngine&) = delete;

  /// The image of a request. Focused images are those of `workflow::focus`, the others those of their commands, reduced
  /// to pixels.
  /// @throws core::InvalidRequest where the scene or the recording does not allow it, with why; core::Interrupted
  [[nodiscard]] LiveImage make(const LiveRequest& request, const core::StopFlag& stop, const Coarse& coarse);

 private:
  struct Focusing;
  unsigned threads_;
  std::unique_ptr<Focusing> focusing_;
};

}  // namespace sarsim::picture
