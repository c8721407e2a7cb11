#include <memory>
#include <ostream>
#include <ranges>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/isar_options.hpp"
#include "workflow/stepped/stepped_report.hpp"

namespace sarsim::cli {

namespace {

std::string summary_text(const workflow::WrittenIsarImage& written) {
  const workflow::IsarImage& made = written.image;
  return fmt::format(
      "{}: {} x {} pixels of {:.4g} x {:.4g} m, bursts {} to {}, {:.6g} to {:.6g} s; centre at {:.2f} m and {} "
      "m/s; turned by {:.4g} degrees; resolution {:.4g} m in cross-range (unambiguous {:.4g} m), {:.4g} m in range\n",
      written.file.string(), made.image.azimuth.count, made.image.range.count, made.image.azimuth.step_m,
      made.image.range.step_m, written.first_burst + 1, written.first_burst + written.bursts, made.from_s, made.to_s,
      made.range_m, decimals(made.speed_mps, 3), core::deg_per_rad * made.turn_rad, made.cross_range_resolution_m,
      made.unambiguous_cross_range_m, made.range_resolution_m);
}

std::string points_text(const workflow::IsarImage& made) {
  constexpr std::size_t most = 20;
  std::string text = fmt::format("{:>6} {:>25} {:>25} {:>25}\n", "", "expected m", "error m", "width m");
  text += fmt::format("{:>6} {:>14} {:>10} {:>14} {:>10} {:>14} {:>10} {:>9}\n", "target", "cross-range", "range",
                      "cross-range", "range", "cross-range", "range", "error dB");
  for (const workflow::HeldPoint& point : made.points | std::views::take(most)) {
    text +=
        fmt::format("{:>6} {:>14.3f} {:>10.3f}", point.target + 1, point.expected.azimuth_m, point.expected.range_m);
    if (point.found)
      text += fmt::format(" {:>14.3f} {:>10.3f} {:>14.3f} {:>10.3f} {:>9.2f}\n",
                          point.found->place.azimuth_m - point.expected.azimuth_m,
                          point.found->place.range_m - point.expected.range_m, point.found->azimuth.width,
                          point.found->range.width, core::amplitude_db(point.found->amplitude / point.amplitude));
    else
      text += point.outside ? "  outside the image\n" : "  no peak\n";
  }
  if (made.points.size() > most)
    text += fmt::format("and {}; --json lists them\n", counted(made.points.size() - most, "more target"));
  return text;
}

ExitStatus run_isar(const RequestArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.quiet);
  const workflow::IsarReport report =
      workflow::isar(workflow::isar_request(arguments.input, arguments.given()), watch.observer());
  watch.close();
  if (!arguments.quiet) {
    for (const workflow::WrittenIsarImage& image : report.images) write_err(streams, summary_text(image));
    write_err(streams, fmt::format("done in {}\n", core::duration_text(report.seconds)));
  }
  if (arguments.json)
    write_out(streams, workflow::json_of(report));
  else if (!arguments.quiet)
    for (const workflow::WrittenIsarImage& image : report.images) write_out(streams, points_text(image.image));
  flush_out(streams);
  return exit_done;
}

}  // namespace

Action add_isar(CLI::App& app) {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, workflow::isar_option_table().options(), *arguments);
  add_examples(app, {{"sarsim isar turning_ship.toml", "simulate and image: turning_ship-isar.img"},
                     {"sarsim isar turning_ship.toml --bursts 64 --step 32", "a series of images"},
                     {"sarsim isar sim1.h5 --motion estimated --window taylor:35:5", "without knowing the path"},
                     {"sarsim isar turning_ship.toml --algorithm back-projection", "exact for any turning"}});
  return [arguments](Streams& streams) { return run_isar(*arguments, streams); };
}

}  // namespace sarsim::cli
