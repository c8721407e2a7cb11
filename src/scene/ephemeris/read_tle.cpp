#include <algorithm>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/omm_record.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::size_t tle_length = 69;
constexpr std::size_t max_tle_sets = 1'000'000;

// Names are shorter than this, so that a satellite may be called "1 X".
bool is_element_line(std::string_view line, char number) {
  constexpr std::size_t shortest = 40;
  return line.size() > shortest && line[0] == number && line[1] == ' ';
}

bool all_digits(std::string_view text) { return !text.empty() && std::ranges::all_of(text, core::is_digit); }

// A catalogue number of five columns; from 100000 on its first digit is a letter without I and O ("alpha-5").
std::optional<int> catalogue_number(std::string_view cell) {
  constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  cell = core::trimmed(cell);
  if (cell.empty()) return std::nullopt;
  int number = 0;
  if (const std::size_t letter = letters.find(cell.front()); letter != std::string_view::npos && cell.size() == 5) {
    number = static_cast<int>(letter) + 10;
    cell.remove_prefix(1);
  }
  if (!all_digits(cell)) return std::nullopt;
  for (const char c : cell) number = 10 * number + (c - '0');
  return number;
}

int checksum_of(std::string_view line) {
  int sum = 0;
  for (const char c : line.substr(0, tle_length - 1)) sum += core::is_digit(c) ? c - '0' : c == '-' ? 1 : 0;
  return sum % 10;
}

// " 28098-4" is 0.28098e-4.
std::optional<double> assumed_point(std::string_view cell) {
  if (cell.size() != 8) return std::nullopt;
  const std::string_view digits = cell.substr(1, 5);
  const char sign = cell[0];
  const char exponent_sign = cell[6];
  if (core::trimmed(cell).empty()) return 0.0;
  if ((sign != ' ' && sign != '+' && sign != '-') || !all_digits(digits) || !core::is_digit(cell[7]))
    return std::nullopt;
  if (exponent_sign != '-' && exponent_sign != '+' && exponent_sign != ' ') return std::nullopt;
  const int exponent = exponent_sign == '-' ? '0' - cell[7] : cell[7] - '0';
  const std::optional<double> value = core::parse_number(digits, exponent - 5);
  return value && sign == '-' ? -*value : value;
}

// "00179.78495062": two digits of the year, the day of the year and its decimals, of which eight count.
std::optional<radar::CivilTime> tle_epoch(std::string_view cell) {
  constexpr std::size_t decimals = 8;
  constexpr std::int64_t us_of_last_decimal = 864;  // 1e-8 day
  if (cell.size() != 14 || cell[5] != '.') return std::nullopt;
  const auto year = core::parse_integer(core::trimmed(cell.substr(0, 2)));
  const auto day = core::parse_integer(core::trimmed(cell.substr(2, 3)));
  const std::string_view fraction = core::trimmed(cell.substr(6));
  if (!year || *year < 0 || !day || !all_digits(fraction)) return std::nullopt;
  std::optional<radar::CivilTime> time =
      radar::date_of_year_day(static_cast<int>(*year < 57 ? 2000 + *year : 1900 + *year), static_cast<int>(*day));
  if (!time) return std::nullopt;
  std::int64_t count = 0;
  for (std::size_t i = 0; i < decimals; ++i) count = 10 * count + (i < fraction.size() ? fraction[i] - '0' : 0);
  const std::int64_t us = count * us_of_last_decimal;
  time->hour = static_cast<int>(us / 3'600'000'000);
  time->minute = static_cast<int>(us / 60'000'000 % 60);
  time->second = static_cast<int>(us / 1'000'000 % 60);
  time->fraction_s = static_cast<double>(us % 1'000'000) / 1e6;
  return time;
}

// "98067A  " is 1998-067A.
std::string designator(std::string_view cell) {
  cell = core::trimmed(cell);
  if (cell.size() < 6 || !all_digits(cell.substr(0, 5))) return std::string(cell);
  return fmt::format("{}{}-{}", cell.substr(0, 2) < "57" ? "20" : "19", cell.substr(0, 2), cell.substr(2));
}

// Reads the columns of the two lines of one set.
class TleSet {
 public:
  TleSet(std::string_view first, std::string_view second, FileProblems& problems)
      : first_(first), second_(second), problems_(problems) {}

  // False, reported, where the lines are no elements.
  bool read(ElementSet& set) {
    if (!check_line(first_) || !check_line(second_)) return false;
    read_first(set);
    read_second(set);
    return good_;
  }

 private:
  bool check_line(std::string_view line) {
    if (line.size() < tle_length) {
      problems_.error(line, {"the line is too short", fmt::format("{} characters", line.size()),
                             fmt::format("{}, the last of which is the checksum", tle_length), ""});
      return false;
    }
    const std::string_view last = columns(line, tle_length, tle_length);
    const int sum = checksum_of(line);
    if (last.front() == '0' + sum) return true;
    problems_.error(last, {"the checksum of the line is wrong", std::string(last), fmt::format("{}", sum),
                           "the line was changed or damaged; get it again"});
    return false;
  }

  void fail(std::string_view cell, std::string_view words, std::string expected) {
    problems_.error(cell,
                    {fmt::format("{} is not what it should be", words), std::string(cell), std::move(expected), ""});
    good_ = false;
  }

  double number(std::string_view line, std::size_t from, std::size_t to, std::string_view words, double low,
                double high) {
    const std::string_view cell = columns(line, from, to);
    const auto value = core::parse_number(core::trimmed(cell));
    if (value && *value >= low && *value <= high) return *value;
    fail(cell, words, fmt::format("a number from {:g} to {:g} in columns {} to {}", low, high, from, to));
    return 0.0;
  }

  int whole(std::string_view line, std::size_t from, std::size_t to, std::string_view words) {
    const std::string_view cell = core::trimmed(columns(line, from, to));
    if (cell.empty()) return 0;
    const auto value = core::parse_integer(cell);
    if (value && *value >= 0) return static_cast<int>(*value);
    fail(columns(line, from, to), words, fmt::format("a whole number in columns {} to {}", from, to));
    return 0;
  }

  double with_assumed_point(std::size_t from, std::string_view words) {
    const std::string_view cell = columns(first_, from, from + 7);
    const auto value = assumed_point(cell);
    if (!value)
      fail(cell, words, fmt::format("digits and an exponent like 12345-4 in columns {} to {}", from, from + 7));
    return value.value_or(0.0);
  }

  void read_first(ElementSet& set) {
    if (const auto id = catalogue_number(columns(first_, 3, 7)))
      set.catalogue_number = *id;
    else
      fail(columns(first_, 3, 7), "the catalogue number", "5 digits, or a letter and 4 digits");
    set.object_id = designator(columns(first_, 10, 17));
    if (const auto epoch = tle_epoch(columns(first_, 19, 32)))
      set.epoch = *epoch;
    else if (core::parse_integer(core::trimmed(columns(first_, 21, 23))) == 0)
      fail(columns(first_, 19, 32), "the epoch",
           "a day from 001 to 366: days count from 1, noon of January 1 is 001.5");
    else
      fail(columns(first_, 19, 32), "the epoch", "year and day of the year, YYDDD.DDDDDDDD");
    set.mean_motion_dot_rev_per_day2 = number(first_, 34, 43, "the first derivative of the mean motion", -1.0, 1.0);
    set.mean_motion_ddot_rev_per_day3 = with_assumed_point(45, "the second derivative of the mean motion");
    set.elements.drag_per_earth_radius = with_assumed_point(54, "B*");
    const std::string_view type = columns(first_, 63, 63);
    if (type != "0" && type != " " && type != "2" && type != "3")
      fail(type, "the type of the elements", "0, which is SGP4; elements of SGP4-XP (4) and others are not read");
    set.element_set = whole(first_, 65, 68, "the number of the element set");
  }

  void read_second(ElementSet& set) {
    constexpr double rad_of_degree = std::numbers::pi / 180.0;
    constexpr double radps = 2.0 * std::numbers::pi / 86400.0;
    set.elements.inclination_rad = rad_of_degree * number(second_, 9, 16, "the inclination", 0.0, 180.0);
    set.elements.ascending_node_rad = rad_of_degree * number(second_, 18, 25, "the ascending node", 0.0, 360.0);
    const std::string_view eccentricity = columns(second_, 27, 33);
    if (all_digits(eccentricity))
      set.elements.eccentricity = core::parse_number(eccentricity, -7).value_or(0.0);
    else
      fail(eccentricity, "the eccentricity", "7 digits, the decimals, in columns 27 to 33");
    set.elements.perigee_rad = rad_of_degree * number(second_, 35, 42, "the argument of the perigee", 0.0, 360.0);
    set.elements.mean_anomaly_rad = rad_of_degree * number(second_, 44, 51, "the mean anomaly", 0.0, 360.0);
    set.elements.mean_motion_rad_per_s = radps * number(second_, 53, 63, "the mean motion", 1e-3, 20.0);
    set.revolution = whole(second_, 64, 68, "the number of the revolution");
  }

  std::string_view first_;
  std::string_view second_;
  FileProblems& problems_;
  bool good_ = true;
};

// Reads the sets of a file line by line.
class TleReader {
 public:
  explicit TleReader(const ReaderInput& input) : input_(input), problems_(input.problems) {}

  MeanElementsFile read() {
    TextLines lines(input_.text);
    std::string_view line;
    while (!problems_.full() && file_.sets.size() < max_tle_sets && lines.next(line)) {
      while (!line.empty() && core::is_blank(line.back())) line.remove_suffix(1);
      if (!line.empty() && line.front() != '#') take(line);
    }
    if (!first_.empty()) miss_second(first_);
    finish_elements(input_, file_);
    return std::move(file_);
  }

 private:
  void take(std::string_view line) {
    if (!first_.empty()) return take_second(line);
    if (is_element_line(line, '1')) {
      first_ = line;
    } else if (is_element_line(line, '2')) {
      problems_.error(line, {"a second line without a first one", core::clipped(line), "a line 1 above it", ""});
    } else {
      expect_one_name(line);
      name_ = core::trimmed(line.starts_with("0 ") ? line.substr(2) : line);
    }
  }

  // A name stands alone above its two lines; what comes before it is something else.
  void expect_one_name(std::string_view line) {
    if (!name_.empty() && !problems_.again(prose_))
      prose_ = problems_.error(name_, {"the file has the lines of two-line elements, but this one is none of them",
                                       core::clipped(name_), "a name, or a line that begins with 1 or 2",
                                       fmt::format("remove the text above '{}'", core::clipped(line))});
  }

  void miss_second(std::string_view at) {
    problems_.error(at, {"the second line of a set is missing", core::clipped(at), "a line 2 below line 1", ""});
    first_ = {};
    name_ = {};
  }

  void take_second(std::string_view line) {
    if (!is_element_line(line, '2')) {
      miss_second(line);
      return take(line);
    }
    const std::string_view id = core::trimmed(columns(first_, 3, 7));
    const auto number = catalogue_number(id);
    const std::string key = number ? fmt::format("{}", *number) : std::string(id);
    if (input_.choice.takes(name_, key)) take_set(line);
    first_ = {};
    name_ = {};
  }

  void take_set(std::string_view second) {
    if (columns(first_, 3, 7) != columns(second, 3, 7)) {
      problems_.error(columns(second, 3, 7),
                      {"the two lines belong to different satellites", std::string(columns(second, 3, 7)),
                       std::string(columns(first_, 3, 7)), ""});
      return;
    }
    if ((first_.size() > tle_length || second.size() > tle_length) && !problems_.again(long_line_))
      long_line_ = problems_.warning(first_.size() > tle_length ? first_ : second,
                                     {"text after column 69 is ignored", "", "", ""});
    ElementSet set;
    set.object_name = name_;
    if (TleSet(first_, second, problems_).read(set)) file_.sets.push_back(std::move(set));
  }

  const ReaderInput& input_;
  FileProblems& problems_;
  MeanElementsFile file_;
  std::string_view name_;
  std::string_view first_;  // a first line that waits for its second
  FileProblems::Mark long_line_ = 0;
  FileProblems::Mark prose_ = 0;
};

}  // namespace

MeanElementsFile read_tle(const ReaderInput& input) { return TleReader(input).read(); }

}  // namespace sarsim::scene::ephemeris
