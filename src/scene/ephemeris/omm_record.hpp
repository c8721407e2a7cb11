#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/ephemeris/formats.hpp"

namespace sarsim::scene::ephemeris {

/// The keywords of an OMM that are read; others are of no use to SGP4.
enum class OmmKey : std::uint8_t {
  object_name,
  object_id,
  center_name,
  ref_frame,
  time_system,
  mean_element_theory,
  epoch,
  mean_motion,
  semi_major_axis,
  eccentricity,
  inclination,
  ra_of_asc_node,
  arg_of_pericenter,
  mean_anomaly,
  ephemeris_type,
  norad_cat_id,
  element_set_no,
  rev_at_epoch,
  bstar,
  bterm,
  mean_motion_dot,
  mean_motion_ddot,
  none,  ///< No keyword that is read.
};

/// Which keyword a word is: "BSTAR".
[[nodiscard]] OmmKey omm_key_of(std::string_view word);

/// The values of one message, whatever its form.
class OmmRecord {
 public:
  /// Forgets all values; a new message begins at `at`.
  void begin(std::string_view at);
  /// Reports a keyword of a message without a value, unless the keyword is unknown. Cells of tables and members of JSON
  /// JSON may be empty but for those that say what the elements mean, keywords of messages may not.
  void miss_value(OmmKey key, std::string_view at, FileProblems& problems);
  /// Keeps the value of a keyword; reports one that stands twice. An empty value is a missing one; an empty frame,
  /// centre, time system or theory is reported.
  /// @param at    where it stands in the text
  /// @param unit  as given beside it; empty for none
  void set(OmmKey key, std::string value, std::string_view at, std::string_view unit, FileProblems& problems);
  /// Whether anything has been kept since the beginning.
  [[nodiscard]] bool empty() const { return empty_; }
  /// Reads the message, if its satellite is wanted, into the file.
  void finish(const ReaderInput& input, MeanElementsFile& file);

 private:
  struct Value {
    std::string text;
    std::string_view at;
  };
  [[nodiscard]] const Value& of(OmmKey key) const { return values_[static_cast<std::size_t>(key)]; }
  void check_conventions(FileProblems& problems) const;
  bool read(OmmKey key, bool required, double low, double high, FileProblems& problems, double& value) const;
  bool read_whole(OmmKey key, bool required, FileProblems& problems, int& value) const;
  void compare_axis(FileProblems& problems, double motion_rev_per_day) const;
  bool read_elements(FileProblems& problems, ElementSet& set) const;

  std::array<Value, static_cast<std::size_t>(OmmKey::none)> values_;
  std::string_view at_;
  bool empty_ = true;
};

/// Reports a file without any elements and satellites that are not the one; the end of every reader of elements.
void finish_elements(const ReaderInput& input, MeanElementsFile& file);

}  // namespace sarsim::scene::ephemeris
