#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// Finds the data of one satellite among those of many, and says which there are where that fails.
class SatelliteChoice {
 public:
  /// @param wanted  a name or an identifier; empty for the only satellite of the file
  explicit SatelliteChoice(std::string_view wanted);

  /// Whether the data of a satellite should be read.
  /// @param name  as the file has it; may be empty
  /// @param id    what tells two satellites of one name apart; may be empty
  [[nodiscard]] bool takes(std::string_view name, std::string_view id);

  /// Whether there are several satellites and none was chosen, so that reading on is of no use.
  [[nodiscard]] bool undecided() const { return wanted_.empty() && keys_.size() > 1; }

  /// Reports several satellites of which none was chosen, a choice that the file does not hold, and a name that several
  /// satellites have.
  /// @returns whether exactly one satellite was taken
  bool report(FileProblems& problems) const;

 private:
  [[nodiscard]] bool is_wanted(std::string_view name, std::string_view id) const;
  void remember(std::string_view name, std::string_view id);
  [[nodiscard]] std::string list() const;

  std::string wanted_;
  std::string last_name_;
  std::string last_id_;
  bool last_taken_ = false;
  bool any_ = false;
  std::string first_taken_;  // its key
  std::size_t taken_ = 0;    // different satellites
  std::unordered_set<std::string> keys_;
  std::vector<std::string> listed_;  // the first of them, for people
  std::vector<std::string> words_;   // names and identifiers, for suggestions
};

}  // namespace sarsim::scene::ephemeris
