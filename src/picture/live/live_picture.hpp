#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "core/report/problem.hpp"
#include "core/task/latest_only_worker.hpp"
#include "picture/live/live_engine.hpp"
#include "picture/live/live_image.hpp"

namespace sarsim::picture {

/// What became of a request for a live image.
struct LiveEvent {
  enum class Kind {
    started,   ///< Work has begun.
    image,     ///< An image; a better one will follow, or what is to be said of it.
    finished,  ///< The image.
    failed,    ///< `problems` say why.
  };
  Kind kind = Kind::started;
  std::uint64_t request = 0;               ///< What `show` returned.
  std::shared_ptr<const LiveImage> image;  ///< Of image and finished.
  core::Problems problems;                 ///< Errors where it failed.
};

/// Computes live images in the background, on all cores. Every new request ends the one before. What was computed for
/// one serves the next: of targets that did not change, no echo is computed again.
class LivePicture {
 public:
  /// Called on the thread that computes, by the rules of core::LatestOnlyWorker::tell.
  using Listener = std::function<void(const LiveEvent&)>;

  /// @param threads  0: one for each core
  explicit LivePicture(Listener listener, unsigned threads = 0);

  /// Begins; returns at once.
  std::uint64_t show(LiveRequest request) { return requests_.show(std::move(request)); }
  /// Ends what is being computed.
  void cancel() { requests_.cancel(); }
  /// Waits until nothing is being computed.
  void wait() { requests_.wait(); }

 private:
  void compute(const LiveRequest& request, std::uint64_t number, const core::StopFlag& stop);
  void tell(const LiveEvent& event, const core::StopFlag& stop);

  Listener listener_;
  LiveEngine engine_;                             // used by the thread of the requests alone
  core::LatestOnlyWorker<LiveRequest> requests_;  // last: its thread uses everything above
};

}  // namespace sarsim::picture
