#include "picture/live/live_picture.hpp"

#include <exception>
#include <utility>

#include "core/report/refused.hpp"
#include "core/task/parallel.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::picture {

LivePicture::LivePicture(Listener listener, unsigned threads)
    : listener_(std::move(listener)), engine_(core::thread_count(threads)), worker_([this] { work(); }) {}

LivePicture::~LivePicture() {
  {
    const std::scoped_lock hold(lock_);
    ending_ = true;
    pending_.reset();
    if (stop_) stop_->request();
    changed_.notify_all();
  }
  worker_.join();
}

std::uint64_t LivePicture::show(LiveRequest request) {
  std::uint64_t number = 0;
  {
    const std::scoped_lock hold(lock_);
    if (stop_) stop_->request();
    stop_ = std::make_shared<core::StopFlag>();
    pending_ = std::move(request);
    number = ++number_;
    changed_.notify_all();
  }
  const std::scoped_lock until_told(telling_);
  return number;
}

void LivePicture::cancel() {
  {
    const std::scoped_lock hold(lock_);
    if (stop_) stop_->request();
    pending_.reset();
    changed_.notify_all();
  }
  const std::scoped_lock until_told(telling_);
}

void LivePicture::wait() {
  std::unique_lock hold(lock_);
  changed_.wait(hold, [&] { return !busy_ && !pending_; });
}

void LivePicture::work() {
  for (;;) {
    LiveRequest request;
    std::shared_ptr<core::StopFlag> stop;
    std::uint64_t number = 0;
    {
      std::unique_lock hold(lock_);
      busy_ = false;
      changed_.notify_all();
      changed_.wait(hold, [&] { return ending_ || pending_; });
      if (ending_) return;
      request = std::move(*pending_);
      pending_.reset();
      stop = stop_;
      number = number_;
      busy_ = true;
    }
    compute(request, number, *stop);
  }
}

void LivePicture::compute(const LiveRequest& request, std::uint64_t number, const core::StopFlag& stop) {
  const auto fail = [&](core::Problems problems) {
    tell({LiveEvent::Kind::failed, number, nullptr, std::move(problems)}, stop);
  };
  try {
    tell({LiveEvent::Kind::started, number, nullptr, {}}, stop);
    LiveImage image = engine_.make(request, stop, [&](LiveImage coarse) {
      tell({LiveEvent::Kind::image, number, std::make_shared<const LiveImage>(std::move(coarse)), {}}, stop);
    });
    tell({LiveEvent::Kind::finished, number, std::make_shared<const LiveImage>(std::move(image)), {}}, stop);
  } catch (const core::Interrupted&) {
    return;
  } catch (const core::Refused& refused) {
    fail(refused.problems);
  } catch (const simulate::ImpossibleEcho& echo) {
    fail({echo.problem});
  } catch (const std::exception& failure) {
    fail({core::problem_of(core::Severity::error, failure.what(), {}, {}, {})});
  }
}

void LivePicture::tell(const LiveEvent& event, const core::StopFlag& stop) {
  const std::scoped_lock hold(telling_);
  if (!stop.requested() && listener_) listener_(event);
}

}  // namespace sarsim::picture
