#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
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
  /// Called on the thread that computes; nothing is called about a request that was replaced, once `show` or `cancel`
  /// has returned. Must neither call this object nor wait for who does.
  using Listener = std::function<void(const LiveEvent&)>;

  /// @param threads  0: one for each core
  explicit LivePicture(Listener listener, unsigned threads = 0);
  ~LivePicture();
  LivePicture(const LivePicture&) = delete;
  LivePicture& operator=(const LivePicture&) = delete;

  /// Begins; returns at once.
  std::uint64_t show(LiveRequest request);
  /// Ends what is being computed.
  void cancel();
  /// Waits until nothing is being computed.
  void wait();

 private:
  void work();
  void compute(const LiveRequest& request, std::uint64_t number, const core::StopFlag& stop);
  void tell(const LiveEvent& event, const core::StopFlag& stop);

  Listener listener_;
  LiveEngine engine_;   // used by the worker alone
  std::mutex lock_;     // of what follows
  std::mutex telling_;  // held while the listener is called
  std::condition_variable changed_;
  std::optional<LiveRequest> pending_;
  std::shared_ptr<core::StopFlag> stop_;  // of the request that is pending or being computed
  std::uint64_t number_ = 0;
  bool busy_ = false;
  bool ending_ = false;
  std::thread worker_;
};

}  // namespace sarsim::picture
