#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/sar/reference_track.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"

namespace sarsim::signal {

/// Points of the world in rows and columns: origin + row * row_step + column * column_step, or on a curved surface.
struct PointGrid {
  core::Vec3 origin_m;  ///< Of row 0, column 0.
  core::Vec3 row_step_m;
  core::Vec3 column_step_m;
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// If not empty: the world position of a row and a column [m], continuous in both; the steps are then not used.
  std::function<core::Vec3(double row, double column)> curved{};

  [[nodiscard]] core::Vec3 at(double row, double column) const {
    return curved ? curved(row, column) : origin_m + row * row_step_m + column * column_step_m;
  }
};

/// The points of an image: origin + azimuth along + range across. In the plane of slant range `across` says on which
/// side of the track, and how far below it, the points lie; on level ground of a height that is given they lie at the
/// same azimuths and ranges, straight below the track where the ground is farther away than that.
[[nodiscard]] PointGrid points_of(const ImageFrame& frame, const ImageAxis& azimuth, const ImageAxis& range,
                                  std::optional<double> ground_m = {});

/// Which pulses a point is made from, and with which weights.
struct BackProjectionOptions {
  enum class Aperture {
    all,   ///< Every pulse, all with the same weight.
    beam,  ///< Those that see the point within half of `beam_rad` of the squint angle.
    time,  ///< Those within half of `time_s` of the moment when they see it at the squint angle.
  };
  Aperture aperture = Aperture::all;
  core::Vec3 heading;             ///< World, length 1: directions are counted from it; 0: from each pulse's velocity.
  double squint_rad = 0.0;        ///< Of the line of sight, ahead of the plane perpendicular to the heading.
  double beam_rad = 0.0;          ///< Full width, above 0.
  double time_s = 0.0;            ///< Full length, above 0, for a straight flight at the speed of the pulse.
  WindowFunction azimuth_window;  ///< Over the aperture, argument 0 to 1; empty: all 1. `all` has no use for it.
  WindowFunction range_window;  ///< Over the pulse's band, argument 0 to 1; empty: none (signal/sar/echo_records.hpp).
  std::optional<double> ground_m{};  ///< Height of the points of a slant-range image, world; nothing: those of a plane.
  bool start_stop = false;           ///< Echoes as if the antenna rested: delay 2 d/c, no Doppler in the pulse.
};

/// Focuses echoes by back-projection in the time domain, exact for any track, attitude and squint: for each point x
///
///     (1/sum of w) sum over pulses of w s(tau - fd/K) exp(+j 2 pi (f tau + fd^2/(2 K))),  tau as below,
///     tau = 2 (d - r.V/c)/(c (1 - V^2/c^2)),
///
/// r the point as seen from the antenna, d its distance, V the antenna's velocity, v the speed at which the point
/// recedes, f the carrier of the pulse, fd = -2 v f/c, K the chirp rate (Cumming and Wong 2005, ch. 2 and 10;
/// docs/theory/back-projection.md). A resting target has the phase of its reflectivity and the weighted mean of its
/// echoes' amplitudes. Points beyond the recorded delays count as 0; points without pulses are 0. The same bytes for
/// any number of threads; between instruction sets they differ by less than 2e-6 of the largest value.
///
/// @return rows * columns values
/// @throw  std::invalid_argument where the echoes contradict themselves or an option is out of range; Interrupted
[[nodiscard]] std::vector<std::complex<float>> back_project(const SarEchoes& echoes, const PointGrid& grid,
                                                            const BackProjectionOptions& options,
                                                            const core::WorkControl& control,
                                                            const core::ProgressReport& progress = {});

/// The same as an image in baseband, turned by -4 pi f R0/c: R0 the point's distance from the frame's line
/// (slant_range), or from the line that fits the track (ground_grid).
[[nodiscard]] FocusedImage back_project(const SarEchoes& echoes, const ImageFrame& frame, const ImageAxis& azimuth,
                                        const ImageAxis& range, const BackProjectionOptions& options,
                                        const core::WorkControl& control, const core::ProgressReport& progress = {});

/// Turns the values of an image, sums in the order of `grid`, by -4 pi f R0/c, R0 the distance of each point from
/// `line`.
/// @throw  Interrupted
void turn_to_baseband(FocusedImage& image, const PointGrid& grid, const ReferenceTrack& line,
                      const core::WorkControl& control);

}  // namespace sarsim::signal
