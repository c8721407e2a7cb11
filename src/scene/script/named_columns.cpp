#include "scene/script/named_columns.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::scene {

namespace {

// Words between blanks.
constexpr std::string_view time_words = "time t times epoch seconds utc";
constexpr std::string_view angle_words = "angle angles theta phi alpha offset off incidence aspect x";
constexpr std::string_view fraction_words = "fraction part place time t u x";
constexpr std::string_view number_words = "pulse number index count no n i k x";
constexpr std::string_view any_gain_words = "gain g value y";

bool is_of_intervals(const FunctionBlock& block) { return block.list_key == "intervals"; }

// The words for x, and for each of the values.
struct AxisLabels {
  std::string_view x;
  std::array<std::string_view, 3> y;
};

AxisLabels words_of(const FunctionBlock& block) {
  constexpr std::array<std::string_view, 3> places{"x east easting e", "y north northing n",
                                                   "z up u height altitude h alt"};
  constexpr std::array<std::string_view, 3> angles{"x rx roll", "y ry pitch", "z rz yaw heading"};
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  switch (block.role) {
    case FunctionRole::trajectory:
    case FunctionRole::beam_target: return {time_words, places};
    case FunctionRole::rotation: return {time_words, angles};
    case FunctionRole::position_envelope:
    case FunctionRole::rotation_envelope: return {"time lag before delay age t tau", axes};
    case FunctionRole::pulse: return {fraction_words, {"i inphase real re", "q quadrature imaginary imag im"}};
    case FunctionRole::pulse_envelope: return {fraction_words, {"amplitude envelope voltage weight gain a value y"}};
    case FunctionRole::window: return {fraction_words, {"weight window w gain amplitude value y"}};
    case FunctionRole::stc: return {"range distance slant r x", {"gain voltage stc g v value y"}};
    case FunctionRole::reflectivity: return {angle_words, {"reflectivity gain rcs sigma amplitude echo g value y"}};
    case FunctionRole::azimuth_cut:
    case FunctionRole::elevation_cut: return {angle_words, {"azimuth az", "elevation el", {}}};
    case FunctionRole::list:
      return {number_words,
              {is_of_intervals(block) ? "interval intervals pri pris period periods repetition value y"
                                      : "frequency frequencies carrier carriers f fc value y"}};
  }
  return {};
}

// Names of what no column can be that is not called so itself.
constexpr std::array<std::string_view, 6> quantity_words{"time times epoch",        "latitude lat longitude lon lng",
                                                         "velocity speed vx vy vz", "range distance",
                                                         "azimuth elevation angle", "frequency freq"};

// Words by which a column is another quantity than that of its axis, whatever else its name says, and what to do.
struct OtherQuantity {
  std::string_view words;
  const char* hint;
};

constexpr OtherQuantity of_any_axis[] = {
    {"phase phases arg argument", "Functions by points have no phase; a pulse has I and Q."},
    {"velocity speed rate acceleration vx vy vz", "Write the quantity itself, not its rate."},
    {"sin sine cos cosine tan", "Write the angle itself."}};
constexpr OtherQuantity of_decibels[] = {
    {"loss losses attenuation", "A loss is a negative gain in dB: change the signs and name the column gain."},
    {"lin linear", "Write decibels: 10 log10 of a ratio of powers, 20 log10 of a ratio of voltages."}};
constexpr OtherQuantity of_voltages[] = {{"power powers", "Write voltages, the roots of powers."},
                                         {"loss losses attenuation", "Write what remains: 1 over the loss."}};
constexpr OtherQuantity of_pulses[] = {
    {"amplitude amplitudes magnitude mag envelope", "Write I and Q: the amplitude times cosine and sine of the phase."},
    {"power powers", "Write voltages, the roots of powers."}};
constexpr OtherQuantity of_places[] = {{"down d depth", "Change the signs and name the column up."},
                                       {"south", "Change the signs and name the column north."},
                                       {"west", "Change the signs and name the column east."}};
constexpr OtherQuantity of_intervals[] = {
    {"frequency frequencies prf prfs f hz", "Write intervals: 1 over the repetition frequency."}};
constexpr OtherQuantity of_frequencies[] = {
    {"wavelength wavelengths lambda", "Write frequencies: the speed of light over the wavelength."},
    {"interval intervals pri pris prf prfs period repetition", "Write the carrier of each pulse."}};
constexpr OtherQuantity of_incidence[] = {
    {"grazing depression", "Write angles of incidence: 90 deg less the grazing angle."}};

// Those of one axis of a block, beside those of any.
std::span<const OtherQuantity> others_of(const FunctionBlock& block, std::size_t axis) {
  switch (block.role) {
    case FunctionRole::pulse: return axis == 0 ? std::span<const OtherQuantity>() : of_pulses;
    case FunctionRole::pulse_envelope:
    case FunctionRole::window:
    case FunctionRole::stc: return axis == 0 ? std::span<const OtherQuantity>() : of_voltages;
    case FunctionRole::reflectivity:
      return axis == 0 ? std::span<const OtherQuantity>(of_incidence) : std::span<const OtherQuantity>(of_decibels);
    case FunctionRole::azimuth_cut:
    case FunctionRole::elevation_cut: return axis == 0 ? std::span<const OtherQuantity>() : of_decibels;
    case FunctionRole::trajectory:
    case FunctionRole::beam_target: return axis == 0 ? std::span<const OtherQuantity>() : of_places;
    case FunctionRole::list:
      if (axis == 0) return {};
      return is_of_intervals(block) ? std::span<const OtherQuantity>(of_intervals)
                                    : std::span<const OtherQuantity>(of_frequencies);
    default: return {};
  }
}

bool has_word(std::string_view words, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

// The words of a name, as it is written: "gain_az [dB]" has two.
std::vector<std::string> words_in(std::string_view name) {
  std::vector<std::string> words;
  bool within = false;
  for (const char c : name) {
    const char small = core::lower(c);
    const bool part = core::is_digit(c) || (small >= 'a' && small <= 'z') || (static_cast<unsigned char>(c) >= 0x80U);
    if (part && !within) words.emplace_back();
    if (part) words.back() += c;
    within = part;
  }
  return words;
}

bool means(const std::vector<std::string>& name, std::string_view words) {
  return std::ranges::any_of(name, [&](const std::string& word) { return has_word(words, core::lower_case(word)); });
}

// Whether one of the words is in a name that it is no word for.
bool contradicts(const std::vector<std::string>& name, std::string_view words, std::string_view own) {
  return std::ranges::any_of(name, [&](const std::string& word) {
    const std::string small = core::lower_case(word);
    return has_word(words, small) && !has_word(own, small);
  });
}

const FunctionAxis& axis_number(const FunctionBlock& block, std::size_t axis) {
  return axis == 0 ? block.x : block.y[axis - 1];
}

// One table's headings.
class ColumnNames {
 public:
  ColumnNames(const FunctionBlock& block, const std::vector<ColumnHeading>& headings,
              const std::vector<std::size_t>& usual)
      : block_(block), headings_(headings), axes_(usual), words_(words_of(block)) {
    both_cuts_ = block.role == FunctionRole::azimuth_cut && usual.size() == 2;
    two_of_pulse_ = block.role == FunctionRole::pulse && usual.size() == 2;
    result_.places.resize(usual.size());
    std::iota(result_.places.begin(), result_.places.end(), std::size_t{0});
    result_.units.resize(usual.size());
  }

  NamedColumns take() {
    if (headings_.size() == axes_.size()) {
      find_meanings();
      if (two_of_pulse_) choose_pulse();
      check_other_quantities();
      check_strangers();
      order();
    }
    for (std::size_t i = 0; i < std::min(headings_.size(), axes_.size()); ++i) read_unit(i);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string_view words_for(std::size_t axis) const {
    if (axis == 0) return words_.x;
    return both_cuts_ ? any_gain_words : words_.y[axis - 1];
  }

  // The one axis that a name can mean; nothing where it is none or several.
  [[nodiscard]] std::optional<std::size_t> meaning(std::string_view written) const {
    const std::vector<std::string> name = words_in(written);
    std::optional<std::size_t> found;
    for (std::size_t axis = 0; axis <= block_.count; ++axis) {
      if (both_cuts_ && axis == 2) break;
      if (!means(name, words_for(axis))) continue;
      if (found) return std::nullopt;
      found = axis;
    }
    return found;
  }

  void find_meanings() {
    for (const ColumnHeading& heading : headings_) meanings_.push_back(meaning(heading.written));
  }

  // Two columns of a pulse are I and Q, or x and I.
  void choose_pulse() {
    const auto named = [&](std::size_t axis) { return std::ranges::count(meanings_, std::optional(axis)) > 0; };
    if (named(0) || meanings_[1] == std::optional<std::size_t>(1)) result_.pulse_has_x = !named(2);
    if (named(2)) result_.pulse_has_x = named(0);
    if (named(0) && named(2))
      return refuse(1, "a pulse of two columns has no I", "fraction of the pulse width and I, or I and Q");
    if (result_.pulse_has_x && *result_.pulse_has_x) axes_ = {0, 1};
    if (result_.pulse_has_x && !*result_.pulse_has_x) axes_ = {1, 2};
  }

  // Names such as "gain_lin", which mean an axis and say that the numbers are not those of it.
  void check_other_quantities() {
    for (std::size_t i = 0; i < meanings_.size(); ++i) {
      const std::size_t axis = meanings_[i].value_or(axes_[i]);
      const std::vector<std::string> name = words_in(headings_[i].written);
      for (const std::span<const OtherQuantity> others :
           {others_of(block_, axis), std::span<const OtherQuantity>(of_any_axis)})
        for (const OtherQuantity& other : others)
          if (contradicts(name, other.words, words_for(axis))) refuse_name(i, axis_name(axis), other.hint);
    }
  }

  // Names that mean something that the column cannot be.
  void check_strangers() {
    for (std::size_t i = 0; i < meanings_.size(); ++i) {
      if (meanings_[i]) continue;
      const std::vector<std::string> name = words_in(headings_[i].written);
      const bool several = means(name, words_for(axes_[i]));
      const bool other =
          std::ranges::any_of(quantity_words, [&](std::string_view words) { return means(name, words); });
      if (several || !other) continue;
      refuse_name(i, name_at(i),
                  both_cuts_
                      ? "An antenna of two columns has one gain for both cuts: name it gain, or add the other cut."
                      : "Name the columns after what they are; the order is theirs then.");
    }
  }

  void order() {
    if (result_.fault) return;
    const auto known = std::ranges::count_if(meanings_, [](const auto& axis) { return axis.has_value(); });
    const bool all = static_cast<std::size_t>(known) == meanings_.size();
    for (std::size_t i = 0; i < meanings_.size(); ++i) {
      if (!meanings_[i]) continue;
      const auto at = std::ranges::find(axes_, *meanings_[i]);
      if (at == axes_.end()) return refuse(i, fmt::format("column {} does not belong here", i + 1), listed());
      if (std::ranges::find(meanings_.begin(), meanings_.begin() + static_cast<std::ptrdiff_t>(i), meanings_[i]) !=
          meanings_.begin() + static_cast<std::ptrdiff_t>(i))
        return refuse(i, fmt::format("two columns are named {}", axis_number(block_, *meanings_[i]).name),
                      "each name once");
      const auto place = static_cast<std::size_t>(at - axes_.begin());
      if (!all && place != i)
        return refuse(i, fmt::format("column {} is another one by its name, and the others cannot be told", i + 1),
                      listed(), "Name all columns.");
      result_.places[i] = place;
    }
  }

  // "t_ms" counts in ms as "t [ms]" does.
  void read_unit(std::size_t i) {
    const ColumnHeading& heading = headings_[i];
    result_.units[i] = heading.unit;
    const std::vector<std::string> name = words_in(heading.written);
    const Quantity quantity = quantity_of(axis_number(block_, axes_[result_.places[i]]));
    if (name.size() < 2) return;
    const bool has_units = quantity != Quantity::number;
    const auto behind = has_units ? read_quantity("1 " + name.back(), quantity).value : std::nullopt;
    if (!behind) return check_other_unit(i, name.back());
    if (heading.unit.empty()) result_.units[i] = name.back();
    const auto brackets = read_quantity("1 " + result_.units[i], quantity).value;
    if (brackets && *brackets != *behind)
      refuse(i, fmt::format("name and unit of column {} contradict each other", i + 1), "one unit",
             "Leave one of them out.");
  }

  // "rcs_dBsm" is no ratio in dB, and "weight_dB" no weight.
  void check_other_unit(std::size_t i, const std::string& word) {
    const std::size_t axis = axes_[result_.places[i]];
    if (has_word(words_for(axis), core::lower_case(word)) || find_unit(word, word).unit == nullptr) return;
    const std::string units = units_listed(quantity_of(axis_number(block_, axis)));
    refuse(i, fmt::format("the unit behind the name of column {} is not that of {}", i + 1, axis_name(axis)),
           units.empty() ? "a number without a unit" : units, "Convert the numbers, or correct the name.");
  }

  [[nodiscard]] std::string_view axis_name(std::size_t axis) const {
    return both_cuts_ && axis == 1 ? std::string_view("the gain of both cuts") : axis_number(block_, axis).name;
  }
  [[nodiscard]] std::string_view name_at(std::size_t i) const { return axis_name(axes_[i]); }

  [[nodiscard]] std::string listed() const {
    std::string text;
    for (std::size_t i = 0; i < axes_.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : ", ", name_at(i));
    return text;
  }

  void refuse_name(std::size_t column, std::string_view axis, const char* hint) {
    refuse(column, fmt::format("the name of column {} is not that of {}", column + 1, axis), std::string(axis), hint);
  }
  void refuse(std::size_t column, std::string message, std::string expected, std::string hint = {}) {
    if (result_.fault) return;
    const ColumnHeading& heading = headings_[column];
    std::string found = core::quoted_word(heading.written);
    if (!heading.unit.empty()) found += fmt::format(" [{}]", core::quoted_word(heading.unit));
    result_.fault = {std::move(message), std::move(found), std::move(expected), std::move(hint)};
  }

  const FunctionBlock& block_;
  const std::vector<ColumnHeading>& headings_;
  std::vector<std::size_t> axes_;
  AxisLabels words_;
  bool both_cuts_ = false;
  bool two_of_pulse_ = false;
  std::vector<std::optional<std::size_t>> meanings_;
  NamedColumns result_;
};

}  // namespace

Quantity quantity_of(const FunctionAxis& axis) {
  static constexpr std::array<std::pair<std::string_view, Quantity>, 6> known{{{"s", Quantity::time},
                                                                               {"m", Quantity::length},
                                                                               {"deg", Quantity::angle},
                                                                               {"dB", Quantity::ratio_db},
                                                                               {"GHz", Quantity::frequency},
                                                                               {"V", Quantity::voltage}}};
  const auto found = std::ranges::find(known, axis.unit, &std::pair<std::string_view, Quantity>::first);
  return found == known.end() ? Quantity::number : found->second;
}

std::vector<std::size_t> usual_columns(const FunctionBlock& block, std::size_t columns) {
  const bool has_x = columns == block.count + 1 || (block.role == FunctionRole::azimuth_cut && columns == 2);
  std::vector<std::size_t> usual(columns);
  for (std::size_t i = 0; i < columns; ++i) usual[i] = std::min(has_x ? i : i + 1, block.count);
  return usual;
}

NamedColumns named_columns(const FunctionBlock& block, const std::vector<ColumnHeading>& headings,
                           const std::vector<std::size_t>& usual) {
  return ColumnNames(block, headings, usual).take();
}

}  // namespace sarsim::scene
