#include "cli/command/focus_arguments.hpp"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "cli/shell/options.hpp"
#include "cli/shell/window_option.hpp"
#include "core/report/refused.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::cli {

namespace {

// A number with K, M, G or T (of 1024) behind it; nothing where there is no text.
std::optional<std::size_t> memory_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  static constexpr std::string_view units = "KMGT";
  std::string number = text;
  double scale = 1.0;
  if (number.back() == 'B' || number.back() == 'b') number.pop_back();
  const char unit = number.empty() ? '\0' : static_cast<char>(std::toupper(static_cast<unsigned char>(number.back())));
  if (const std::size_t power = units.find(unit); unit != '\0' && power != std::string_view::npos) {
    scale = std::pow(1024.0, static_cast<double>(power) + 1.0);
    number.pop_back();
  }
  const auto value = core::parse_number(number);
  if (value && *value * scale >= 1048576.0 && *value * scale < 0x1p60) return static_cast<std::size_t>(*value * scale);
  throw core::Refused(fmt::format("--memory: '{}' is no size", text), "give 1M or more, for instance 800M or 4G");
}

// Windows of one direction stand before that of both.
void take_windows(const FocusArguments& arguments, workflow::FocusRequest& request) {
  request.range_window = window_of("--window", arguments.window);
  request.azimuth_window = request.range_window;
  if (!arguments.range_window.empty()) request.range_window = window_of("--range-window", arguments.range_window);
  if (!arguments.azimuth_window.empty())
    request.azimuth_window = window_of("--azimuth-window", arguments.azimuth_window);
}

void take_centroid(const std::string& text, workflow::FocusRequest& request) {
  if (const auto given_hz = core::parse_number(text)) {
    request.centroid = workflow::CentroidSource::given;
    request.given_centroid_hz = *given_hz;
  } else if (core::equal_ignoring_case(text, "measured")) {
    request.centroid = workflow::CentroidSource::measured;
  } else if (!core::equal_ignoring_case(text, "geometry")) {
    throw core::Refused(fmt::format("--doppler-centroid: '{}' is none", text), "geometry, measured or a number of Hz");
  }
}

}  // namespace

void add_focus_arguments(CLI::App& app, FocusArguments& a) {
  add_text(app, "--out", a.output, "OUT",
           fmt::format("image to write: ENVI (.img, default), or {}; default: the input's name",
                       raster::image_extensions()));
  add_choice<workflow::FocusAlgorithm>(app, "--algorithm", a.algorithm,
                                       {{"range-doppler", workflow::FocusAlgorithm::range_doppler},
                                        {"chirp-scaling", workflow::FocusAlgorithm::chirp_scaling},
                                        {"omega-k", workflow::FocusAlgorithm::omega_k},
                                        {"back-projection", workflow::FocusAlgorithm::back_projection}},
                                       "omega-k by default; back-projection for tracks that are not straight");
  add_text(app, "--window", a.window, "WINDOW",
           "over range and azimuth: rectangular (default), hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]");
  add_text(app, "--range-window", a.range_window, "WINDOW", "over range alone");
  add_text(app, "--azimuth-window", a.azimuth_window, "WINDOW", "over azimuth alone");
  add_text(app, "--doppler-centroid", a.centroid, "geometry|measured|HZ",
           "the middle of the Doppler band, as the geometry has it (default), measured, or given");
  add_real(app, "--doppler-bandwidth", a.bandwidth_hz, "HZ", "band to keep about the centroid (default: all)");
  add_choice<workflow::FocusGrid>(app, "--grid", a.grid,
                                  {{"slant", workflow::FocusGrid::slant}, {"ground", workflow::FocusGrid::ground}},
                                  "columns are slant ranges (default), or places on level ground: of back-projection");
  add_real(app, "--height", a.ground_m, "M",
           "height of the ground, of --grid ground and motion compensation (default: the targets' mean)");
  app.add_flag("--start-stop", a.start_stop,
               "back-projection as if the antenna rested while a pulse travels: what that neglects is seen");
  add_choice<workflow::MotionOrder>(
      app, "--motion-compensation", a.motion,
      {{"none", workflow::MotionOrder::none},
       {"first", workflow::MotionOrder::first},
       {"second", workflow::MotionOrder::second}},
      "what departs from a straight flight is taken out of the echoes; by default to the second order where the track "
      "needs it");
  app.add_flag("--autofocus", a.autofocus, "take out phase errors that are left, found in the image itself");
  add_real(app, "--autofocus-piece", a.autofocus_piece_m, "M",
           "length of the pieces it looks at one by one (default: a tenth of the synthetic aperture)");
  add_text(app, "--autofocus-phase", a.autofocus_phase, "FILE.csv", "write the phase that it found along the track");
  add_recording_arguments(app, a.input);
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  add_text(app, "--memory", a.memory, "SIZE",
           "memory to work in, as 800M or 4G (default: half of what is free); more goes to disk");
  add_text(app, "--scratch", a.scratch, "DIR", "where on disk (default: the system's folder for temporary files)");
  app.add_flag("--magnitude", a.magnitude, "also an ENVI image of magnitudes, NAME-magnitude.img");
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

workflow::FocusRequest request_of(const FocusArguments& a) {
  workflow::FocusRequest request;
  request.memory_bytes = memory_of(a.memory);
  take_windows(a, request);
  take_centroid(a.centroid, request);
  request.input = a.input;
  request.output = a.output.empty() ? std::filesystem::path(a.input.path).stem().string() + ".img" : a.output;
  request.algorithm = a.algorithm.value_or(request.algorithm);
  request.bandwidth_hz = a.bandwidth_hz.value_or(0.0);
  request.grid = a.grid.value_or(request.grid);
  request.ground_m = a.ground_m;
  request.start_stop = a.start_stop;
  request.motion = a.motion;
  request.autofocus = a.autofocus;
  request.autofocus_piece_m = a.autofocus_piece_m;
  request.autofocus_phase = a.autofocus_phase;
  request.threads = static_cast<unsigned>(a.threads.value_or(0));
  request.scratch_folder = a.scratch;
  request.magnitude = a.magnitude;
  request.force = a.force;
  return request;
}

}  // namespace sarsim::cli
