#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/state_collector.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

namespace {

// Whole number in some columns; nothing where there is none or it is large.
std::optional<int> small_number(std::string_view cell) {
  const auto number = core::parse_integer(core::trimmed(cell));
  if (!number || *number < 0 || *number > 99'999'999) return std::nullopt;
  return static_cast<int>(*number);
}

// The frames of SP3 are all fixed to the Earth and named in five letters: "IGS20", "ITR08", "WGS84".
bool is_earth_fixed(std::string_view name) {
  constexpr std::array<std::string_view, 5> beginnings{"ITR", "IGS", "IGB", "SLR", "WGS"};
  return std::ranges::any_of(
      beginnings, [&](std::string_view known) { return core::equal_ignoring_case(name.substr(0, 3), known); });
}

// Galileo and QZSS count their seconds as GPS does.
std::optional<radar::TimeScale> sp3_scale(std::string_view name) {
  if (name == "GPS" || name == "GAL" || name == "QZS") return radar::TimeScale::gps;
  if (name == "UTC") return radar::TimeScale::utc;
  if (name == "TAI") return radar::TimeScale::tai;
  return std::nullopt;
}

// Reads an SP3-c or SP3-d file line by line.
class Sp3Reader {
 public:
  explicit Sp3Reader(const ReaderInput& input) : input_(input), problems_(input.problems) {}

  EphemerisFile read() {
    TextLines lines(input_.text);
    std::string_view line;
    bool ended = false;
    if (lines.next(line)) take_first(line);
    while (!ended && going_on() && lines.next(line)) {
      ended = line.starts_with("EOF");
      if (!ended) take(line);
      if (!line.empty()) last_ = line;
    }
    add_pending();
    if (!input_.choice.report(problems_)) return std::move(file_);
    if (!ended && !collector_.full())
      problems_.warning(last_, {"the line EOF is missing at the end", "", "EOF", "the file may be cut off"});
    report_counts();
    collector_.finish(last_);
    return std::move(file_);
  }

 private:
  bool going_on() const { return !collector_.full() && !hopeless_; }

  void take_first(std::string_view line) {
    const char version = core::lower(columns(line, 2, 2).empty() ? ' ' : line[1]);
    if (version != 'c' && version != 'd')
      problems_.error(line, {"this version of SP3 is not read", core::clipped(line.substr(0, 3)), "SP3-c or SP3-d",
                             "older files do not say what time they count"});
    announced_ = small_number(columns(line, 33, 39)).value_or(0);
    const std::string_view frame = core::trimmed(columns(line, 47, 51));
    if (!is_earth_fixed(frame))
      problems_.error(frame, {"the frame is not known", core::clipped(frame),
                              "a frame fixed to the Earth: ITRxx, IGSxx, IGbxx, SLRxx, WGS84", ""});
    file_.frame = Frame::itrf;
    last_ = line;
  }

  void take(std::string_view line) {
    switch (line.empty() ? ' ' : line.front()) {
      case '+': return take_satellites(line);
      case '%': return take_scale(line);
      case '*': return take_epoch(line);
      case 'P': return take_position(line);
      case 'V': return take_velocity(line);
      case ' ':
      case '#':
      case '/':
      case 'E': return;
      default:
        if (!problems_.again(odd_line_))
          odd_line_ = problems_.error(line, {"the line is none of SP3", core::clipped(line),
                                             "a line that begins with #, +, %, /*, *, P, V, E or EOF", ""});
    }
  }

  void take_satellites(std::string_view line) {
    if (line.starts_with("++")) return;
    for (std::size_t column = 10; column + 2 <= line.size() && column < 61; column += 3) {
      const std::string_view id = core::trimmed(columns(line, column, column + 2));
      if (!id.empty() && id != "0") static_cast<void>(input_.choice.takes(id, {}));
    }
  }

  void take_scale(std::string_view line) {
    if (scale_known_ || !line.starts_with("%c")) return;
    scale_known_ = true;
    const std::string_view name = columns(line, 10, 12);
    if (const auto scale = sp3_scale(name))
      file_.scale = *scale;
    else
      problems_.error(name, {"the time system is not known", std::string(name), "one of GPS, UTC, TAI, GAL, QZS",
                             "it stands in columns 10 to 12 of the first line that begins with %c"});
  }

  void take_epoch(std::string_view line) {
    add_pending();
    if (!scale_known_) {
      problems_.error(line,
                      {"the time system is missing before the first epoch", "", "a line that begins with %c", ""});
      hopeless_ = true;
      return;
    }
    hopeless_ = input_.choice.undecided();
    ++epochs_;
    epoch_at_ = line;
    epoch_.reset();
    std::array<std::string_view, 7> cells;
    if (split_words(line, cells) == 7 && cells[0] == "*") epoch_ = read_epoch(cells);
    if (!epoch_)
      problems_.error(line, {"the line is not an epoch", core::clipped(line),
                             "'*', then year, month, day, hour, minute and second", ""});
  }

  static std::optional<radar::CivilTime> read_epoch(const std::array<std::string_view, 7>& cells) {
    const char* const zero = std::min(cells[6].find('.'), cells[6].size()) < 2 ? "0" : "";
    const radar::CivilReading reading = radar::parse_civil(fmt::format(
        "{}-{:0>2}-{:0>2}T{:0>2}:{:0>2}:{}{}", cells[1], cells[2], cells[3], cells[4], cells[5], zero, cells[6]));
    return reading.marked_utc || (reading.time && reading.time->second == 60) ? std::nullopt : reading.time;
  }

  void take_position(std::string_view line) {
    add_pending();
    if (!is_taken(line)) return;
    if (epoch_at_.empty()) {
      problems_.error(line, {"a position stands before the first epoch", core::clipped(line), "a line '*' first", ""});
      hopeless_ = true;
      return;
    }
    EphemerisState state;
    if (!read_three(line, "a position", "km", 3, state.position_m) || !epoch_) return;
    if (state.position_m == core::Vec3{}) {
      ++missing_;
      if (missing_at_.empty()) missing_at_ = line;
      return;
    }
    if (columns(line, 79, 79) == "M" && !problems_.again(manoeuvre_))
      manoeuvre_ = problems_.warning(line, {"the satellite manoeuvres between this state and the one before", "", "",
                                            "do not use the orbit around this time"});
    state.time = *epoch_;
    pending_ = state;
    pending_at_ = line;
  }

  void take_velocity(std::string_view line) {
    if (!is_taken(line)) return;
    core::Vec3 velocity_mps;
    if (!read_three(line, "a velocity", "dm/s", -1, velocity_mps)) return;
    if (pending_ && velocity_mps != core::Vec3{} && columns(line, 2, 4) == columns(pending_at_, 2, 4))
      pending_->velocity_mps = velocity_mps;
  }

  bool is_taken(std::string_view line) const {
    if (line.size() < 46) {
      problems_.error(line, {"the line is too short", core::clipped(line), "three numbers in columns 5 to 46", ""});
      return false;
    }
    return input_.choice.takes(core::trimmed(columns(line, 2, 4)), {});
  }

  bool read_three(std::string_view line, const char* words, const char* unit, int shift, core::Vec3& value) const {
    bool good = true;
    std::size_t column = 5;
    for (double* part : {&value.x, &value.y, &value.z}) {
      good &= read_number(core::trimmed(columns(line, column, column + 13)), words, unit, shift, problems_, *part);
      column += 14;
    }
    return good;
  }

  void add_pending() {
    if (pending_) collector_.add(*pending_, epoch_at_, pending_at_);
    pending_.reset();
  }

  void report_counts() {
    if (announced_ != epochs_ && !collector_.full())
      problems_.warning({}, {"the number of epochs is not the one that the first line gives",
                             fmt::format("{}", epochs_), fmt::format("{}", announced_), "the file may be cut off"});
    if (missing_ > 0)
      problems_.warning(missing_at_,
                        {"epochs without a position are left out", fmt::format("{} of {}", missing_, epochs_), "",
                         "the orbit is interpolated across these gaps"});
  }

  const ReaderInput& input_;
  FileProblems& problems_;
  EphemerisFile file_;
  StateCollector collector_{file_, problems_, "km"};
  std::string_view last_;
  int announced_ = 0;
  int epochs_ = 0;
  int missing_ = 0;
  std::string_view missing_at_;
  bool scale_known_ = false;
  bool hopeless_ = false;
  std::string_view epoch_at_;
  std::optional<radar::CivilTime> epoch_;
  std::optional<EphemerisState> pending_;
  std::string_view pending_at_;
  FileProblems::Mark odd_line_ = 0;
  FileProblems::Mark manoeuvre_ = 0;
};

}  // namespace

EphemerisFile read_sp3(const ReaderInput& input) { return Sp3Reader(input).read(); }

}  // namespace sarsim::scene::ephemeris
