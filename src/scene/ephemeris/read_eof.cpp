#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "radar/earth/instant.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/known_words.hpp"
#include "scene/ephemeris/state_collector.hpp"
#include "scene/ephemeris/xml_scan.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::array<std::string_view, 7> osv_names{"UTC", "X", "Y", "Z", "VX", "VY", "VZ"};

// Reads the state vectors of a Sentinel-1 orbit file. Times are those in UTC, which stand beside TAI and UT1.
class EofReader {
 public:
  explicit EofReader(const ReaderInput& input)
      : problems_(input.problems), text_(input.text), scan_(input.text, input.problems) {}

  EphemerisFile read() {
    while (!collector_.full()) {
      const XmlEvent event = scan_.next();
      if (event == XmlEvent::end) break;
      take(event);
    }
    if (announced_ && *announced_ != read_ && !problems_.has_errors())
      problems_.error({}, {"the number of states is not the one that the list announces", fmt::format("{}", read_),
                           fmt::format("{}", *announced_), "the file may be damaged"});
    if (!frame_seen_ && !problems_.has_errors())
      problems_.warning({}, {"Ref_Frame is missing", "", "<Ref_Frame>EARTH_FIXED</Ref_Frame>",
                             "the positions are taken as fixed to the Earth"});
    collector_.typed_times(said_);
    collector_.finish(text_.substr(0, 0));
    return std::move(file_);
  }

 private:
  void take(XmlEvent event) {
    const std::string_view name = scan_.name();
    if (name == "OSV" && event == XmlEvent::open) return begin_state();
    if (name == "OSV" && event == XmlEvent::close) return end_state();
    if (event == XmlEvent::open) {
      if (name == "List_of_OSVs") take_count(scan_.attribute("count"));
      if (in_state_) check_unit(name);
    }
    if (event != XmlEvent::text) return;
    if (in_state_)
      take_field(name, scan_.text());
    else
      take_header(name, scan_.text());
  }

  void take_count(std::string_view text) {
    const auto count = core::parse_integer(text);
    if (count && *count >= 0) announced_ = static_cast<std::size_t>(*count);
  }

  // Of "UTC=2024-04-01T22:59:42".
  static std::string_view without_scale(std::string_view text, std::string_view scale) {
    if (text.starts_with(scale)) text.remove_prefix(scale.size());
    return text;
  }

  TypedTime parsed_time(std::string_view name, std::string_view text) {
    TypedTime said{name, std::nullopt, text};
    radar::CivilTime time;
    if (read_time(without_scale(text, "UTC="), name, radar::TimeScale::utc, problems_, time)) said.time = time;
    return said;
  }

  void take_header(std::string_view name, std::string_view text) {
    if (name == "Validity_Start") {
      said_.first = parsed_time(name, text);
    } else if (name == "Validity_Stop") {
      said_.last = parsed_time(name, text);
    } else if (name == "Mission") {
      if (const auto plain = without_entities(text))
        file_.object_name = core::clipped(*plain);
      else
        problems_.error(text, {"the name of the mission has an entity that is not known", core::clipped(text),
                               "&amp;, &lt;, &gt;, &quot;, &apos; or the number of a character", ""});
    } else if (name == "Time_Reference") {
      if (!text.empty() && !core::equal_ignoring_case(text, "UTC"))
        problems_.error(text, {"the times are not in UTC (Time_Reference)", core::quoted_word(text), "UTC",
                               "an orbit file of Sentinel-1 counts in UTC; convert the times, or write an OEM"});
    } else if (name == "Ref_Frame") {
      frame_seen_ = true;
      if (!core::equal_ignoring_case(text, "EARTH_FIXED"))
        problems_.error(text, {"the frame is not known", core::clipped(text), "EARTH_FIXED", ""});
    }
  }

  void begin_state() {
    if (in_state_) problems_.error(scan_.name(), {"an OSV within another one", "", "one behind the other", ""});
    in_state_ = true;
    at_ = scan_.name();
    tai_ = {};
    fields_.fill({});
  }

  void check_unit(std::string_view name) {
    const std::string_view unit = scan_.attribute("unit");
    for (std::size_t i = 1; i < osv_names.size(); ++i)
      if (name == osv_names[i] && !unit.empty() && unit != (i < 4 ? "m" : "m/s"))
        problems_.error(unit, {fmt::format("{} has another unit than it should", name), core::clipped(unit),
                               i < 4 ? "m" : "m/s", ""});
  }

  void take_field(std::string_view name, std::string_view text) {
    if (name == "Quality" && text != "NOMINAL" && !problems_.again(quality_))
      quality_ = problems_.warning(text, {"the quality of a state is not nominal", core::clipped(text), "NOMINAL",
                                          "the orbit may be inaccurate around this time"});
    if (name == "TAI") tai_ = text;
    for (std::size_t i = 0; i < osv_names.size(); ++i) {
      if (name != osv_names[i]) continue;
      if (!fields_[i].empty())
        problems_.error(text, {fmt::format("{} appears twice in one OSV", name), core::clipped(text), "each once", ""});
      fields_[i] = text;
    }
  }

  void end_state() {
    in_state_ = false;
    ++read_;
    EphemerisState state;
    core::Vec3 velocity_mps;
    std::string missing;
    for (std::size_t i = 0; i < osv_names.size(); ++i)
      if (fields_[i].empty()) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", osv_names[i]);
    if (!missing.empty()) {
      problems_.error(at_, {missing + " is missing in an OSV", "", "UTC, X, Y, Z, VX, VY, VZ", ""});
      return;
    }
    const std::string_view time = without_scale(fields_[0], "UTC=");
    bool good = read_time(time, "UTC of an OSV", radar::TimeScale::utc, problems_, state.time);
    const std::array<double*, 6> values{&state.position_m.x, &state.position_m.y, &state.position_m.z,
                                        &velocity_mps.x,     &velocity_mps.y,     &velocity_mps.z};
    for (std::size_t i = 0; i < values.size(); ++i)
      good &= read_number(fields_[i + 1], osv_names[i + 1], i < 3 ? "m" : "m/s", 0, problems_, *values[i]);
    if (!good) return;
    state.velocity_mps = velocity_mps;
    check_tai(state.time);
    collector_.add(state, time, fields_[1]);
  }

  // The same moment by another clock.
  void check_tai(const radar::CivilTime& utc) {
    constexpr double rounding_s = 1e-3;
    const auto tai = radar::parse_instant(without_scale(tai_, "TAI="), radar::TimeScale::tai).instant;
    const auto same = radar::instant_of(utc, radar::TimeScale::utc).instant;
    if (!tai || !same || std::abs(radar::seconds_between(*same, *tai)) <= rounding_s || problems_.again(clocks_))
      return;
    clocks_ = problems_.warning(tai_, {"TAI and UTC of a state are not the same moment", core::clipped(tai_),
                                       "TAI=" + radar::format_instant(*same, radar::TimeScale::tai, 6),
                                       "UTC counts; is the file of one piece?"});
  }

  FileProblems& problems_;
  std::string_view text_;
  EphemerisFile file_;
  StateCollector collector_{file_, problems_, "m"};
  XmlScan scan_;
  std::array<std::string_view, 7> fields_;
  std::string_view at_;
  std::optional<std::size_t> announced_;
  std::size_t read_ = 0;
  bool in_state_ = false;
  bool frame_seen_ = false;
  FileProblems::Mark quality_ = 0;
  FileProblems::Mark clocks_ = 0;
  TypedTimes said_;
  std::string_view tai_;
};

}  // namespace

EphemerisFile read_eof(const ReaderInput& input) { return EofReader(input).read(); }

}  // namespace sarsim::scene::ephemeris
