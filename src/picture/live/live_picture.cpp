#include "picture/live/live_picture.hpp"

#include <exception>
#include <utility>

#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::picture {

LivePicture::LivePicture(Listener listener, unsigned threads)
    : listener_(std::move(listener)),
      engine_(core::thread_count(threads)),
      requests_([this](const LiveRequest& request, std::uint64_t number, const core::StopFlag& stop) {
        compute(request, number, stop);
      }) {}

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
  } catch (const core::InvalidRequest& refused) {
    fail(refused.problems);
  } catch (const simulate::ImpossibleEcho& echo) {
    fail({echo.problem});
  } catch (const std::exception& failure) {
    fail({core::error(failure.what())});
  }
}

void LivePicture::tell(const LiveEvent& event, const core::StopFlag& stop) {
  requests_.tell(stop, [&] {
    if (listener_) listener_(event);
  });
}

}  // namespace sarsim::picture
