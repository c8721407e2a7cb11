#include "cli/command/doppler_options.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cli/shell/options.hpp"
#include "cli/shell/recording_options.hpp"
#include "core/report/refused.hpp"

namespace sarsim::cli {

namespace {

constexpr std::int64_t most_pulses = std::int64_t{1} << 24;

core::Problem unreadable(std::string message, std::string found, std::string expected) {
  core::Problem problem;
  problem.message = std::move(message);
  problem.found = std::move(found);
  problem.expected = std::move(expected);
  return problem;
}

// What cannot be read counts as given, so that all that is wrong is told at once.
std::optional<workflow::CellReach> cells_of(const char* option, const std::string& text, core::Problems& problems) {
  if (text.empty()) return std::nullopt;
  if (const auto cells = workflow::cells_from_text(text)) return cells;
  problems.push_back(unreadable(fmt::format("{}: no numbers of cells", option), text,
                                "cells of range, or RANGE:DOPPLER, for instance 16 or 8:2"));
  return workflow::CellReach{};
}

std::size_t size_or_0(std::optional<std::int64_t> number) { return static_cast<std::size_t>(number.value_or(0)); }

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

workflow::PulseRequest pulse_request(const SearchArguments& a) {
  using Kind = signal::CfarOptions::Kind;
  core::Problems windows;
  core::Problems cells;
  workflow::PulseRequest request{a.input};
  request.output = a.output;
  request.table = a.detections;
  if (a.interval) request.pulses = static_cast<std::size_t>(*a.interval);
  request.step = size_or_0(a.step);
  request.frequencies = size_or_0(a.frequencies);
  request.canceller = static_cast<std::size_t>(a.canceller.value_or(Canceller::none));
  const auto window = a.window.empty() ? signal::SarWindow{} : signal::window_from_text(a.window);
  if (window)
    request.window = *window;
  else
    windows.push_back(
        unreadable("--window: no window", a.window, "rectangular, hamming, hann, kaiser[:BETA] or taylor[:DB:NBAR]"));
  const Detector detector = a.detector.value_or(Detector::cell_averaging);
  request.detect = detector != Detector::none;
  request.detector = detector == Detector::ordered_statistic ? Kind::ordered_statistic : Kind::cell_averaging;
  request.guard = cells_of("--guard", a.guard, cells);
  request.train = cells_of("--train", a.train, cells);
  request.false_alarm = a.false_alarm;
  request.rank = a.rank;
  request.all_cells = a.all_cells;
  request.image = !a.no_map;
  request.replace = a.force;
  request.threads = static_cast<unsigned>(a.threads.value_or(0));
  if (windows.empty() && cells.empty()) return request;
  std::ranges::move(workflow::problems_of_request(request), std::back_inserter(windows));
  std::ranges::move(cells, std::back_inserter(windows));
  throw core::Refused(std::move(windows));
}

}  // namespace sarsim::cli
