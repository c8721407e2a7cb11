#include "cli/command/focus_arguments.hpp"

#include <cctype>
#include <cmath>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "cli/shell/options.hpp"
#include "core/report/refused.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::cli {

namespace {

// Half of the memory that is free; 1 GiB where the system does not say.
std::size_t half_of_free_memory() {
  std::ifstream info("/proc/meminfo");
  std::string name;
  std::size_t kilobytes = 0;
  std::string unit;
  while (info >> name >> kilobytes) {
    std::getline(info, unit);
    if (name == "MemAvailable:") return kilobytes * 512;
  }
  return std::size_t{1} << 30;
}

}  // namespace

const char* word_of(FocusAlgorithm algorithm) {
  switch (algorithm) {
    case FocusAlgorithm::range_doppler: return "range-doppler";
    case FocusAlgorithm::chirp_scaling: return "chirp-scaling";
    case FocusAlgorithm::back_projection: return "back-projection";
    case FocusAlgorithm::omega_k: break;
  }
  return "omega-k";
}

std::size_t memory_of(const std::string& text) {
  if (text.empty()) return half_of_free_memory();
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

void add_focus_arguments(CLI::App& app, FocusArguments& a) {
  add_text(app, "--out", a.output, "OUT",
           fmt::format("image to write: ENVI (.img, default), or {}; default: the input's name",
                       raster::image_extensions()));
  add_choice<FocusAlgorithm>(app, "--algorithm", a.algorithm,
                             {{"range-doppler", FocusAlgorithm::range_doppler},
                              {"chirp-scaling", FocusAlgorithm::chirp_scaling},
                              {"omega-k", FocusAlgorithm::omega_k},
                              {"back-projection", FocusAlgorithm::back_projection}},
                             "omega-k by default; back-projection for tracks that are not straight");
  add_text(app, "--window", a.window, "WINDOW",
           "over range and azimuth: rectangular (default), hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]");
  add_text(app, "--range-window", a.range_window, "WINDOW", "over range alone");
  add_text(app, "--azimuth-window", a.azimuth_window, "WINDOW", "over azimuth alone");
  add_text(app, "--doppler-centroid", a.centroid, "geometry|measured|HZ",
           "the middle of the Doppler band, as the geometry has it (default), measured, or given");
  add_real(app, "--doppler-bandwidth", a.bandwidth_hz, "HZ", "band to keep about the centroid (default: all)");
  add_choice<FocusGrid>(app, "--grid", a.grid, {{"slant", FocusGrid::slant}, {"ground", FocusGrid::ground}},
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

}  // namespace sarsim::cli
