#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/known_words.hpp"
#include "scene/ephemeris/kvn_lines.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"
#include "scene/ephemeris/state_collector.hpp"

namespace sarsim::scene {

core::Mat3 turned_from_first(const Quaternion& q) {
  const double s = q.w * q.w - q.x * q.x - q.y * q.y - q.z * q.z;
  return {{core::Vec3{s + 2.0 * q.x * q.x, 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)},
           core::Vec3{2.0 * (q.x * q.y - q.w * q.z), s + 2.0 * q.y * q.y, 2.0 * (q.y * q.z + q.w * q.x)},
           core::Vec3{2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x), s + 2.0 * q.z * q.z}}};
}

namespace ephemeris {

namespace {

constexpr std::array<std::string_view, 19> aem_keys{"OBJECT_NAME",
                                                    "OBJECT_ID",
                                                    "CENTER_NAME",
                                                    "REF_FRAME_A",
                                                    "REF_FRAME_B",
                                                    "ATTITUDE_DIR",
                                                    "TIME_SYSTEM",
                                                    "START_TIME",
                                                    "STOP_TIME",
                                                    "USEABLE_START_TIME",
                                                    "ATTITUDE_TYPE",
                                                    "USEABLE_STOP_TIME",
                                                    "QUATERNION_TYPE",
                                                    "EULER_ROT_SEQ",
                                                    "RATE_FRAME",
                                                    "ANGVEL_FRAME",
                                                    "INTERPOLATION_METHOD",
                                                    "INTERPOLATION_DEGREE",
                                                    "INTERPOLATION"};
constexpr std::array<std::string_view, 4> aem_header_keys{"CREATION_DATE", "ORIGINATOR", "MESSAGE_ID",
                                                          "CLASSIFICATION"};

// A type of attitude whose lines begin with a quaternion.
struct QuaternionType {
  std::string_view name;
  std::size_t numbers;  // on a line, behind the time
};
constexpr std::array<QuaternionType, 4> quaternion_types{
    {{"QUATERNION", 4}, {"QUATERNION/DERIVATIVE", 8}, {"QUATERNION/RATE", 7}, {"QUATERNION/ANGVEL", 7}}};

// Axes of the satellite itself; those of its instruments and wheels are somewhere on it, nobody knows how.
bool is_body(std::string_view frame) {
  return core::equal_ignoring_case(frame.substr(0, 7), "SC_BODY") || core::equal_ignoring_case(frame, "SPACECRAFT");
}

// Reads a CCSDS 504.0 attitude ephemeris message line by line.
class AemReader {
 public:
  explicit AemReader(const ReaderInput& input) : input_(input), problems_(input.problems) {}

  AttitudeFile read() {
    KvnLines lines(input_.text);
    KvnLine line;
    while (going_on() && lines.next(line)) {
      take(line);
      last_ = line.line;
    }
    if ((part_ == Part::metadata || part_ == Part::states) && going_on())
      problems_.error(last_, {"the file ends within a block", core::clipped(last_),
                              part_ == Part::metadata ? "META_STOP" : "DATA_STOP", "the file may be cut off"});
    if (input_.choice.report(problems_)) finish();
    return std::move(file_);
  }

 private:
  enum class Part { version, header, metadata, between, states };

  bool going_on() const { return !problems_.full() && states_ <= max_ephemeris_states; }

  void take(const KvnLine& line) {
    switch (part_) {
      case Part::version:
        version_ = read_version(line, 2, problems_);
        part_ = Part::header;
        return header_.begin(line.line);
      case Part::header:
        if (line.line == "META_START") return begin_metadata(line);
        return header_.add(line, line.key.empty(), problems_);
      case Part::metadata:
        if (line.line == "META_STOP") return end_metadata();
        if (misses_stop(line, problems_)) {
          end_metadata();
          return take_between(line);
        }
        return metadata_.add(line, true, problems_);
      case Part::between: return take_between(line);
      case Part::states:
        if (line.line == "DATA_STOP")
          part_ = Part::between;
        else
          take_state(line);
    }
  }

  void take_between(const KvnLine& line) {
    if (line.line == "META_START") return begin_metadata(line);
    if (line.line == "DATA_START")
      part_ = Part::states;
    else
      problems_.error(line.line,
                      {"the line is outside all blocks", core::clipped(line.line), "META_START or DATA_START", ""});
  }

  void begin_metadata(const KvnLine& line) {
    part_ = Part::metadata;
    metadata_.begin(line.line);
  }

  void end_metadata() {
    part_ = Part::between;
    const std::string_view name = metadata_.required("OBJECT_NAME", problems_);
    taken_ = input_.choice.takes(name, metadata_.value("OBJECT_ID"));
    if (!taken_) return;
    if (file_.object_name.empty()) file_.object_name = name;
    check_centre(metadata_.value("CENTER_NAME"), problems_);
    begins_.push_back(metadata_.at());
    file_.segments.emplace_back();
    read_type();
    read_frames();
    said_.push_back(read_typed_times(metadata_, file_.scale, problems_));
    file_.segments.back().usable = read_usable(metadata_, file_.scale, problems_);
    const bool old_key = metadata_.value("INTERPOLATION_METHOD").empty();
    file_.segments.back().interpolation =
        read_interpolation_hint(metadata_, old_key ? "INTERPOLATION" : "INTERPOLATION_METHOD", problems_);
  }

  void read_type() {
    numbers_ = 0;
    const std::string_view type = metadata_.required("ATTITUDE_TYPE", problems_);
    for (const QuaternionType& known : quaternion_types)
      if (core::equal_ignoring_case(type, known.name)) numbers_ = known.numbers;
    if (numbers_ == 0 && !type.empty())
      problems_.error(type, {"this type of attitude is not read", core::clipped(type),
                             "QUATERNION, QUATERNION/DERIVATIVE, QUATERNION/RATE or QUATERNION/ANGVEL",
                             "convert the file to quaternions with the tool that made it"});
    scalar_first_ = one_of("QUATERNION_TYPE", "FIRST", "LAST").value_or(false);
    b_from_a_ = one_of("ATTITUDE_DIR", "A2B", "B2A").value_or(true);
    // Version 2 has neither keyword: the scalar is last, and A is turned into B.
    if (version_ == 2 && (scalar_first_ || !b_from_a_))
      problems_.error(metadata_.at(), {"version 2 of the message fixes the order and the direction of quaternions",
                                       scalar_first_ ? "QUATERNION_TYPE = FIRST" : "ATTITUDE_DIR = B2A",
                                       "the scalar last, from A to B; or version 1.0", "convert the file"});
  }

  // Whether a keyword has the first of its two values; version 1 must have it.
  std::optional<bool> one_of(const char* key, const char* first, const char* second) {
    const std::string_view value = version_ == 2 ? metadata_.value(key) : metadata_.required(key, problems_);
    if (core::equal_ignoring_case(value, first)) return true;
    if (core::equal_ignoring_case(value, second)) return false;
    if (!value.empty())
      problems_.error(value, {fmt::format("{} is not known", key), core::clipped(value),
                              fmt::format("{} or {}", first, second), ""});
    return std::nullopt;
  }

  void read_frames() {
    const std::string_view a = metadata_.required("REF_FRAME_A", problems_);
    const std::string_view b = metadata_.required("REF_FRAME_B", problems_);
    const std::string_view scale_at = metadata_.required("TIME_SYSTEM", problems_);
    if (a.empty() || b.empty() || scale_at.empty()) return;
    const std::optional<radar::TimeScale> scale = read_scale(scale_at, problems_);
    if (is_body(a) == is_body(b)) {
      problems_.error(b, {"one of the two frames must be the body of the satellite, and one not",
                          fmt::format("{} and {}", core::clipped(a), core::clipped(b)),
                          "SC_BODY_1 and one of ITRF, TEME, EME2000, GCRF", ""});
      return;
    }
    body_from_reference_ = is_body(b) == b_from_a_;
    const std::optional<Frame> reference = read_frame(is_body(a) ? b : a, problems_);
    if (!reference || !scale) return;
    const std::string_view body = is_body(a) ? a : b;
    const bool same = *reference == file_.reference && *scale == file_.scale && body == file_.body_frame;
    if (axes_known_ && !same)
      problems_.error(
          a, {"the segments have different frames or time systems",
              fmt::format("{}, {}, {}", name_of(*reference), core::clipped(body), name_of(*scale)),
              fmt::format("{}, {}, {}, as before", name_of(file_.reference), file_.body_frame, name_of(file_.scale)),
              "put the segments into separate files"});
    file_.reference = *reference;
    file_.scale = *scale;
    file_.body_frame = body;
    axes_known_ = true;
  }

  void take_state(const KvnLine& line) {
    if (!taken_ || numbers_ == 0) return;
    std::array<std::string_view, 9> cells;
    const std::size_t count = split_words(line.line, cells);
    if (!line.key.empty() || count != numbers_ + 1) {
      if (!problems_.again(odd_line_))
        odd_line_ = problems_.error(line.line, {"the line is not an attitude", core::clipped(line.line),
                                                fmt::format("a time and {} numbers", numbers_), ""});
      return;
    }
    AttitudeState state;
    std::array<double, 4> value{};
    bool good = read_time(cells[0], "the time of an attitude", file_.scale, problems_, state.time);
    for (std::size_t i = 0; i < value.size(); ++i)
      good &= read_number(cells[i + 1], "a part of a quaternion", "", 0, problems_, value[i]);
    if (!good) return;
    const std::size_t vector = scalar_first_ ? 1 : 0;
    const Quaternion q{value[scalar_first_ ? 0 : 3], value[vector], value[vector + 1], value[vector + 2]};
    add(state, q, cells[0], cells[1]);
  }

  void add(AttitudeState& state, Quaternion q, std::string_view time_at, std::string_view at) {
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    if (!(std::abs(length - 1.0) <= largest_error)) {
      if (!problems_.again(odd_length_))
        odd_length_ = problems_.error(at, {"a quaternion does not have the length 1", fmt::format("{:.6g}", length),
                                           fmt::format("1 within {}", largest_error),
                                           "is its type, and the order of its parts, what the file says?"});
      return;
    }
    std::vector<AttitudeState>& states = file_.segments.back().states;
    if (!states.empty() && !(state.time > states.back().time) && !problems_.again(unordered_))
      unordered_ = problems_.error(time_at, {"times must ascend and must not repeat", core::clipped(time_at),
                                             "a time after " + radar::format_civil(states.back().time),
                                             "sort the attitudes by time and give each time once"});
    double scale = 1.0 / length;
    const double turn = body_from_reference_ ? 1.0 : -1.0;
    if (!states.empty()) {
      const Quaternion& p = states.back().body_from_reference;
      if (q.w * p.w + turn * (q.x * p.x + q.y * p.y + q.z * p.z) < 0.0) scale = -scale;
    }
    state.body_from_reference = {scale * q.w, turn * scale * q.x, turn * scale * q.y, turn * scale * q.z};
    states.push_back(state);
    at_.push_back(time_at);
    if (++states_ > max_ephemeris_states)
      problems_.error(time_at, {"the file has too many attitudes", "", fmt::format("at most {}", max_ephemeris_states),
                                "thin them out"});
  }

  void finish() {
    // What follows from other mistakes is not said.
    if (!problems_.has_errors()) check_segments(file_.segments, begins_, problems_);
    const std::string_view* at = at_.data();
    for (std::size_t i = 0; i < file_.segments.size() && !problems_.has_errors(); ++i) {
      if (!file_.segments[i].states.empty()) examine(file_.segments[i].states, said_[i], at);
      at += file_.segments[i].states.size();
    }
    std::erase_if(file_.segments, [](const AttitudeSegment& segment) { return segment.states.empty(); });
    if (file_.segments.empty() && !problems_.has_errors())
      problems_.error(last_, {"the file holds no attitudes", "", "times with quaternions", ""});
  }

  void examine(const std::vector<AttitudeState>& states, const TypedTimes& said, const std::string_view* at) {
    std::vector<double> time_s;
    for (const AttitudeState& state : states) time_s.push_back(radar::seconds_between(states.front().time, state.time));
    const SampleSteps steps = steps_of(time_s);
    const auto time_text = [&](std::size_t i) { return radar::format_civil(states[i].time); };
    report_gaps(steps, "attitude", time_text, at, problems_);
    check_typed_times(said, states.front().time, states.back().time, time_s.size() < 3 ? time_s.back() : steps.usual_s,
                      problems_);
  }

  static constexpr double largest_error = 1e-3;

  const ReaderInput& input_;
  FileProblems& problems_;
  AttitudeFile file_;
  KvnBlock header_{aem_header_keys};
  KvnBlock metadata_{aem_keys};
  std::vector<std::string_view> begins_;  // of the segments
  std::vector<TypedTimes> said_;          // of the segments
  std::vector<std::string_view> at_;      // of the attitudes, all segments
  Part part_ = Part::version;
  int version_ = 0;
  std::string_view last_;
  std::size_t states_ = 0;
  std::size_t numbers_ = 0;
  bool taken_ = false;
  bool axes_known_ = false;
  bool scalar_first_ = false;
  bool b_from_a_ = true;
  bool body_from_reference_ = true;
  FileProblems::Mark odd_line_ = 0;
  FileProblems::Mark odd_length_ = 0;
  FileProblems::Mark unordered_ = 0;
};

}  // namespace

AttitudeFile read_aem(const ReaderInput& input) { return AemReader(input).read(); }

}  // namespace ephemeris

}  // namespace sarsim::scene
