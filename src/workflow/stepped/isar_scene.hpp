#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/sar_window.hpp"
#include "signal/stepped/stepped_isar.hpp"
#include "workflow/stepped/stepped_rows.hpp"

namespace sarsim::workflow {

/// How an image of a turning target is made.
struct IsarOptions {
  /// How bursts become an image: a transform of each cell of range, or a sum for each point.
  enum class Algorithm { range_doppler, back_projection };
  enum class Motion {
    scene,      ///< The path of the target's platform, from the script.
    estimated,  ///< One speed, the one that makes profiles sharpest; the rest is left to autofocus.
  };
  Algorithm algorithm = Algorithm::range_doppler;
  Motion motion = Motion::scene;
  std::size_t platform = 0;                 ///< Of the target.
  std::optional<double> turn_rate_radps{};  ///< Instead of the scene's turning.
  std::optional<double> cross_range_m{};    ///< Size of the image; nothing: as large as the target.
  std::optional<double> range_m{};
  std::size_t oversampling = 2;  ///< Pixels for each resolution cell.
  signal::SarWindow range_window{};
  signal::SarWindow azimuth_window{};
  double fastest_mps = 500.0;  ///< Motion::estimated: searched from minus this to this.
  bool autofocus = false;
};

/// A target of the scene in an image.
struct HeldPoint {
  std::size_t target = 0;       ///< Position in the scene's list, from 0.
  signal::ImagePlace expected;  ///< Cross-range and range from the target's centre.
  double amplitude = 0.0;       ///< Mean of its echoes, volts.
  bool outside = false;         ///< Its place is not in the image: it is not looked for.
  std::optional<signal::PointResponse> found{};
};

/// An image of a turning target and what it is of.
struct IsarImage {
  signal::FocusedImage image;  ///< Rows along cross-range, columns along range, from the target's centre.
  double from_s = 0.0;
  double to_s = 0.0;
  double speed_mps = 0.0;                  ///< Of the target's centre in the middle.
  double range_m = 0.0;                    ///< Its range there.
  double turn_rad = 0.0;                   ///< Of the line of sight in the target's frame.
  double range_resolution_m = 0.0;         ///< c/(2 B)
  double cross_range_resolution_m = 0.0;   ///< wavelength/(2 turn)
  double unambiguous_cross_range_m = 0.0;  ///< wavelength/2 over the turn from burst to burst.
  std::vector<HeldPoint> points;           ///< Of many targets in an image that was made the first `max_held_targets`.
  core::Problems problems;                 ///< What limits this image.
  core::Problems losses;                   ///< What was lost of it, as its points show once it is made.
};

/// The directions, times and sizes of an image, without values; `problems` says what prevents it (errors) and
/// what limits it (warnings).
/// @param first, count  bursts of the recording
[[nodiscard]] IsarImage plan_isar_image(const SteppedRows& rows, std::size_t first, std::size_t count,
                                        const IsarOptions& options);

/// Makes the image. Throws std::invalid_argument where `plan_isar_image` finds an error, Interrupted.
[[nodiscard]] IsarImage make_isar_image(const SteppedRows& rows, std::size_t first, std::size_t count,
                                        const IsarOptions& options, const core::WorkControl& control,
                                        const core::ProgressReport& progress = {});

}  // namespace sarsim::workflow
