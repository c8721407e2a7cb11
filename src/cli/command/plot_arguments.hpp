#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/shell/context.hpp"
#include "picture/colour/display_quantity.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/echo/radar_figures.hpp"
#include "picture/scene/scene_view.hpp"
#include "workflow/input/sample_input.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

/// What `sarsim plot` draws.
enum class PlotKind {
  picture,        ///< The echo matrix, or what a file holds.
  pulse,          ///< One row against range.
  range,          ///< One column against time.
  profile,        ///< Mean of a burst against range.
  range_doppler,  ///< Map of a coherent interval.
  doppler_time,   ///< Spectra of one range cell against time.
  spectrum,       ///< Of one received pulse.
  phase,          ///< Of one range cell from pulse to pulse.
  antenna,        ///< Patterns of a radar.
  sent,           ///< The pulse that a radar sends.
  function,       ///< A user-defined function.
  track,          ///< Paths of the platforms on a map, and their heights.
  footprint,      ///< What an antenna sees of the ground.
  scene,          ///< The scene in three dimensions.
};

/// The command line of `sarsim plot`.
struct PlotArguments {
  std::string input;
  std::string out;
  std::string csv;
  std::optional<std::string> title;
  std::vector<std::string> others;      ///< Inputs whose curves are laid over those of the first.
  std::vector<std::string> variations;  ///< "FIELD=VALUES" of the script, a curve for each value.
  std::optional<PlotKind> wanted_kind;
  PlotKind kind = PlotKind::picture;  ///< The wanted one, once everything is read.
  // Which samples.
  std::string radar;
  std::optional<std::int64_t> simulation;
  std::optional<scene::Processing> processing;
  std::optional<double> rate_hz;
  std::vector<double> range_m;
  std::vector<double> time_s;
  std::vector<double> azimuth_m;
  std::optional<double> at_m;
  std::optional<double> at_s;
  std::optional<double> at_azimuth_m;
  std::optional<std::int64_t> pulses;
  bool recorded = false;
  bool screen = false;
  // What of them.
  std::optional<picture::DisplayQuantity> quantity;
  std::optional<picture::ProfileMean> mean;
  std::optional<picture::SpectrumWindow> window;
  std::optional<std::int64_t> padding;
  std::optional<std::int64_t> interval;
  bool wrapped = false;
  std::optional<std::int64_t> peaks;
  std::string function;
  bool compare = false;
  std::vector<double> angles_deg;
  // From where the scene is seen.
  std::optional<picture::SceneLook::From> view;
  std::vector<double> look_deg;  ///< Azimuth and elevation.
  std::string followed;
  bool perspective = false;
  bool illuminated = false;
  std::optional<picture::DrawingOptions::Tracks> tracks;
  std::optional<std::int64_t> frames;
  // How it looks.
  std::optional<picture::DrawAs> draw_as;
  std::optional<picture::ColourMap> map;
  std::optional<double> span_db;
  std::optional<double> percentile;
  std::vector<double> limits;
  std::vector<std::int64_t> size{1000, 700};
  std::optional<double> scale;
  bool inverted = false;
  bool peak = false;
  bool dark = false;
  bool force = false;
  workflow::SceneOverrides overrides;
  workflow::SampleArguments samples;
};

/// A figure and, where --csv asks for it, its values as text.
struct Plotted {
  picture::Figure figure;
  std::string table;
};

/// What the axes, colour bar and titles leave of a picture of this size, about.
[[nodiscard]] picture::PlotSize plot_pixels(const PlotArguments& arguments);

/// Quantity, colours, limits and draw-as into a window.
void take_look(const PlotArguments& arguments, picture::DisplayQuantity usual, picture::EchoWindow& window);

/// Of a script; throws core::InvalidRequest for what it does not have.
[[nodiscard]] Plotted plot_scene(const PlotArguments& arguments, Streams& streams);
/// The scene in three dimensions, which writes its pictures itself; throws as `plot_scene`.
void plot_view(const PlotArguments& arguments, Streams& streams);
/// Of a file of samples or a focused image; throws core::InvalidRequest for what it does not say.
[[nodiscard]] Plotted plot_file(const PlotArguments& arguments, Streams& streams);

}  // namespace sarsim::cli
