#include "workflow/focus/focus_options.hpp"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/earth_place.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/options/window_option.hpp"

namespace sarsim::workflow {

namespace {

// A number with K, M, G or T (of 1024) behind it.
std::size_t memory_of(const std::string& text) {
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
  throw core::InvalidRequest(fmt::format("--memory: '{}' is not a valid size", text),
                             "give 1M or more, for instance 800M or 4G");
}

void take_centroid(FocusRequest& request, const std::string& text) {
  if (const auto given_hz = core::parse_number(text)) {
    request.centroid = CentroidSource::given;
    request.given_centroid_hz = *given_hz;
  } else if (core::equal_ignoring_case(text, "measured")) {
    request.centroid = CentroidSource::measured;
  } else if (!core::equal_ignoring_case(text, "geometry")) {
    throw core::InvalidRequest(fmt::format("--doppler-centroid: invalid '{}'", text),
                               "geometry, measured or a number of Hz");
  }
}

// What stands behind takes the place of what stands before: windows of one direction that of both.
void add_band(OptionTable<FocusRequest>& table) {
  table
      .text("--window", "WINDOW",
            "over range and azimuth: rectangular (default), hann, hamming, bartlett, blackman, kaiser[:BETA], "
            "taylor[:DB:NBAR]",
            [](FocusRequest& request, const std::string& word) {
              request.range_window = request.azimuth_window = window_of("--window", word);
            })
      .told_late = true;
  table
      .text("--range-window", "WINDOW", "over range alone",
            [](FocusRequest& request, const std::string& word) {
              request.range_window = window_of("--range-window", word);
            })
      .told_late = true;
  table
      .text("--azimuth-window", "WINDOW", "over azimuth alone",
            [](FocusRequest& request, const std::string& word) {
              request.azimuth_window = window_of("--azimuth-window", word);
            })
      .told_late = true;
  table
      .text("--doppler-centroid", "geometry|measured|HZ",
            "Doppler centroid: from the geometry (default), measured from the echoes, or in Hz", take_centroid)
      .told_late = true;
  table.number("--doppler-bandwidth", "HZ", "processed Doppler bandwidth about the centroid (default: all)",
               &FocusRequest::bandwidth_hz);
}

// "FIRST:LAST" in metres.
signal::AxisInterval interval_of(const char* option, const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto first = core::parse_number(text.substr(0, colon));
  const auto last = colon == std::string::npos ? std::nullopt : core::parse_number(text.substr(colon + 1));
  if (first && last && *first < *last) return {*first, *last};
  throw core::InvalidRequest(fmt::format("{}: '{}' is not an interval", option, text),
                             "give FIRST:LAST in metres, as -80:120");
}

void add_area(OptionTable<FocusRequest>& table) {
  table.text(
      "--azimuth", "FIRST:LAST",
      "rows of the image, in metres along the track; may extend beyond the default, e.g. for displaced moving targets "
      "(default: half an aperture around the record)",
      [](FocusRequest& request, const std::string& word) { request.azimuth_area = interval_of("--azimuth", word); });
  table.text("--range", "FIRST:LAST", "columns of the image, in metres (default: all that are recorded)",
             [](FocusRequest& request, const std::string& word) { request.range_area = interval_of("--range", word); });
}

void add_grid(OptionTable<FocusRequest>& table) {
  table.choice<FocusGrid>("--grid", {{"slant", FocusGrid::slant}, {"ground", FocusGrid::ground}},
                          "columns in slant range or, for back-projection only, in ground range (default: slant; "
                          "ground where the antenna circles)",
                          &FocusRequest::grid);
  table.number("--height", "M",
               "ground height for back-projection and motion compensation (default: the targets' mean)",
               &FocusRequest::ground_m);
  table.flag("--start-stop", "back-projection with the start-stop (stop-and-go) approximation, to show its errors",
             &FocusRequest::start_stop);
}

void add_history(OptionTable<FocusRequest>& table) {
  table.text("--channel", "NAME", "channel of a phase history (CPHD) (default: its reference channel)",
             &FocusRequest::channel);
  table.choice<int>("--sign", {{"-1", -1}, {"+1", 1}},
                    "phase sign of a phase history (CPHD), where the file states it wrongly",
                    [](FocusRequest& request, int sign) { request.sign = sign; });
}

void add_phases(OptionTable<FocusRequest>& table) {
  table.choice<MotionOrder>(
      "--motion-compensation",
      {{"none", MotionOrder::none}, {"first", MotionOrder::first}, {"second", MotionOrder::second}},
      "compensate deviations from a straight track; by default to second order where the track needs it",
      &FocusRequest::motion);
  table.text("--navigation", "FILE",
             "motion used for focusing instead of the true one: .csv or .oem, as written by sarsim motion",
             &FocusRequest::navigation);
  table.flag("--autofocus", "remove residual phase errors, estimated from the image itself", &FocusRequest::autofocus);
  table.number("--autofocus-piece", "M",
               "length of the autofocus sub-apertures (default: a tenth of the synthetic aperture)",
               &FocusRequest::autofocus_piece_m);
  table.text("--autofocus-phase", "FILE.csv", "write the estimated phase error along the track",
             &FocusRequest::autofocus_phase);
}

void add_work(OptionTable<FocusRequest>& table) {
  table.whole("--threads", 0, 4096, "threads; 0 for one per core (default); never changes a byte",
              &FocusRequest::threads);
  table.text("--memory", "SIZE",
             "working memory, such as 800M or 4G (default: half of the free memory); beyond it, disk is used",
             [](FocusRequest& request, const std::string& word) { request.memory_bytes = memory_of(word); });
  table.text("--scratch", "DIR", "where on disk (default: the system's folder for temporary files)",
             &FocusRequest::scratch_folder);
  table.text(
      "--anchor", "LAT,LON,HEIGHT[,HEADING]",
      "SICD of a flat scene: where its origin is on the Earth (degrees, m above the ellipsoid), and the heading of +y",
      [](FocusRequest& request, const std::string& word) { request.anchor = anchor_from_text(word, "--anchor"); });
  table.flag("--magnitude", "also an ENVI image of magnitudes, NAME-magnitude.img", &FocusRequest::magnitude);
  table.flag("--force", "replace files that exist", &FocusRequest::force);
}

}  // namespace

OptionTable<FocusRequest> focus_option_table() {
  OptionTable<FocusRequest> table;
  table.text("--out", "OUT",
             fmt::format("image to write: ENVI (.img, default), {} or SICD (.nitf); default: the input's name",
                         raster::image_extensions()),
             &FocusRequest::output);
  table.choice<FocusAlgorithm>("--algorithm",
                               {{"auto", FocusAlgorithm::automatic},
                                {"range-doppler", FocusAlgorithm::range_doppler},
                                {"chirp-scaling", FocusAlgorithm::chirp_scaling},
                                {"omega-k", FocusAlgorithm::omega_k},
                                {"back-projection", FocusAlgorithm::back_projection}},
                               "auto (default): omega-k, or back-projection where that has a smaller residual error on "
                               "this track, if affordable",
                               &FocusRequest::algorithm);
  add_band(table);
  add_area(table);
  add_grid(table);
  add_phases(table);
  add_history(table);
  table.include(recording_options(), &FocusRequest::input);
  add_work(table);
  return table;
}

FocusRequest focus_request(const std::string& input, const GivenWords& given) {
  FocusRequest request;
  request.input.path = input;
  request.output = std::filesystem::path(input).stem().string() + ".img";
  const TakenProblems problems = focus_option_table().take_words(given, request);
  if (!problems.early.empty()) throw core::InvalidRequest(core::Problems{problems.early.front()});
  if (!problems.late.empty()) throw core::InvalidRequest(core::Problems{problems.late.front()});
  return request;
}

}  // namespace sarsim::workflow
