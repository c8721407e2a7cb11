#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace sarsim::core {

/// Things that threads borrow, one each, and give back; made where none is idle.
template <class T>
class WorkerPool {
 public:
  explicit WorkerPool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

  /// Calls `use(item)` with one that nobody else has meanwhile. One whose use throws is thrown away.
  template <class Use>
  void lend(const Use& use) {
    std::unique_ptr<T> item = take();
    use(*item);
    const std::scoped_lock hold(lock_);
    idle_.push_back(std::move(item));
  }

 private:
  std::unique_ptr<T> take() {
    {
      const std::scoped_lock hold(lock_);
      if (!idle_.empty()) {
        std::unique_ptr<T> item = std::move(idle_.back());
        idle_.pop_back();
        return item;
      }
    }
    return make_();
  }

  std::function<std::unique_ptr<T>()> make_;
  std::mutex lock_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace sarsim::core
