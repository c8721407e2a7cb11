#include "scene/ephemeris/omm_record.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/ephemeris/known_words.hpp"

namespace sarsim::scene::ephemeris {

namespace {

struct OmmWord {
  std::string_view word;
  std::string_view unit;
};

// In the order of OmmKey.
constexpr std::array<OmmWord, static_cast<std::size_t>(OmmKey::none)> omm_words{{
    {"OBJECT_NAME", ""},
    {"OBJECT_ID", ""},
    {"CENTER_NAME", ""},
    {"REF_FRAME", ""},
    {"TIME_SYSTEM", ""},
    {"MEAN_ELEMENT_THEORY", ""},
    {"EPOCH", ""},
    {"MEAN_MOTION", "rev/day"},
    {"SEMI_MAJOR_AXIS", "km"},
    {"ECCENTRICITY", ""},
    {"INCLINATION", "deg"},
    {"RA_OF_ASC_NODE", "deg"},
    {"ARG_OF_PERICENTER", "deg"},
    {"MEAN_ANOMALY", "deg"},
    {"EPHEMERIS_TYPE", ""},
    {"NORAD_CAT_ID", ""},
    {"ELEMENT_SET_NO", ""},
    {"REV_AT_EPOCH", ""},
    {"BSTAR", "1/ER"},
    {"BTERM", "m**2/kg"},
    {"MEAN_MOTION_DOT", "rev/day**2"},
    {"MEAN_MOTION_DDOT", "rev/day**3"},
}};

const OmmWord& word_of(OmmKey key) { return omm_words[static_cast<std::size_t>(key)]; }

bool is_convention(OmmKey key) {
  return key == OmmKey::center_name || key == OmmKey::ref_frame || key == OmmKey::time_system ||
         key == OmmKey::mean_element_theory;
}

constexpr double rad_of_deg = std::numbers::pi / 180.0;
constexpr double radps_of_rev_per_day = 2.0 * std::numbers::pi / 86400.0;

}  // namespace

OmmKey omm_key_of(std::string_view word) {
  for (std::size_t i = 0; i < omm_words.size(); ++i)
    if (omm_words[i].word == word) return static_cast<OmmKey>(i);
  return OmmKey::none;
}

void OmmRecord::begin(std::string_view at) {
  for (Value& value : values_) {
    value.text.clear();
    value.at = {};
  }
  at_ = at;
  empty_ = true;
}

void OmmRecord::miss_value(OmmKey key, std::string_view at, FileProblems& problems) {
  if (key == OmmKey::none) return;
  problems.error(at, {fmt::format("{} has no value", word_of(key).word), "", "a value, or no such keyword", ""});
  empty_ = false;
}

void OmmRecord::set(OmmKey key, std::string value, std::string_view at, std::string_view unit, FileProblems& problems) {
  if (key == OmmKey::none) return;
  // What the elements mean may be left out, but not be left empty.
  const bool quoted = at.starts_with('"');  // A null and a cell with nothing in it are left out.
  if (value.empty()) return quoted && is_convention(key) ? miss_value(key, at, problems) : void();
  Value& kept = values_[static_cast<std::size_t>(key)];
  if (!kept.text.empty())
    problems.error(at, {fmt::format("{} appears twice in one message", word_of(key).word), core::clipped(value),
                        "each keyword once", ""});
  if (!unit.empty() && !core::equal_ignoring_case(unit, word_of(key).unit))
    problems.error(at, {fmt::format("{} has another unit than it should", word_of(key).word), core::clipped(unit),
                        std::string(word_of(key).unit), "convert the number"});
  kept = {std::move(value), at};
  empty_ = false;
}

void OmmRecord::finish(const ReaderInput& input, MeanElementsFile& file) {
  if (empty_) return;
  if (!input.choice.takes(of(OmmKey::object_name).text, of(OmmKey::norad_cat_id).text.empty()
                                                            ? of(OmmKey::object_id).text
                                                            : of(OmmKey::norad_cat_id).text))
    return;
  check_conventions(input.problems);
  ElementSet set;
  if (read_elements(input.problems, set)) file.sets.push_back(std::move(set));
}

// What the message says of its own meaning; tables and JSON of catalogues leave it out, for it is always the same.
void OmmRecord::check_conventions(FileProblems& problems) const {
  const auto check = [&](OmmKey key, std::initializer_list<std::string_view> allowed, const char* expected,
                         const char* hint) {
    const Value& value = of(key);
    if (value.text.empty()) return;
    for (const std::string_view one : allowed)
      if (core::equal_ignoring_case(value.text, one)) return;
    problems.error(value.at, {fmt::format("{} is not what SGP4 needs", word_of(key).word), core::clipped(value.text),
                              expected, hint});
  };
  const char* const only_sgp4 = "mean elements of other theories are not read; convert them to an OEM";
  check(OmmKey::center_name, {"EARTH"}, "EARTH", "");
  check(OmmKey::ref_frame, {"TEME", "TEMEOFDATE"}, "TEME", only_sgp4);
  check(OmmKey::time_system, {"UTC"}, "UTC", "");
  check(OmmKey::mean_element_theory, {"SGP4", "SGP/SGP4", "SGP4/SDP4"}, "SGP4", only_sgp4);
  check(OmmKey::ephemeris_type, {"0", "2", "3"}, "0, which is SGP4", only_sgp4);
  if (!of(OmmKey::bterm).text.empty())
    problems.error(of(OmmKey::bterm).at,
                   {"BTERM belongs to SGP4-XP", core::clipped(of(OmmKey::bterm).text), "BSTAR of SGP4", only_sgp4});
  if (of(OmmKey::mean_motion).text.empty() && !of(OmmKey::semi_major_axis).text.empty())
    problems.error(of(OmmKey::semi_major_axis).at,
                   {"SGP4 needs a mean motion, not an axis", core::clipped(of(OmmKey::semi_major_axis).text),
                    "MEAN_MOTION in rev/day", only_sgp4});
}

bool OmmRecord::read(OmmKey key, bool required, double low, double high, FileProblems& problems, double& value) const {
  const Value& kept = of(key);
  const OmmWord& word = word_of(key);
  const std::string range = fmt::format("a number from {} to {}{}{}", core::format_number(low),
                                        core::format_number(high), word.unit.empty() ? "" : " in ", word.unit);
  if (kept.text.empty()) {
    const bool told = key == OmmKey::mean_motion && !of(OmmKey::semi_major_axis).text.empty();
    if (required && !told) problems.error(at_, {fmt::format("{} is missing", word.word), "", range, ""});
    return !required;
  }
  const auto number = core::parse_number(kept.text);
  if (!number || *number < low || *number > high) {
    problems.error(kept.at, {fmt::format("{} is {}", word.word, number ? "out of range" : "not a finite number"),
                             core::clipped(kept.text), range, ""});
    return false;
  }
  value = *number;
  return true;
}

bool OmmRecord::read_whole(OmmKey key, bool required, FileProblems& problems, int& value) const {
  const Value& kept = of(key);
  const OmmWord& word = word_of(key);
  if (kept.text.empty()) {
    if (required) problems.error(at_, {fmt::format("{} is missing", word.word), "", "a whole number", ""});
    return !required;
  }
  const auto number = core::parse_integer(kept.text);
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) {
    problems.error(kept.at, {fmt::format("{} is not a whole number", word.word), core::clipped(kept.text),
                             "a whole number from 0", ""});
    return false;
  }
  value = static_cast<int>(*number);
  return true;
}

// The axis of a mean motion: n^2 a^3 = GM, to the thousandth by which definitions of mean elements differ.
void OmmRecord::compare_axis(FileProblems& problems, double motion_rev_per_day) const {
  constexpr double share = 0.01;
  constexpr double gm_km3_per_s2 = 398600.8;  // WGS 72, as of SGP4.
  const Value& kept = of(OmmKey::semi_major_axis);
  const auto axis_km = core::parse_number(kept.text);
  if (kept.text.empty()) return;
  const double rate = motion_rev_per_day * radps_of_rev_per_day;
  const double expected_km = std::cbrt(gm_km3_per_s2 / (rate * rate));
  if (axis_km && std::abs(*axis_km - expected_km) <= share * expected_km) return;
  problems.warning(kept.at,
                   {"SEMI_MAJOR_AXIS is not that of MEAN_MOTION, which counts", core::quoted_word(kept.text),
                    fmt::format("{:.6g} km, as {} rev/day need", expected_km, core::format_number(motion_rev_per_day)),
                    "the message may be of two pieces"});
}

bool OmmRecord::read_elements(FileProblems& problems, ElementSet& set) const {
  constexpr double any = 1e30;
  set.object_name = of(OmmKey::object_name).text;
  set.object_id = of(OmmKey::object_id).text;
  double motion = 0.0, inclination = 0.0, node = 0.0, perigee = 0.0, anomaly = 0.0;
  bool good = true;
  if (const Value& epoch = of(OmmKey::epoch); epoch.text.empty()) {
    problems.error(at_, {"EPOCH is missing", "", std::string(radar::civil_time_forms), ""});
    good = false;
  } else if (const auto time = radar::parse_civil(epoch.text).time) {
    set.epoch = *time;
  } else {
    problems.error(epoch.at,
                   {"EPOCH is not a time", core::clipped(epoch.text), std::string(radar::civil_time_forms), ""});
    good = false;
  }
  good &= read(OmmKey::mean_motion, true, 1e-3, 20.0, problems, motion);
  if (good) compare_axis(problems, motion);
  good &= read(OmmKey::eccentricity, true, 0.0, 0.999999999, problems, set.elements.eccentricity);
  good &= read(OmmKey::inclination, true, 0.0, 180.0, problems, inclination);
  good &= read(OmmKey::ra_of_asc_node, true, -360.0, 360.0, problems, node);
  good &= read(OmmKey::arg_of_pericenter, true, -360.0, 360.0, problems, perigee);
  good &= read(OmmKey::mean_anomaly, true, -360.0, 360.0, problems, anomaly);
  good &= read(OmmKey::bstar, true, -any, any, problems, set.elements.drag_per_earth_radius);
  good &= read(OmmKey::mean_motion_dot, false, -any, any, problems, set.mean_motion_dot_rev_per_day2);
  good &= read(OmmKey::mean_motion_ddot, false, -any, any, problems, set.mean_motion_ddot_rev_per_day3);
  good &= read_whole(OmmKey::norad_cat_id, false, problems, set.catalogue_number);
  good &= read_whole(OmmKey::element_set_no, false, problems, set.element_set);
  good &= read_whole(OmmKey::rev_at_epoch, false, problems, set.revolution);
  set.elements.mean_motion_rad_per_s = motion * radps_of_rev_per_day;
  set.elements.inclination_rad = inclination * rad_of_deg;
  set.elements.ascending_node_rad = node * rad_of_deg;
  set.elements.perigee_rad = perigee * rad_of_deg;
  set.elements.mean_anomaly_rad = anomaly * rad_of_deg;
  return good;
}

void finish_elements(const ReaderInput& input, MeanElementsFile& file) {
  if (!input.choice.report(input.problems)) return;
  if (file.sets.empty() && !input.problems.has_errors())
    input.problems.error({}, {"the file holds no elements", "", "at least one set of mean elements", ""});
}

}  // namespace sarsim::scene::ephemeris
