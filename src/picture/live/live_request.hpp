#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "picture/echo/echo_window.hpp"
#include "scene/model/scene.hpp"
#include "signal/sar/sar_window.hpp"
#include "workflow/focus/focus_request.hpp"

/// The image that follows the scene: from echoes to what a radar engineer looks at, computed again with every change.
namespace sarsim::picture {

/// What is made of the echoes.
enum class LiveProduct {
  automatic,  ///< `suitable_product` decides.
  focused,    ///< Synthetic aperture.
  profiles,   ///< Range profiles of stepped frequencies.
  isar,       ///< Image of a turning target.
  doppler,    ///< Range-Doppler map of pulses in the middle of the recording.
  ppi,        ///< Plan position indicator.
};

/// In the order in which they are offered.
inline constexpr std::array live_products{LiveProduct::automatic, LiveProduct::focused, LiveProduct::profiles,
                                          LiveProduct::isar,      LiveProduct::doppler, LiveProduct::ppi};

/// "Focused image", "Range profiles" ...; "Automatic".
[[nodiscard]] std::string_view title_of(LiveProduct product);

/// How it is made.
struct LiveOptions {
  LiveProduct product = LiveProduct::automatic;
  workflow::FocusAlgorithm algorithm = workflow::FocusAlgorithm::automatic;  ///< Of focused images.
  signal::SarWindow window{};  ///< Of range and azimuth, the band, or the pulses.
  bool compensation = true;    ///< Motion is compensated where the track needs it; of focused images.
  bool autofocus = false;      ///< Of focused images.
  bool targets = false;        ///< Where the scene has its targets is wanted too; of focused images, and of
                               ///< `max_ringed_targets` at most.

  friend bool operator==(const LiveOptions&, const LiveOptions&) = default;
};

/// More rings around targets would hide the image.
inline constexpr std::size_t max_ringed_targets = 500;

/// An image that is wanted.
struct LiveRequest {
  std::shared_ptr<const scene::Scene> scene;
  std::size_t simulation = 0;  ///< Position in the scene's list; it must be there.
  LiveOptions options;
  PlotSize size;  ///< Pixels at most.
};

/// What suits a recording: range profiles where carriers differ, or the image of a turning target where a platform with
/// targets turns; a PPI where the antenna rotates; a focused image where the radar moves; otherwise a range-Doppler
/// map. A scene whose radar is missing is given a range-Doppler map.
[[nodiscard]] LiveProduct suitable_product(const scene::Scene& scene, std::size_t simulation);

/// The command that makes a product: "focus", "profiles", "isar", "doppler" or "search".
[[nodiscard]] std::string_view command_of(LiveProduct product);

}  // namespace sarsim::picture
