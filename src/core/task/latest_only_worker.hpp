#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/task/stop.hpp"

namespace sarsim::core {

/// Requests that are computed one after another on a thread of their own, and of which only the newest counts: a new
/// one stops the one before, and nothing is told about that any more.
template <class Request>
class LatestOnlyWorker {
 public:
  /// Computes a request; called on the thread of this object. Must not throw.
  using Work = std::function<void(const Request& request, std::uint64_t number, const StopFlag& stop)>;

  /// @param work  uses nothing that ends before this object does
  explicit LatestOnlyWorker(Work work) : work_(std::move(work)), worker_([this] { run(); }) {}
  ~LatestOnlyWorker() {
    {
      const std::scoped_lock hold(lock_);
      ending_ = true;
      pending_.reset();
      if (stop_) stop_->request();
      changed_.notify_all();
    }
    worker_.join();
  }
  LatestOnlyWorker(const LatestOnlyWorker&) = delete;
  LatestOnlyWorker& operator=(const LatestOnlyWorker&) = delete;

  /// Begins and returns at once: the number of the request, from 1.
  std::uint64_t show(Request request) {
    std::uint64_t number = 0;
    {
      const std::scoped_lock hold(lock_);
      if (stop_) stop_->request();
      stop_ = std::make_shared<StopFlag>();
      pending_ = std::move(request);
      number = ++number_;
      changed_.notify_all();
    }
    const std::scoped_lock until_told(telling_);
    return number;
  }

  /// Stops what is being computed.
  void cancel() {
    {
      const std::scoped_lock hold(lock_);
      if (stop_) stop_->request();
      pending_.reset();
      changed_.notify_all();
    }
    const std::scoped_lock until_told(telling_);
  }

  /// Waits until nothing is being computed.
  void wait() {
    std::unique_lock hold(lock_);
    changed_.wait(hold, [&] { return !busy_ && !pending_; });
  }

  /// Calls a listener about a request that has not been stopped. Once `show` or `cancel` has returned, no call about an
  /// earlier request is under way or follows; so a listener must call neither, nor wait for a thread that does.
  template <class Listener>
  void tell(const StopFlag& stop, const Listener& listener) {
    const std::scoped_lock hold(telling_);
    if (!stop.requested()) listener();
  }

 private:
  void run() {
    for (;;) {
      std::unique_lock hold(lock_);
      busy_ = false;
      changed_.notify_all();
      changed_.wait(hold, [&] { return ending_ || pending_; });
      if (ending_) return;
      const Request request = std::move(*pending_);
      pending_.reset();
      const std::shared_ptr<const StopFlag> stop = stop_;
      const std::uint64_t number = number_;
      busy_ = true;
      hold.unlock();
      work_(request, number, *stop);
    }
  }

  Work work_;
  std::mutex lock_;     // of what follows
  std::mutex telling_;  // held while a listener is called
  std::condition_variable changed_;
  std::optional<Request> pending_;
  std::shared_ptr<StopFlag> stop_;  // of the request that is pending or being computed
  std::uint64_t number_ = 0;
  bool busy_ = false;
  bool ending_ = false;
  std::thread worker_;  // last: uses everything above
};

}  // namespace sarsim::core
