#include "cli/command/doppler_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cli/shell/options.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

constexpr std::int64_t most_pulses = std::int64_t{1} << 24;
constexpr std::int64_t most_cells = 100000;
constexpr double usual_false_alarm = 1e-6;

// Cells to either side in range and, after a colon, in Doppler.
struct Cells {
  std::size_t columns, rows;
};

std::optional<Cells> cells_from(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto columns = core::parse_integer(text.substr(0, colon));
  const auto rows =
      colon == std::string::npos ? std::optional<std::int64_t>(0) : core::parse_integer(text.substr(colon + 1));
  const auto good = [](std::optional<std::int64_t> n) { return n && *n >= 0 && *n <= most_cells; };
  if (!good(columns) || !good(rows)) return std::nullopt;
  return Cells{static_cast<std::size_t>(*columns), static_cast<std::size_t>(*rows)};
}

void add_error(core::Problems& problems, std::string message, std::string found, std::string expected) {
  core::Problem problem;
  problem.message = std::move(message);
  problem.found = std::move(found);
  problem.expected = std::move(expected);
  problems.push_back(std::move(problem));
}

Cells cells_or(const char* option, const std::string& text, Cells usual, core::Problems& problems) {
  if (text.empty()) return usual;
  if (const auto cells = cells_from(text)) return *cells;
  add_error(problems, fmt::format("{}: no numbers of cells", option), text,
            "cells of range, or RANGE:DOPPLER, for instance 16 or 8:2");
  return usual;
}

// A target fills the samples of its range cell: those must not count as noise.
std::size_t usual_guard(const simulate::Plan& plan) {
  const double samples = 1.0 / (radar::bandwidth_hz(plan.radar.pulse) * plan.raw_grid.interval_s);
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(2.0 * samples - 1e-9)));
}

// What says how to detect means nothing where nothing is detected.
void expect_detector(const SearchArguments& a, bool detect, core::Problems& problems) {
  if (detect) return;
  const std::pair<const char*, bool> given[] = {{"--guard", !a.guard.empty()},
                                                {"--train", !a.train.empty()},
                                                {"--pfa", a.false_alarm.has_value()},
                                                {"--all-cells", a.all_cells},
                                                {"--detections", !a.detections.empty()}};
  for (const auto& [option, there] : given)
    if (there) add_error(problems, fmt::format("{} means nothing with --cfar none", option), "", "--cfar ca or os");
}

void take_detector(const SearchArguments& a, const simulate::Plan& plan, workflow::SearchOptions& options,
                   core::Problems& problems) {
  const Detector detector = a.detector.value_or(Detector::cell_averaging);
  options.detect = detector != Detector::none;
  options.all_cells = a.all_cells;
  signal::CfarOptions& cfar = options.cfar;
  if (detector == Detector::ordered_statistic) cfar.kind = signal::CfarOptions::Kind::ordered_statistic;
  cfar.false_alarm = a.false_alarm.value_or(usual_false_alarm);
  if (!(cfar.false_alarm >= 1e-15 && cfar.false_alarm <= 0.5))
    add_error(problems, "--pfa: no probability of false alarm for a cell", core::format_number(cfar.false_alarm),
              "1e-15 to 0.5");
  cfar.rank_share = a.rank.value_or(0.75);
  if (!(cfar.rank_share > 0.0 && cfar.rank_share <= 1.0))
    add_error(problems, "--rank: not a share of the reference cells", core::format_number(cfar.rank_share),
              "above 0, at most 1");
  if (a.rank && detector != Detector::ordered_statistic)
    add_error(problems, "--rank is for the ordered statistic", "", "--cfar os");
  expect_detector(a, options.detect, problems);
  const Cells guard = cells_or("--guard", a.guard, {usual_guard(plan), 0}, problems);
  // By default 16 cells to either side beyond the guard.
  const Cells train = cells_or("--train", a.train, {16, 0}, problems);
  cfar.guard_columns = guard.columns;
  cfar.guard_rows = guard.rows;
  cfar.reference_columns = guard.columns + train.columns;
  cfar.reference_rows = train.rows > 0 ? guard.rows + train.rows : 0;
}

}  // namespace

void add_search_arguments(CLI::App& app, SearchArguments& a, const std::string& output,
                          const std::string& usual_pulses) {
  add_text(app, "input", a.input.path, "SCENE|DATA", "script to simulate, or file of samples")->required();
  add_text(app, "--out", a.output, "OUT", output);
  add_text(app, "--detections", a.detections, "CSV", "table of detections (default: OUT's name with -detections.csv)");
  add_integer(app, "--interval", a.interval, 1, most_pulses,
              "pulses of a coherent interval (default: " + usual_pulses + ")");
  add_integer(app, "--step", a.step, 1, most_pulses, "pulses from one interval to the next (default: its length)");
  add_integer(app, "--frequencies", a.frequencies, 1, most_pulses,
              "Doppler rows of an interval, finer than its pulses give (default: as many)");
  add_text(app, "--window", a.window, "WINDOW",
           "over the pulses: rectangular (default), hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]");
  add_choice<Canceller>(app, "--canceller", a.canceller,
                        {{"none", Canceller::none}, {"two", Canceller::two}, {"three", Canceller::three}},
                        "difference of so many pulses, which takes away what rests (default: none)");
  add_choice<Detector>(
      app, "--cfar", a.detector,
      {{"ca", Detector::cell_averaging}, {"os", Detector::ordered_statistic}, {"none", Detector::none}},
      "detector: mean of the cells around (ca, default), their ordered statistic (os), or none");
  add_text(app, "--guard", a.guard, "R[:D]",
           "cells beside one, in range and Doppler, that do not count as noise (default: 2 range cells, at least 2)");
  add_text(app, "--train", a.train, "R[:D]",
           "cells to either side beyond those that count as noise (default: 16; D is 0: range alone)");
  add_real(app, "--pfa", a.false_alarm, "P", "probability of false alarm of a cell (default: 1e-6)");
  add_real(app, "--rank", a.rank, "SHARE", "which of the ordered cells, as a share of them (os; default: 0.75)");
  app.add_flag("--all-cells", a.all_cells, "every cell above its threshold, not only peaks");
  app.add_flag("--no-map", a.no_map, "detections and report only");
  add_recording_arguments(app, a.input);
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

workflow::SearchOptions search_options(const SearchArguments& a, const workflow::PulseRows& rows,
                                       std::size_t usual_pulses) {
  core::Problems problems;
  workflow::SearchOptions options;
  const auto count = [](std::optional<std::int64_t> n, std::size_t usual) {
    return n ? static_cast<std::size_t>(*n) : usual;
  };
  options.pulses = count(a.interval, usual_pulses);
  options.step = count(a.step, 0);
  options.frequencies = count(a.frequencies, 0);
  options.canceller = static_cast<std::size_t>(a.canceller.value_or(Canceller::none));
  if (!a.window.empty()) {
    const auto window = signal::window_from_text(a.window);
    if (window)
      options.window = *window;
    else
      add_error(problems, "--window: no window", a.window,
                "rectangular, hamming, hann, kaiser[:BETA] or taylor[:DB:NBAR]");
  }
  take_detector(a, *rows.plan, options, problems);
  if (!problems.empty()) throw core::Refused(std::move(problems));
  return options;
}

const char* word_of(Detector detector) {
  static constexpr std::array words{"ca", "os", "none"};
  return words.at(static_cast<std::size_t>(detector));
}

}  // namespace sarsim::cli
