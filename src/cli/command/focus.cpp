#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/text/number_text.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/focus/focus_report.hpp"

namespace sarsim::cli {

namespace {

std::string text_of_image(const std::string& output, const workflow::FocusReport& report) {
  const signal::FocusedImage& image = report.image.image;
  const auto last = [](const signal::ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); };
  return fmt::format(
      "{}: {} x {} samples by {}, azimuth {:.1f} to {:.1f} m, {} {:.1f} to {:.1f} m, Doppler centroid {} Hz, {}{}\n",
      output, image.azimuth.count, image.range.count, word_of(report.algorithm), image.azimuth.first_m,
      last(image.azimuth), report.grid == workflow::FocusGrid::ground ? "ground range" : "slant range",
      image.range.first_m, last(image.range), decimals(report.options.doppler_centroid_hz, 1),
      core::duration_text(report.seconds), report.image.on_disk ? " (worked on disk)" : "");
}

std::string text_of_autofocus(const workflow::AutofocusFinding& found) {
  std::string text = fmt::format(
      "  autofocus {} {:.3g} rad rms (sub-apertures of {:.4g} m): entropy {:.3f} before, {:.3f} after; contrast {:.3g} "
      "before, {:.3g} after",
      found.applied ? "removed" : "would remove", found.rms_rad, found.piece_m, found.entropy_before,
      found.entropy_after, found.contrast_before, found.contrast_after);
  if (found.points > 0)
    text += fmt::format("; SNR of {} {:.1f} dB before, {:.1f} dB after", counted(found.points, "point"),
                        found.point_snr_before_db, found.point_snr_after_db);
  return text + (found.applied ? "\n" : "; it failed, and the image is unchanged\n");
}

ExitStatus run_focus(const RequestArguments& arguments, Streams& streams) {
  const workflow::FocusRequest request = workflow::focus_request(arguments.input, arguments.given());
  Watch watch(streams, arguments.quiet);
  const workflow::FocusReport report = workflow::focus(request, watch.observer());
  watch.close();
  if (!arguments.quiet) {
    write_err(streams, text_of_image(request.output.string(), report));
    if (report.motion != workflow::MotionOrder::none)
      write_err(
          streams,
          fmt::format("  motion compensation of {} order: the track deviates from the fitted line by up to {:.3g} m\n",
                      to_string(report.motion), report.strays_m));
    if (report.autofocus) write_err(streams, text_of_autofocus(*report.autofocus));
  }
  if (!arguments.json) return exit_done;
  write_out(streams, workflow::json_of(arguments.input, report));
  flush_out(streams);
  return exit_done;
}

}  // namespace

Action add_focus(CLI::App& app) {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, workflow::focus_option_table().options(), *arguments,
                        "scene to simulate and focus, or file of samples");
  add_examples(app, {{"sarsim focus sar_r.toml", "simulate and focus: sar_r.img with its header sar_r.hdr"},
                     {"sarsim focus sim1.h5 --window taylor:35:5", "a recording, with lower sidelobes"},
                     {"sarsim focus sim1.bin --script scene.toml --out image.npy", "a file without its script"},
                     {"sarsim focus flight.h5 --autofocus --autofocus-phase phase.csv", "with phase errors removed"},
                     {"sarsim focus sar_r.toml --algorithm back-projection --grid ground", "onto level ground"},
                     {"sarsim focus big.h5 --memory 500M --scratch /data", "in less memory than the image"}});
  return [arguments](Streams& streams) { return run_focus(*arguments, streams); };
}

}  // namespace sarsim::cli
