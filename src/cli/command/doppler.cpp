#include <cmath>

#include <fmt/format.h>

#include "cli/command/doppler_report.hpp"
#include "cli/command/product_command.hpp"

namespace sarsim::cli {

namespace {

std::string maps_text(const workflow::DopplerReport& report) {
  const std::string ranges =
      fmt::format("{} ranges {:.1f} to {:.1f} m, ", report.columns, report.range_first_m, report.range_last_m);
  if (!report.doppler()) return ranges;
  return fmt::format("{} frequencies {:.4g} Hz ({:.4g} m/s) apart x ", report.rows, report.doppler_step_hz,
                     std::abs(report.speed_step_mps)) +
         ranges;
}

ProductText text_of_doppler(const workflow::DopplerReport& report, const workflow::DopplerRequest& /*request*/) {
  return {text_of_pulses(report, maps_text(report))};
}

}  // namespace

Action add_doppler(CLI::App& app) {
  return add_product(app, workflow::doppler_product,
                     {{"sarsim doppler mti.toml --canceller two", "moving targets: mti-doppler.img and its detections"},
                      {"sarsim doppler sim1.h5 --interval 128 --step 64 --window hamming", "overlapping intervals"},
                      {"sarsim doppler sim1.bin --script scene.toml --out maps.npy", "a file without its script"},
                      {"sarsim doppler mti.toml --cfar os --train 12:2 --pfa 1e-5", "another detector"}},
                     text_of_doppler);
}

}  // namespace sarsim::cli
