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
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

/// Resolves references to platforms or radars and reports what is wrong with them.
class NameCheck {
 public:
  /// @param kind  what the names are of: "platform" or "radar"
  NameCheck(std::string_view kind, std::vector<std::string_view> names);

  /// Reports definitions without a name and repeated ones.
  void check_definitions(Findings& findings) const;
  /// Position of the object that `name` means, or `not_found` after reporting; also where it is the undefined "Earth".
  std::size_t resolve(Findings& findings, std::string_view field, std::string_view name);
  /// One for the same names, for another thread.
  [[nodiscard]] NameCheck beginning_anew() const { return NameCheck(kind_, table_); }

 private:
  NameCheck(std::string kind, std::shared_ptr<const NameTable> table)
      : kind_(std::move(kind)), table_(std::move(table)) {}
  NameTable::Result find(std::string_view name);
  [[nodiscard]] std::vector<std::string_view> candidates() const;
  [[nodiscard]] std::string expected_name() const;
  void report_unknown(Findings& findings, std::string_view field, std::string_view name) const;

  std::string kind_;
  std::shared_ptr<const NameTable> table_;
  std::unordered_map<std::string, NameTable::Result> known_;  // scenes name one platform a million times,
  std::string last_name_;                                     // most often the one named just before
  std::optional<NameTable::Result> last_;
};

}  // namespace sarsim::scene
