#include "cli/command/stepped_options.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::cli {

void add_stepped_input_arguments(CLI::App& app, RecordingArguments& arguments) {
  add_recording_arguments(app, arguments, "the first that suits");
  add_scene_overrides(app, arguments.overrides);
}

VelocityChoice velocity_choice(const std::string& text) {
  using Velocity = workflow::SeriesOptions::Velocity;
  if (core::equal_ignoring_case(text, "none")) return {};
  if (core::equal_ignoring_case(text, "scene")) return {Velocity::scene, 0.0};
  if (core::equal_ignoring_case(text, "estimated")) return {Velocity::estimated, 0.0};
  const auto number = core::parse_number(text);
  if (number && std::abs(*number) < 1e6) return {Velocity::given, *number};
  throw core::Refused(fmt::format("--velocity: '{}' is none", text),
                      "none, scene, estimated or a number of m/s, positive receding");
}

void expect_searchable(double fastest_mps, const workflow::SteppedRows& rows) {
  const double most_mps = workflow::fastest_searched_mps(rows);
  if (fastest_mps <= most_mps) return;
  throw core::Refused(
      fmt::format("--fastest: bursts this long tell so many speeds up to {} m/s apart that they cannot all be "
                  "tried",
                  core::format_number(fastest_mps)),
      fmt::format("at most {:.6g} m/s", most_mps));
}

ProgressDisplay::Style display_style(const Streams& streams, bool quiet) {
  if (quiet) return ProgressDisplay::Style::none;
  return streams.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines;
}

}  // namespace sarsim::cli
