#include "gui/scene/geometry_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/separated.hpp"
#include "radar/path/path.hpp"
#include "scene/check/check.hpp"

namespace sarsim::gui {

namespace {

std::size_t radar_of(const scene::Scene& scene, const scene::GeometryTable& table) {
  const std::size_t found = scene::find_radar(scene, table.radar);
  if (found == scene::not_found) throw std::invalid_argument("radar '" + table.radar + "' is not defined");
  return found;
}

void add(std::vector<double>& values, const core::Vec3& v) { values.insert(values.end(), {v.x, v.y, v.z}); }

}  // namespace

GeometryRows::GeometryRows(const scene::Scene& scene, GeometryChoice choice)
    : choice_(std::move(choice)),
      resolved_(simulate::resolve(scene)),
      radar_(simulate::resolve_radar(scene, resolved_, radar_of(scene, choice_.table))),
      geometry_(resolved_, radar_),
      range_(radar_.repetition.pulses_in(choice_.table.time_start_s, choice_.table.time_end_s)),
      platforms_(scene.platforms.size()) {
  std::erase_if(choice_.targets, [&](std::size_t target) { return target >= scene.targets.size(); });
  add_headings(scene);
}

void GeometryRows::add_headings(const scene::Scene& scene) {
  headings_.push_back({"Pulse", "", "", 1.0, 17});
  if (has(simulate::geometry_time)) headings_.push_back({"Send time", "", "s", 1.0, 10});
  if (has(simulate::geometry_frequency)) headings_.push_back({"Frequency", "", "GHz", 1e9, 10});
  for (const scene::Platform& platform : scene.platforms) {
    const auto three = [&](const std::string& quantity, const std::string& unit) {
      for (const char axis : {'X', 'Y', 'Z'}) headings_.push_back({quantity + ' ' + axis, platform.name, unit});
    };
    if (has(simulate::geometry_position)) three("Position", "m");
    if (has(simulate::geometry_velocity)) three("Velocity", "m/s");
    if (has(simulate::geometry_rotation)) three("Rotation", "deg");
  }
  for (const std::size_t target : choice_.targets) {
    const std::string owner = "Target " + std::to_string(target + 1);
    if (choice_.distance) headings_.push_back({"Distance", owner, "m", 1.0, 12});
    if (has(simulate::geometry_delay)) headings_.push_back({"Two-way delay", owner, "s", 1.0, 12});
    if (has(simulate::geometry_amplitude)) headings_.push_back({"Amplitude", owner, "V", 1.0, 12});
    if (has(simulate::geometry_speed)) headings_.push_back({"Radial speed", owner, "m/s", 1.0, 11});
  }
}

std::vector<double> GeometryRows::values(std::int64_t first_row, std::int64_t rows) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(rows) * headings_.size());
  for (std::int64_t row = first_row; row < first_row + rows && row < count(); ++row) {
    geometry_.set_pulse(range_.first + row);
    add_row(values);
  }
  return values;
}

void GeometryRows::add_row(std::vector<double>& values) const {
  values.push_back(static_cast<double>(geometry_.pulse()));
  if (has(simulate::geometry_time)) values.push_back(geometry_.send_time_s());
  if (has(simulate::geometry_frequency)) values.push_back(geometry_.carrier_hz());
  if (has(simulate::geometry_position) || has(simulate::geometry_velocity) || has(simulate::geometry_rotation))
    for (std::size_t i = 0; i < platforms_; ++i) {
      const radar::Pose pose = resolved_.platforms[i].track.at(geometry_.send_time_s(), geometry_.pulse());
      if (has(simulate::geometry_position)) add(values, pose.position_world_m);
      if (has(simulate::geometry_velocity)) add(values, pose.velocity_world_mps);
      if (has(simulate::geometry_rotation))
        for (const double angle_rad : pose.rotation_rad) values.push_back(core::deg_per_rad * angle_rad);
    }
  for (const std::size_t target : choice_.targets) add_target(target, values);
}

void GeometryRows::add_target(std::size_t target, std::vector<double>& values) const {
  const simulate::ScattererView view = geometry_.view(target);
  const double range_m = radar::range_of(view.delay_s, resolved_.conventions.light_speed_mps);
  const bool seen = range_m >= choice_.table.range_start_m && range_m <= choice_.table.range_end_m;
  const auto put = [&](bool wanted, double value) {
    if (wanted) values.push_back(seen ? value : std::numeric_limits<double>::quiet_NaN());
  };
  put(choice_.distance, view.distance_m);
  put(has(simulate::geometry_delay), view.delay_s);
  put(has(simulate::geometry_amplitude), std::abs(view.amplitude_sqrt_w));
  put(has(simulate::geometry_speed), view.speed_mps);
}

core::Problems geometry_errors(const scene::Scene& scene, const scene::GeometryTable& table) {
  scene::Scene one = scene;
  one.simulations.clear();
  one.geometries = {table};
  core::Problems problems = core::ranked(scene::check(one));
  std::erase_if(problems, [](const core::Problem& problem) { return problem.severity != core::Severity::error; });
  return problems;
}

NumberChoice read_numbers(std::string_view text, std::size_t count) {
  std::set<std::size_t> chosen;
  const auto refuse = [](std::string_view piece, const std::string& why) {
    return NumberChoice{{}, "'" + std::string(piece.substr(0, 40)) + "' " + why};
  };
  for (const std::string_view piece : core::pieces_of(text, ',')) {
    if (piece.empty()) continue;
    const std::size_t dash = piece.find('-', 1);
    const auto first = core::parse_integer(core::trimmed(piece.substr(0, dash)));
    const auto last =
        dash == std::string_view::npos ? first : core::parse_integer(core::trimmed(piece.substr(dash + 1)));
    if (!first || !last || *first < 1 || *last < *first)
      return refuse(piece, "is not a number or a range such as 1-20");
    if (static_cast<std::uint64_t>(*last) > count)
      return refuse(piece, "goes beyond the last, number " + std::to_string(count));
    for (auto number = *first; number <= *last; ++number) chosen.insert(static_cast<std::size_t>(number - 1));
  }
  return {{chosen.begin(), chosen.end()}, {}};
}

}  // namespace sarsim::gui
