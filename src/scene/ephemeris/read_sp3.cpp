#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/instant.hpp"
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

// The frames of SP3 are all fixed to the Earth and named in five letters: "IGS20", "ITR08", "WGS84", "ECF".
bool is_earth_fixed(std::string_view name) {
  constexpr std::array<std::string_view, 9> beginnings{"ITR", "IGS", "IGB", "SLR", "WGS", "ECF", "ECE", "PZ-", "GTR"};
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
    if (file_.segments.empty() && !problems_.has_errors())
      problems_.error(last_,
                      {missing_ > 0 ? fmt::format("no record of satellite {} has a position", wanted_)
                                    : fmt::format("the file has no records of satellite {}", wanted_),
                       "", "lines that begin with P" + wanted_, "its head names the satellite; is the file cut off?"});
    collector_.typed_times({{"the time of the first line", first_, first_at_}, {}});
    collector_.finish(last_);
    report_counts();
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
                              "a frame fixed to the Earth: ITRxx, IGSxx, IGbxx, SLRxx, WGS84, ECF", ""});
    file_.frame = Frame::itrf;
    last_ = line;
    first_at_ = columns(line, 4, 31);
    std::array<std::string_view, 7> cells;
    if (split_words(first_at_, std::span(cells).subspan(1)) == 6) first_ = read_epoch(cells);
  }

  // "## week second interval day fraction"; the interval is that of the epochs.
  void take_interval(std::string_view line) {
    std::array<std::string_view, 6> cells;
    if (split_words(line, cells) < 4) return;
    interval_s_ = core::parse_number(cells[3]).value_or(0.0);
    interval_at_ = cells[3];
  }

  void take(std::string_view line) {
    switch (line.empty() ? ' ' : line.front()) {
      case '+': return take_satellites(line);
      case '%': return take_scale(line);
      case '*': return take_epoch(line);
      case 'P': return take_position(line);
      case 'V': return take_velocity(line);
      case '#':
        if (line.starts_with("##")) take_interval(line);
        return;
      case ' ':
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
      if (!id.empty() && id != "0" && input_.choice.takes(id, {}) && wanted_.empty()) wanted_ = id;
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

  // Hour 24 and second 60.0, which laser ranging and Swarm files have, are those of the next day and minute; second 60
  // of a leap second stays.
  std::optional<radar::CivilTime> read_epoch(const std::array<std::string_view, 7>& cells) const {
    std::array<int, 6> value{};
    if (cells[1].size() != 4) return std::nullopt;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto number = small_number(cells[i + 1].substr(0, i == 5 ? cells[6].find('.') : std::string_view::npos));
      if (!number) return std::nullopt;
      value[i] = *number;
    }
    const auto& [year, month, day, hour, minute, second] = value;
    const std::optional<double> fraction_s = fraction_of(cells[6]);
    const auto mjd = radar::mjd_of_date(year, month, day);
    const bool midnight = hour == 24 && minute == 0 && second == 0;
    if (!mjd || !fraction_s || (hour > 23 && !midnight) || minute > 59 || second > 60) return std::nullopt;
    if (second == 60 && file_.scale == radar::TimeScale::utc) {
      const radar::CivilTime leap{year, month, day, hour, minute, second, *fraction_s};
      if (radar::instant_of(leap, file_.scale).instant) return leap;
    }
    constexpr int day_s = 86400;
    const int of_day_s = 3600 * hour + 60 * minute + second;
    radar::CivilTime time = radar::date_of_mjd(*mjd + of_day_s / day_s);
    time.hour = of_day_s % day_s / 3600;
    time.minute = of_day_s % 3600 / 60;
    time.second = of_day_s % 60;
    time.fraction_s = *fraction_s;
    return time;
  }

  // The decimals of a second as they are written, not what rounding leaves of a difference.
  static std::optional<double> fraction_of(std::string_view cell) {
    const std::size_t point = cell.find('.');
    const std::string_view digits = point == std::string_view::npos ? std::string_view() : cell.substr(point + 1);
    if (!std::ranges::all_of(digits, core::is_digit)) return std::nullopt;
    return core::parse_number("0." + std::string(digits) + "0");
  }

  void take_position(std::string_view line) {
    add_pending();
    if (!is_taken(line)) return;
    if (epoch_at_.empty()) {
      problems_.error(line, {"a position before the first epoch", core::clipped(line), "a line '*' first", ""});
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
    const double step_s = collector_.usual_step_s();
    constexpr int fewest_epochs = 5;
    if (epochs_ >= fewest_epochs && step_s > 0.0 && interval_s_ > 0.0 && std::abs(step_s / interval_s_ - 1.0) > 0.01)
      problems_.warning(interval_at_, {"the interval of the second line is not that of the epochs",
                                       fmt::format("{:.6g} s", interval_s_), fmt::format("{:.6g} s", step_s),
                                       "the epochs count; were some left out?"});
    if (missing_ > 0)
      problems_.warning(missing_at_,
                        {"epochs without a position are left out", fmt::format("{} of {}", missing_, epochs_), "", ""});
  }

  const ReaderInput& input_;
  FileProblems& problems_;
  EphemerisFile file_;
  StateCollector collector_{file_, problems_, "km"};
  std::string_view last_;
  std::string wanted_;  // of those that the head names
  std::string_view first_at_;
  std::optional<radar::CivilTime> first_;
  std::string_view interval_at_;
  double interval_s_ = 0.0;
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
