#include "scene/ephemeris/write_motion.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/ephemeris/motion_checks.hpp"

namespace sarsim::scene {

namespace {

using ephemeris::append_vector;
using ephemeris::fault_of_message;
using ephemeris::fault_of_motion;
using ephemeris::refused;
using ephemeris::stamp_of;
using Fault = std::optional<core::Problem>;

// Earth-fixed where there is an Earth.
MotionSample outward(const MotionSample& sample, const std::optional<radar::EarthFrame>& earth) {
  if (!earth) return sample;
  return {sample.time_s, earth->ecef_from_world(sample.position_m), earth->ecef_axes_from_world(sample.velocity_mps)};
}

// A piece of a comment that cannot break it.
std::string on_one_line(std::string_view text) {
  std::string line = core::printable(text);
  for (char& c : line)
    if (c == '\n' || c == '\t') c = ' ';
  return line;
}

std::string csv_comments(const MotionFacts& facts) {
  std::string text = fmt::format("# Motion of {}, written by Sarsim\n", on_one_line(facts.object_name));
  if (!facts.created.empty()) text += fmt::format("# Created {}\n", on_one_line(facts.created));
  text += facts.epoch ? fmt::format("# t: s after {}\n", radar::format_instant(*facts.epoch, radar::TimeScale::utc, 15))
                      : "# t: s after the epoch of the scene\n";
  text += facts.earth ? "# Earth-fixed axes (ECEF, ITRF) from the centre of the Earth, m and m/s\n"
                      : "# Axes of the world, x east, y north, z up, m and m/s\n";
  if (const std::string_view method = ephemeris::word_of(facts.interpolation.method); !method.empty())
    text += fmt::format("# Interpolation {}, degree {}\n", method, facts.interpolation.degree);
  return text;
}

// Hermite's polynomials take two conditions from each state, Lagrange's one.
Fault fault_of_interpolation(std::size_t count, const InterpolationHint& interpolation) {
  const std::size_t conditions = interpolation.degree > 0 ? static_cast<std::size_t>(interpolation.degree) + 1 : 2;
  const bool hermite = interpolation.method == InterpolationMethod::hermite;
  const std::size_t needed = hermite ? (conditions + 1) / 2 : conditions;
  if (interpolation.method == InterpolationMethod::unsaid || count >= needed) return std::nullopt;
  return core::error("there are too few samples for the interpolation")
      .found(fmt::format("{} samples", count))
      .expected(fmt::format("at least {} for degree {}", needed, conditions - 1))
      .hint("choose a closer spacing or a lower degree");
}

}  // namespace

MotionText write_motion_csv(std::span<const MotionSample> samples, const MotionFacts& facts) {
  if (Fault fault = fault_of_motion(samples, facts, 0.0)) return refused(*std::move(fault));
  MotionText result{csv_comments(facts) + "t,x,y,z,vx,vy,vz\n", {}};
  for (const MotionSample& sample : samples) {
    const MotionSample state = outward(sample, facts.earth);
    core::append_number(result.text, state.time_s);
    append_vector(result.text, state.position_m, ",", 0);
    append_vector(result.text, state.velocity_mps, ",", 0);
    result.text += '\n';
  }
  return result;
}

MotionText write_motion_oem(std::span<const MotionSample> samples, const MotionFacts& facts) {
  constexpr int to_km = -3;
  if (Fault fault = fault_of_motion(samples, facts, ephemeris::closest_dates_s)) return refused(*std::move(fault));
  const double first_s = samples.front().time_s;
  const double last_s = samples.back().time_s;
  if (Fault fault = fault_of_message(first_s, last_s, facts)) return refused(*std::move(fault));
  if (Fault fault = fault_of_interpolation(samples.size(), facts.interpolation)) return refused(*std::move(fault));
  MotionText result{
      ephemeris::message_head("CCSDS_OEM_VERS", "2.0", "motion of one platform, Earth-fixed, km and km/s", facts), {}};
  result.text += "REF_FRAME = ITRF\n";
  result.text += ephemeris::time_lines(first_s, last_s, *facts.epoch);
  result.text += ephemeris::interpolation_lines("INTERPOLATION", facts.interpolation);
  result.text += "META_STOP\n";
  for (const MotionSample& sample : samples) {
    const MotionSample state = outward(sample, facts.earth);
    result.text += stamp_of(*facts.epoch, sample.time_s);
    append_vector(result.text, state.position_m, " ", to_km);
    append_vector(result.text, state.velocity_mps, " ", to_km);
    result.text += '\n';
  }
  return result;
}

std::array<core::SampledFunction, 3> trajectory_functions(std::span<const MotionSample> samples,
                                                          core::Interpolation method) {
  std::array<core::SampledFunction, 3> functions;
  for (core::SampledFunction& function : functions) {
    function.method = method;
    function.knots.reserve(samples.size());
  }
  for (const MotionSample& sample : samples) {
    functions[0].knots.push_back({sample.time_s, sample.position_m.x});
    functions[1].knots.push_back({sample.time_s, sample.position_m.y});
    functions[2].knots.push_back({sample.time_s, sample.position_m.z});
  }
  return functions;
}

}  // namespace sarsim::scene
