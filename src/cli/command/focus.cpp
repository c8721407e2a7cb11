#include <string>

#include <fmt/format.h>

#include "cli/command/product_command.hpp"
#include "cli/shell/report.hpp"
#include "core/text/number_text.hpp"

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

ProductText text_of_focus(const workflow::FocusReport& report, const workflow::FocusRequest& request) {
  std::string text = text_of_image(request.output.string(), report);
  if (report.motion != workflow::MotionOrder::none)
    text +=
        fmt::format("  motion compensation of {} order: the track deviates from the fitted line by up to {:.3g} m\n",
                    to_string(report.motion), report.strays_m);
  if (report.autofocus) text += text_of_autofocus(*report.autofocus);
  return {text};
}

}  // namespace

Action add_focus(CLI::App& app) {
  return add_product(app, workflow::focus_product,
                     {{"sarsim focus sar_r.toml", "simulate and focus: sar_r.img with its header sar_r.hdr"},
                      {"sarsim focus sim1.h5 --window taylor:35:5", "a recording, with lower sidelobes"},
                      {"sarsim focus sim1.bin --script scene.toml --out image.npy", "a file without its script"},
                      {"sarsim focus flight.h5 --autofocus --autofocus-phase phase.csv", "with phase errors removed"},
                      {"sarsim focus sar_r.toml --algorithm back-projection --grid ground", "onto level ground"},
                      {"sarsim focus big.h5 --memory 500M --scratch /data", "in less memory than the image"}},
                     text_of_focus, "scene to simulate and focus, or file of samples");
}

}  // namespace sarsim::cli
