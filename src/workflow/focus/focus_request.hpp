#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "radar/earth/earth_frame.hpp"
#include "signal/sar/image_area.hpp"
#include "signal/sar/sar_window.hpp"
#include "workflow/focus/motion.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// How an image is made of echoes.
enum class FocusAlgorithm {
  range_doppler,
  chirp_scaling,
  omega_k,
  back_projection,
  automatic,  ///< Omega-k, or back-projection if its error is smaller and that of omega-k too large (`choose_method`).
};

/// As requests and image headers call it: "omega-k".
[[nodiscard]] const char* word_of(FocusAlgorithm algorithm);

/// What the columns of an image are.
enum class FocusGrid {
  slant,   ///< Slant ranges.
  ground,  ///< Places on level ground; of back projection alone.
};

/// From where the middle of the Doppler band is known.
enum class CentroidSource {
  geometry,  ///< Where the antenna looks and what echoes there are.
  measured,  ///< The echoes themselves, the frequency nearest to that of the geometry.
  given,
};

/// What is to be focused, and how.
struct FocusRequest {
  RecordingArguments input;
  std::filesystem::path output;  ///< Image to write, in the format of its extension; empty: the image stays in memory.
  std::string navigation;        ///< File of the motion to focus with, in place of the true one; empty: the true one.
  FocusAlgorithm algorithm = FocusAlgorithm::automatic;
  signal::SarWindow range_window{};
  signal::SarWindow azimuth_window{};
  CentroidSource centroid = CentroidSource::geometry;
  double given_centroid_hz = 0.0;                    ///< Where it is given.
  double bandwidth_hz = 0.0;                         ///< Doppler frequencies to keep about the centroid; 0: all.
  std::optional<signal::AxisInterval> azimuth_area;  ///< Of the image to make; nothing: what the record's middle sees.
  std::optional<signal::AxisInterval> range_area;    ///< Of its columns; nothing: all that are recorded.
  std::optional<FocusGrid> grid;                     ///< Nothing: slant; ground if the antenna flies around the scene.
  std::optional<double> ground_m;     ///< Height of the ground, world; nothing: that of the middle of the scene.
  bool start_stop = false;            ///< Back projection as if the antenna rested while a pulse travels.
  std::optional<MotionOrder> motion;  ///< Nothing: what the track needs.
  bool autofocus = false;
  std::optional<double> autofocus_piece_m;  ///< Nothing: a tenth of the synthetic aperture.
  std::filesystem::path autofocus_phase;    ///< CSV file of the phase that was found; empty: none.
  std::string channel;                      ///< Of a phase history (CPHD); empty: its reference channel.
  std::optional<int> sign;                  ///< Of its phases, -1 or 1, where what the file says is wrong.
  unsigned threads = 0;                     ///< 0: one for each core.
  std::optional<std::size_t> memory_bytes;  ///< To work in; nothing: half of what is free; 0: no limit.
  std::filesystem::path scratch_folder;     ///< For what needs more; empty: the system's for temporary files.
  std::optional<radar::Anchor> anchor;      ///< Of a flat world, for SICD: where its origin is on the Earth.
  bool magnitude = false;                   ///< Also an ENVI image of magnitudes beside the output.
  bool force = false;                       ///< Files that exist are replaced.
};

/// Refuses what contradicts itself: options of other algorithms, names of outputs that are taken or cannot be.
void validate(const FocusRequest& request);

/// The files that a request leads to: image, image of magnitudes, phase.
[[nodiscard]] std::vector<std::filesystem::path> outputs_of(const FocusRequest& request);

}  // namespace sarsim::workflow
