#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "picture/colour/colour_map.hpp"
#include "picture/colour/display_quantity.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/conventions.hpp"

namespace sarsim::picture {

/// The part of the echo matrix that a window shows: slant range across, azimuth time upwards.
struct EchoView {
  double range_start_m = 0.0;  ///< One way.
  double range_end_m = 0.0;
  double time_start_s = 0.0;
  double time_end_s = 0.01;

  friend bool operator==(const EchoView&, const EchoView&) = default;
};

/// Where the sampling frequency comes from.
struct Sampling {
  enum class Kind {
    screen,    ///< One sample for each device pixel, as in the thesis.
    rate,      ///< `rate_hz`.
    multiple,  ///< `multiple` times the pulse's bandwidth ("x Nyquist").
  };
  Kind kind = Kind::screen;
  double rate_hz = 0.0;
  double multiple = 1.0;

  friend bool operator==(const Sampling&, const Sampling&) = default;
};

/// How samples are drawn.
enum class DrawAs {
  pixels,
  curves_per_pulse,  ///< "Slices in Y": one curve across for each pulse.
  curves_per_range,  ///< "Slices in X": one curve upwards every 20 pixels.
  automatic,         ///< Curves per pulse where pulses are at least 20 pixels apart, else pixels.
};

/// What the picture does where there are fewer pulses than rows of pixels.
enum class RowPlacing {
  nearest,  ///< Every row of pixels shows the pulse nearest in time.
  own_row,  ///< Every pulse fills one row of pixels; the others stay empty (thesis).
};

/// What stands for the samples of a pixel where there are more of them than pixels.
enum class PixelRule {
  sample,  ///< One of them, so that what is seen is a subset of the recording; of compressed data one pulse's largest.
  peak,    ///< The largest of them.
};

/// The choices of one simulation window. A plain value: two windows that compare equal show the same.
struct EchoWindow : ColourLook {
  /// What would be recorded: radar, window, processing, pulse position, converter, file. Its sampling frequency counts
  /// for Sampling::Kind::rate only and is the same as `sampling.rate_hz` then.
  scene::Simulation recording;
  Sampling sampling;
  PixelRule pixel_rule = PixelRule::sample;
  DrawAs draw_as = DrawAs::automatic;
  RowPlacing placing = RowPlacing::nearest;

  friend bool operator==(const EchoWindow&, const EchoWindow&) = default;
};

/// A new window: raw, sampled as the screen needs; compressed, at the pulse's bandwidth (thesis 4.5.1).
[[nodiscard]] EchoWindow new_echo_window(std::string radar, scene::Processing processing);
/// A stored simulation as a window that shows it exactly.
[[nodiscard]] EchoWindow window_of(const scene::Simulation& simulation);
/// The window as a simulation to be stored or run. Where the screen sets the sampling, the bandwidth does now (thesis
/// 4.5.2).
/// @param bandwidth_hz  of the radar's pulse
[[nodiscard]] scene::Simulation simulation_of(const EchoWindow& window, double bandwidth_hz);

/// The simulation that is computed for the screen. The recording's own sampling, but one sample per pixel where the
/// screen sets it, and, for raw data, so many times the recording's that there is one for every pixel where it has
/// fewer.
/// @param width_px  device pixels across
[[nodiscard]] scene::Simulation shown_simulation(const EchoWindow& window, double bandwidth_hz, std::size_t width_px,
                                                 const simulate::Conventions& conventions);

/// Whether what is to be computed differs, not only how it is drawn: quantity, colours, placing and draw-as only
/// redraw.
[[nodiscard]] bool needs_computing(const EchoWindow& before, const EchoWindow& after);

/// "Below three times the bandwidth curves may look odd", for compressed data; empty otherwise (thesis 4.5.1).
/// @param sample_rate_hz  as computed
[[nodiscard]] std::string sampling_warning(const EchoWindow& window, double sample_rate_hz, double bandwidth_hz);

/// The part of the matrix that a window shows, or is to show.
[[nodiscard]] EchoView view_of(const EchoWindow& window);
void set_view(EchoWindow& window, const EchoView& view);

/// Limits as they are typed, mended: reversed ones are swapped, ranges below 0 become 0, equal ones are 1 m or 1 s
/// apart, anything that is no finite number becomes 0.
[[nodiscard]] EchoView mended(EchoView view);

/// Size of a plot in device pixels. Pixel k has its centre at coordinate k; x counts to the right, y downwards.
struct PlotSize {
  std::size_t width_px = 1;
  std::size_t height_px = 1;

  friend bool operator==(const PlotSize&, const PlotSize&) = default;
};

/// Coordinates: pixel 0 stands at the window's start in range, one beyond the last at its end, so that as many samples
/// as pixels fill the window; the lowest row of pixels at its start in time, the highest at its end, because pulses at
/// both ends belong to the window.
[[nodiscard]] double range_at(const EchoView& view, const PlotSize& size, double x_px);
[[nodiscard]] double time_at(const EchoView& view, const PlotSize& size, double y_px);
[[nodiscard]] double x_of_range(const EchoView& view, const PlotSize& size, double range_m);
[[nodiscard]] double y_of_time(const EchoView& view, const PlotSize& size, double time_s);

/// The part of a view between two corners of a rectangle, cut off at the plot; nothing where no pixel is left of it in
/// either direction.
[[nodiscard]] std::optional<EchoView> zoomed_to(const EchoView& view, const PlotSize& size, double x0_px, double y0_px,
                                                double x1_px, double y1_px);
/// The view scaled about a point of the plot, which stays where it is: `factor` above 1 shows more. Range never goes
/// below 0: there the view is moved.
[[nodiscard]] EchoView scaled_about(const EchoView& view, const PlotSize& size, double x_px, double y_px,
                                    double range_factor, double time_factor);
/// Twice as much in both directions, with the clicked point in the middle (the original's right click).
[[nodiscard]] EchoView zoomed_out(const EchoView& view, const PlotSize& size, double x_px, double y_px);
/// The view moved by pixels: a drag to the right shows smaller ranges, one downwards later times.
[[nodiscard]] EchoView panned(const EchoView& view, const PlotSize& size, double dx_px, double dy_px);

/// Ranges that show all targets: from two pulse lengths (c Tp/2 each) before the nearest to two behind the farthest; 0
/// to 10 km where nothing reflects.
/// @param nearest_m, farthest_m  reversed where there are none
[[nodiscard]] EchoView showing_targets(const EchoView& view, double nearest_m, double farthest_m, double pulse_width_s,
                                       double light_speed_mps);

/// Which axes a window shares with another one.
struct AxisLink {
  bool range = false;
  bool time = false;

  friend bool operator==(const AxisLink&, const AxisLink&) = default;
};
/// `own` with the linked axes of `leader`.
[[nodiscard]] EchoView linked(const EchoView& own, const EchoView& leader, const AxisLink& link);

}  // namespace sarsim::picture
