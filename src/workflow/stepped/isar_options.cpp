#include "workflow/stepped/isar_options.hpp"

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/options/window_option.hpp"

namespace sarsim::workflow {

namespace {

void add_target(OptionTable<IsarRequest>& table) {
  using Way = IsarOptions::Algorithm;
  using Path = IsarOptions::Motion;
  OptionTable<IsarOptions> options;
  options.choice<Way>("--algorithm", {{"range-doppler", Way::range_doppler}, {"back-projection", Way::back_projection}},
                      "range-doppler by default; back-projection for large angles, exact and slower",
                      &IsarOptions::algorithm);
  options.choice<Path>("--motion", {{"scene", Path::scene}, {"estimated", Path::estimated}},
                       "motion of the target: from the script (default), or estimated from the echoes, with autofocus",
                       &IsarOptions::motion);
  table.include(options, &IsarRequest::options);
  table.text("--platform", "NAME", "the target's platform (default: the one with the strongest targets)",
             &IsarRequest::platform);
  table.number("--turn-rate", "DEG/S",
               "rotation rate of the target relative to the line of sight (default: from the scene)",
               [](IsarRequest& request, double dps) { request.options.turn_rate_radps = dps * core::pi / 180.0; });
}

void add_bursts(OptionTable<IsarRequest>& table) {
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  table.whole("--bursts", 2, most, "bursts, or pulses of one carrier, of an image (default: all)",
              &IsarRequest::bursts);
  table.whole("--step", 1, most,
              "bursts from the first of an image to the first of the next (default: those of an image)",
              &IsarRequest::step);
}

OptionTable<IsarOptions> image_options() {
  OptionTable<IsarOptions> table;
  table.number("--cross-range", "M", "width of the image (default: as large as the target)",
               &IsarOptions::cross_range_m);
  table.number("--range", "M", "depth of the image (default: as large as the target)", &IsarOptions::range_m);
  table.whole("--oversampling", 1, 64, "pixels per resolution cell (default: 2)", &IsarOptions::oversampling);
  table.text("--window", "WINDOW",
             "over range and cross-range: rectangular (default), hann, hamming, bartlett, blackman, kaiser[:BETA], "
             "taylor[:DB:NBAR]",
             [](IsarOptions& options, const std::string& word) {
               options.range_window = options.azimuth_window = window_of("--window", word);
             });
  table.text("--range-window", "WINDOW", "over range alone", [](IsarOptions& options, const std::string& word) {
    options.range_window = window_of("--range-window", word);
  });
  table.text("--azimuth-window", "WINDOW", "over cross-range alone", [](IsarOptions& options, const std::string& word) {
    options.azimuth_window = window_of("--azimuth-window", word);
  });
  table.flag("--autofocus", "remove phase errors along the bursts (phase gradient)", &IsarOptions::autofocus);
  table.number("--fastest", "M/S", "largest speed searched by --motion estimated (default: 500)",
               &IsarOptions::fastest_mps);
  return table;
}

}  // namespace

OptionTable<IsarRequest> isar_option_table() {
  OptionTable<IsarRequest> table;
  table.text(
      "--out", "OUT",
      fmt::format("image to write: ENVI (.img, default), or {}; several get numbers", raster::image_extensions()),
      &IsarRequest::output);
  add_target(table);
  add_bursts(table);
  table.include(image_options(), &IsarRequest::options);
  table.include(recording_options("the first that suits"), &IsarRequest::input);
  table.whole("--threads", 0, 4096, "threads; 0 for one per core (default); never changes a byte",
              &IsarRequest::threads);
  table.flag("--magnitude", "also an ENVI image of magnitudes, NAME-magnitude.img", &IsarRequest::magnitude);
  table.flag("--force", "replace files that exist", &IsarRequest::replace);
  return table;
}

IsarRequest isar_request(const std::string& input, const GivenWords& given) {
  IsarRequest request;
  request.input.path = input;
  const TakenProblems problems = isar_option_table().take_words(given, request);
  if (!problems.empty()) throw core::InvalidRequest(core::Problems{problems.early.front()});
  return request;
}

}  // namespace sarsim::workflow
