#include "workflow/search/search_options.hpp"

#include <utility>

#include <fmt/format.h>

#include "raster/table/formats.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t max_pulses = std::uint64_t{1} << 24;

[[noreturn]] void refuse_word(std::string message, const std::string& found, std::string expected) {
  throw core::InvalidRequest(
      core::Problems{core::error(std::move(message)).found(found).expected(std::move(expected))});
}

// What cannot be read counts as given, so that all that is wrong is told at once.
template <std::optional<CellReach> PulseRequest::*member>
void take_cells(PulseRequest& request, const char* option, const std::string& word) {
  const auto cells = cells_from_text(word);
  request.*member = cells.value_or(CellReach{});
  if (cells) return;
  refuse_word(fmt::format("{}: invalid cell counts", option), word,
              "cells of range, or RANGE:DOPPLER, for instance 16 or 8:2");
}

void take_pulse_window(PulseRequest& request, const std::string& word) {
  const auto window = signal::window_from_text(word);
  if (!window) refuse_word("--window: invalid", word, std::string(signal::window_texts));
  request.window = *window;
}

void add_intervals(OptionTable<PulseRequest>& table, const std::string& usual_pulses) {
  table.whole("--interval", 1, max_pulses, "pulses of a coherent interval (default: " + usual_pulses + ")",
              &PulseRequest::pulses);
  table.whole("--step", 1, max_pulses, "pulses from one interval to the next (default: its length)",
              &PulseRequest::step);
  table.whole("--frequencies", 1, max_pulses,
              "Doppler rows of an interval, by zero padding if more than its pulses (default: as many)",
              &PulseRequest::frequencies);
  table.text(
      "--window", "WINDOW",
      "over the pulses: rectangular (default), hann, hamming, bartlett, blackman, kaiser[:BETA], taylor[:DB:NBAR]",
      take_pulse_window);
  table.choice<std::size_t>("--canceller", {{"none", 0}, {"two", 1}, {"three", 2}},
                            "MTI canceller of two or three pulses, against clutter (default: none)",
                            &PulseRequest::canceller);
}

void take_detector(PulseRequest& request, std::optional<signal::CfarOptions::Kind> detector) {
  request.detect = detector.has_value();
  request.detector = detector.value_or(signal::CfarOptions::Kind::cell_averaging);
}

void add_detector(OptionTable<PulseRequest>& table) {
  using Kind = signal::CfarOptions::Kind;
  table.choice<std::optional<Kind>>(
      "--cfar", {{"ca", Kind::cell_averaging}, {"os", Kind::ordered_statistic}, {"none", std::nullopt}},
      "CFAR detector: cell averaging (ca, default), ordered statistic (os), or none", take_detector);
  table
      .text("--guard", "R[:D]",
            "guard cells on either side, in range and Doppler (default: 2 range resolutions, at least 2)",
            [](PulseRequest& request, const std::string& word) {
              take_cells<&PulseRequest::guard>(request, "--guard", word);
            })
      .told_late = true;
  table
      .text("--train", "R[:D]", "reference cells on either side, beyond the guard cells (default: 16:0, range only)",
            [](PulseRequest& request, const std::string& word) {
              take_cells<&PulseRequest::train>(request, "--train", word);
            })
      .told_late = true;
  table.number("--pfa", "P", "probability of false alarm of a cell (default: 1e-6)", &PulseRequest::false_alarm);
  table.number("--rank", "SHARE", "os: rank as a fraction of the reference cells (default: 0.75)", &PulseRequest::rank);
  table.flag("--all-cells", "every cell above its threshold, not only peaks", &PulseRequest::all_cells);
}

// What both have alike.
// @param output        what --out writes
// @param usual_pulses  of an interval
OptionTable<PulseRequest> pulse_options(const std::string& output, const std::string& usual_pulses) {
  OptionTable<PulseRequest> table;
  table.text("--out", "OUT", output, &PulseRequest::output);
  table.text("--detections", "CSV", "table of detections (default: OUT's name with -detections.csv)",
             &PulseRequest::table);
  add_intervals(table, usual_pulses);
  add_detector(table);
  table.flag("--no-map", "detections and report only", &PulseRequest::image, false);
  table.include(recording_options(), &PulseRequest::input);
  table.whole("--threads", 0, 4096, "threads; 0 for one per core (default); never changes a byte",
              &PulseRequest::threads);
  table.flag("--force", "replace files that exist", &PulseRequest::replace);
  return table;
}

OptionTable<PictureArguments> picture_options() {
  OptionTable<PictureArguments> table;
  table.number("--pixel", "M", "side of a pixel (default: a range sample, or a thousandth of --extent)",
               &PictureArguments::pixel_m);
  table.number("--extent", "M", "extent of the display from the radar (default: the recorded range)",
               &PictureArguments::extent_m);
  table.number("--height", "M", "world z of the plane that is shown (default: 0)", &PictureArguments::height_m);
  table.whole("--scan", 1, std::uint64_t{1} << 32,
              "one turn of the antenna, from 1 (default: the largest of all turns in each pixel)",
              [](PictureArguments& picture, std::uint64_t n) { picture.scan = static_cast<std::size_t>(n - 1); });
  return table;
}

// Mistakes in words, with what else is wrong with the request.
template <class Request>
Request request_of(const OptionTable<Request>& table, const std::string& input, const GivenWords& given) {
  Request request;
  request.input.path = input;
  TakenProblems problems = table.take_words(given, request);
  if (problems.empty()) return request;
  core::Problems all = std::move(problems.early);
  core::append(all, problems_of_request(request));
  core::append(all, std::move(problems.late));
  throw core::InvalidRequest(std::move(all));
}

}  // namespace

OptionTable<DopplerRequest> doppler_option_table() {
  OptionTable<DopplerRequest> table;
  table.include(pulse_options(fmt::format("maps to write, one below the other: ENVI (.img, default), or {}",
                                          raster::image_extensions()),
                              fmt::format("{}, or as many as there are", usual_doppler_pulses)),
                [](DopplerRequest& request) -> PulseRequest& { return request; });
  return table;
}

OptionTable<SearchRequest> search_option_table() {
  OptionTable<SearchRequest> table;
  table.include(pulse_options(fmt::format("picture to write: ENVI (.img, default), or {}", raster::image_extensions()),
                              "while the beam turns by half its width, at most 64"),
                [](SearchRequest& request) -> PulseRequest& { return request; });
  table.include(picture_options(), &SearchRequest::picture);
  return table;
}

DopplerRequest doppler_request(const std::string& input, const GivenWords& given) {
  return request_of(doppler_option_table(), input, given);
}

SearchRequest search_request(const std::string& input, const GivenWords& given) {
  return request_of(search_option_table(), input, given);
}

}  // namespace sarsim::workflow
