#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/check/check_findings.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The names of a scene's platforms or radars, for looking many of them up: agrees with `find_platform` and
/// `find_radar` and says besides how a name was found.
class NameTable {
 public:
  /// How a name was found: as it is, as the beginning of the only one, of several, or not at all.
  enum class Match { exact, prefix, ambiguous, none };

  /// What a name stands for.
  struct Result {
    Match match = Match::none;
    std::size_t index = not_found;  ///< Where exact or prefix.
  };

  /// A table of names, which must outlive it, in the order of their definitions.
  explicit NameTable(std::vector<std::string_view> names);

  /// Looks a name up, without regard to case.
  [[nodiscard]] Result find(std::string_view name) const;
  /// The defined names for which `name` could stand, for messages: "Plane, Planet".
  [[nodiscard]] std::string candidates(std::string_view name) const;
  /// Position of each name that was defined before, with the position of its first definition.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& duplicates() const { return duplicates_; }
  [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::vector<std::string_view> names_;
  std::unordered_map<std::string, std::size_t> first_;  // lower-case name -> its first definition
  std::vector<std::pair<std::size_t, std::size_t>> duplicates_;
};

/// Resolves references to platforms or radars and reports what is wrong with them.
class NameCheck {
 public:
  /// @param kind  what the names are of: "platform" or "radar"
  NameCheck(std::string_view kind, std::vector<std::string_view> names);

  /// Reports definitions without a name and repeated ones.
  void check_definitions(Findings& findings) const;
  /// Position of the object that `name` means, or `not_found` after reporting; also where it is the undefined "Earth".
  std::size_t resolve(Findings& findings, std::string_view field, std::string_view name);
  /// One for the same names, for another thread, ...
  [[nodiscard]] NameCheck beginning_anew() const { return NameCheck(kind_, table_); }
  /// ... and what it has met, behind everything met here.
  void append(const NameCheck& later);

  /// Reports the use of an undefined "Earth", once.
  void report_undefined_earth(Findings& findings) const;

 private:
  NameCheck(std::string kind, std::shared_ptr<const NameTable> table)
      : kind_(std::move(kind)), table_(std::move(table)) {}
  NameTable::Result find(std::string_view name);
  void report_unknown(Findings& findings, std::string_view field, std::string_view name) const;

  std::string kind_;
  std::shared_ptr<const NameTable> table_;
  std::unordered_map<std::string, NameTable::Result> known_;  // scenes name one platform a million times,
  std::string last_name_;                                     // most often the one named just before
  std::optional<NameTable::Result> last_;
  core::Subject first_earth_;
  std::size_t earth_uses_ = 0;
};

}  // namespace sarsim::scene
