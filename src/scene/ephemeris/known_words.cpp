#include "scene/ephemeris/known_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::scene {

std::string_view name_of(Frame frame) {
  switch (frame) {
    case Frame::itrf: return "ITRF";
    case Frame::teme: return "TEME";
    case Frame::eme2000: return "EME2000";
    case Frame::gcrf: return "GCRF";
  }
  return "";
}

namespace ephemeris {

namespace {

// "ITRF", "ITRF2014", "ITRF-97".
bool is_itrf(std::string_view word) {
  if (!core::equal_ignoring_case(word.substr(0, 4), "ITRF")) return false;
  word.remove_prefix(4);
  if (word.starts_with('-')) word.remove_prefix(1);
  if (word.size() > 4) return false;
  return std::ranges::all_of(word, core::is_digit);
}

std::string hint_for_frame(std::string_view word) {
  const std::string lower = core::lower_case(word.substr(0, 8));
  if (lower == "j2000") return "if the mean equator and equinox of J2000 are meant, write EME2000";
  if (lower == "tod" || lower == "efg" || lower == "grc" || lower == "tdr" || lower == "mod")
    return "convert the file to one of them with the tool that made it";
  return "";
}

}  // namespace

std::optional<Frame> read_frame(std::string_view at, FileProblems& problems) {
  if (is_itrf(at)) return Frame::itrf;
  if (core::equal_ignoring_case(at, "TEME") || core::equal_ignoring_case(at, "TEMEOFDATE")) return Frame::teme;
  if (core::equal_ignoring_case(at, "EME2000")) return Frame::eme2000;
  if (core::equal_ignoring_case(at, "GCRF") || core::equal_ignoring_case(at, "ICRF")) return Frame::gcrf;
  problems.error(at, {"the frame is not known", core::clipped(at),
                      "one of ITRF (with or without a year), TEME, EME2000, "
                      "GCRF, ICRF",
                      hint_for_frame(at)});
  return std::nullopt;
}

std::optional<radar::TimeScale> read_scale(std::string_view at, FileProblems& problems) {
  for (const radar::TimeScale scale : {radar::TimeScale::utc, radar::TimeScale::tai, radar::TimeScale::gps,
                                       radar::TimeScale::tt, radar::TimeScale::ut1})
    if (core::equal_ignoring_case(at, name_of(scale))) return scale;
  problems.error(at, {"the time system is not known", core::clipped(at), "one of UTC, TAI, GPS, TT, UT1",
                      "convert the file to one of them with the tool that made it"});
  return std::nullopt;
}

InterpolationMethod read_interpolation(std::string_view at, FileProblems& problems) {
  if (core::equal_ignoring_case(at, "LINEAR")) return InterpolationMethod::linear;
  if (core::equal_ignoring_case(at, "LAGRANGE")) return InterpolationMethod::lagrange;
  if (core::equal_ignoring_case(at, "HERMITE")) return InterpolationMethod::hermite;
  problems.warning(at, {"the method of interpolation is not known and is ignored", core::clipped(at),
                        "one of LINEAR, LAGRANGE, HERMITE", ""});
  return InterpolationMethod::unsaid;
}

bool read_time(std::string_view at, std::string_view words, std::optional<radar::TimeScale> scale,
               FileProblems& problems, radar::CivilTime& time) {
  const std::optional<radar::CivilTime> read = radar::parse_civil(at).time;
  if (!read) {
    problems.error(
        at, {fmt::format("{} is not a time", words), core::clipped(at), std::string(radar::civil_time_forms), ""});
    return false;
  }
  if (read->second == 60 && scale && *scale != radar::TimeScale::utc) {
    problems.error(at, {fmt::format("{} is in a leap second, which {} does not have", words, name_of(*scale)),
                        core::clipped(at), "seconds below 60", "is the time system UTC?"});
    return false;
  }
  time = *read;
  return true;
}

}  // namespace ephemeris

}  // namespace sarsim::scene
