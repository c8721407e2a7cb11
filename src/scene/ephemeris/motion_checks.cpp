#include "scene/ephemeris/motion_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/leap_seconds.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

namespace sarsim::scene::ephemeris {

namespace {

using Fault = std::optional<core::Problem>;

constexpr double lowest_height_m = -900.0;  // readers refuse what is 1 km below the surface
constexpr double max_distant_m = 1e9;
constexpr std::size_t longest_name = 200;  // a line of a CCSDS message has 254 characters

bool finite(const core::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Fault fault_of_place(const core::Vec3& position_m, double time_s, const radar::EarthFrame& earth) {
  const double distance_m = core::norm(earth.ecef_from_world(position_m));
  if (!(distance_m <= max_distant_m))
    return core::error(fmt::format("the platform is too far from the Earth at {} s", core::format_number(time_s)))
        .found(fmt::format("{:.6g} m from its centre", distance_m))
        .expected(fmt::format("at most {:.0e} m", max_distant_m));
  const double height_m = earth.geodetic_of(position_m).height_m;
  if (!(height_m >= lowest_height_m))
    return core::error(fmt::format("the platform is below the ground at {} s", core::format_number(time_s)))
        .found(fmt::format("{:.6g} m above the ellipsoid", height_m))
        .expected(fmt::format("at least {} m", lowest_height_m))
        .hint("are heights and the anchor of the world right?");
  return std::nullopt;
}

// Whether a value can stand behind "KEY =" and be read back: one line, no blanks at its ends, and no unit "[km]".
Fault fault_of_name(std::string_view what, std::string_view value) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7F'; };
  const bool fits = !value.empty() && value.size() <= longest_name && core::trimmed(value) == value &&
                    std::ranges::none_of(value, is_control) && !value.ends_with(']');
  if (fits) return std::nullopt;
  return core::error(fmt::format("{} is not allowed in a CCSDS message", what))
      .found(core::clipped(value))
      .expected(
          fmt::format("1 to {} characters on one line, without blanks at the ends and ] at the end", longest_name))
      .hint("give the platform another name for the file");
}

// Within the years of the calendar, and without a leap second, by which UTC would not count evenly.
Fault fault_of_calendar(double first_s, double last_s, const radar::Instant& epoch) {
  constexpr double longest_s = 3e11;
  const std::int64_t utc_begins_s = 86'400 * radar::first_utc_day_mjd + 10;
  if (!(std::max(std::abs(first_s), std::abs(last_s)) <= longest_s))
    return core::error("a time is too far from the epoch")
        .found(fmt::format("{} to {} s", first_s, last_s))
        .expected(fmt::format("within {:.0e} s", longest_s));
  const radar::Instant first = radar::later(epoch, first_s);
  const radar::Instant last = radar::later(epoch, last_s);
  if (first.tai_s < utc_begins_s || radar::civil_of(last, radar::TimeScale::utc).year > 9999)
    return core::error("a time is outside of the calendar")
        .found(fmt::format("{} to {} s after the epoch", first_s, last_s))
        .expected("times from 1972 to 9999")
        .hint("correct the epoch of the scene");
  if (!radar::leap_second_between(first, last)) return std::nullopt;
  return core::error("a leap second lies among the samples")
      .found(fmt::format("{} to {}", radar::format_instant(first, radar::TimeScale::utc),
                         radar::format_instant(last, radar::TimeScale::utc)))
      .expected("a time without one, because times of UTC are not evenly spaced there")
      .hint("write the times before and after it into two files, or move the epoch of the scene");
}

}  // namespace

Fault fault_of_count(std::size_t count) {
  if (count > 0 && count <= max_ephemeris_states) return std::nullopt;
  return core::error(count == 0 ? "there are no samples to write" : "there are too many samples to write")
      .found(fmt::format("{} samples", count))
      .expected(fmt::format("1 to {}", max_ephemeris_states))
      .hint("choose another spacing or other times");
}

Fault fault_of_time(std::size_t sample, std::optional<double> before_s, double time_s, double closest_s) {
  if (!std::isfinite(time_s))
    return core::error(fmt::format("the time of sample {} is not finite", sample + 1))
        .found(fmt::format("{}", time_s))
        .expected("a number of seconds");
  if (!before_s || (time_s > *before_s && time_s - *before_s >= closest_s)) return std::nullopt;
  if (time_s > *before_s)
    return core::error(fmt::format("samples {} and {} are too close for dates", sample, sample + 1))
        .found(fmt::format("{} s apart", time_s - *before_s))
        .expected(fmt::format("at least {} s", closest_s));
  return core::error(fmt::format("the time of sample {} does not ascend", sample + 1))
      .found(core::format_number(time_s) + " s")
      .expected(fmt::format("above {} s", core::format_number(*before_s)))
      .hint("sort the samples by time and give each time once");
}

Fault fault_of_motion(std::span<const MotionSample> samples, const MotionFacts& facts, double closest_s) {
  if (Fault fault = fault_of_times(samples, closest_s)) return fault;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const MotionSample& sample = samples[i];
    if (!finite(sample.position_m) || !finite(sample.velocity_mps))
      return core::error(
                 fmt::format("the position or velocity at {} s is not finite", core::format_number(sample.time_s)))
          .found(fmt::format("sample {}", i + 1))
          .expected("finite numbers");
    if (!facts.earth) continue;
    if (Fault fault = fault_of_place(sample.position_m, sample.time_s, *facts.earth)) return fault;
  }
  return std::nullopt;
}

Fault fault_of_message(double first_s, double last_s, const MotionFacts& facts) {
  if (!facts.epoch)
    return core::error("the scene has no epoch, and this format has dates only")
        .expected("an epoch")
        .hint("give the scene an epoch, or write a CSV table");
  if (!facts.earth)
    return core::error("the scene does not lie on the Earth, and this format has positions from its centre only")
        .expected("an anchor")
        .hint("give the scene an anchor on the Earth, or write a CSV table");
  if (!radar::parse_civil(facts.created).time)
    return core::error("the creation date is not a time")
        .found(core::clipped(facts.created))
        .expected(std::string(radar::civil_time_forms));
  if (Fault fault = fault_of_name("the name", facts.object_name)) return fault;
  if (Fault fault = fault_of_name("the identifier", facts.object_id)) return fault;
  return fault_of_calendar(first_s, last_s, *facts.epoch);
}

void append_vector(std::string& text, const core::Vec3& v, std::string_view separator, int exponent_shift) {
  for (const double part : {v.x, v.y, v.z}) {
    text += separator;
    core::append_number(text, part, exponent_shift);
  }
}

std::string stamp_of(const radar::Instant& epoch, double time_s) {
  constexpr int fewest_digits = 12;
  constexpr int max_digits = 15;
  const radar::Instant instant = radar::later(epoch, time_s);
  std::string text;
  for (int digits = fewest_digits; digits <= max_digits; ++digits) {
    text = radar::format_instant(instant, radar::TimeScale::utc, digits);
    const std::optional<radar::Instant> read = radar::parse_instant(text, radar::TimeScale::utc).instant;
    if (read && radar::seconds_between(epoch, *read) == time_s) break;
  }
  text.pop_back();
  return text;
}

std::string message_head(std::string_view version_key, std::string_view version, std::string_view comment,
                         const MotionFacts& facts) {
  return fmt::format(
      "{} = {}\n"
      "COMMENT {}\n"
      "{}"
      "CREATION_DATE = {}\n"
      "ORIGINATOR = SARSIM\n"
      "\n"
      "META_START\n"
      "OBJECT_NAME = {}\n"
      "OBJECT_ID = {}\n"
      "CENTER_NAME = EARTH\n",
      version_key, version, comment,
      facts.created_is_epoch ? "COMMENT CREATION_DATE is the epoch of the scene: the same scene gives the same file\n"
                             : "",
      facts.created, facts.object_name, facts.object_id);
}

std::string time_lines(double first_s, double last_s, const radar::Instant& epoch) {
  return fmt::format("TIME_SYSTEM = UTC\nSTART_TIME = {}\nSTOP_TIME = {}\n", stamp_of(epoch, first_s),
                     stamp_of(epoch, last_s));
}

std::string_view word_of(InterpolationMethod method) {
  switch (method) {
    case InterpolationMethod::unsaid: break;
    case InterpolationMethod::linear: return "LINEAR";
    case InterpolationMethod::lagrange: return "LAGRANGE";
    case InterpolationMethod::hermite: return "HERMITE";
  }
  return "";
}

std::string interpolation_lines(std::string_view method_key, const InterpolationHint& interpolation) {
  const std::string_view method = word_of(interpolation.method);
  if (method.empty()) return "";
  std::string text = fmt::format("{} = {}\n", method_key, method);
  if (interpolation.degree > 0) text += fmt::format("INTERPOLATION_DEGREE = {}\n", interpolation.degree);
  return text;
}

}  // namespace sarsim::scene::ephemeris
