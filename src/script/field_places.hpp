#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/problem.hpp"

namespace sarsim {

/// Where each field of a scene stands in its script. Twelve bytes for a field, so that scripts of millions of targets
/// can be kept; columns beyond a million are remembered as unknown (0).
class FieldPlaces {
 public:
  /// Notes the place of a field, or of the whole object where `subject.field` is empty; a field noted twice keeps its
  /// first place. Cheapest in the order of the objects.
  void add(const Subject& subject, const Place& place);

  /// The same without building the strings: for readers, which note millions of them.
  void add(std::string_view kind, std::size_t index, std::string_view field, std::string_view file, std::size_t line,
           std::size_t column);

  /// Place of the field; where that is not known, of the part of its name before the first '.' or '[' (a member of a
  /// member), then of its object; else an empty place.
  [[nodiscard]] Place find(const Subject& subject) const;

 private:
  // The name of a field together with the file it was found in.
  using Label = std::pair<std::string, std::string>;
  struct Entry {
    std::uint32_t object;
    std::uint32_t line;
    std::uint32_t column_and_label;
  };
  struct Kind {
    std::string name;
    std::vector<Entry> entries;  // ascending in object
  };

  [[nodiscard]] Kind& kind_of(std::string_view name);
  [[nodiscard]] std::uint32_t label_of(std::string_view field, std::string_view file);
  [[nodiscard]] Place find_exactly(const Kind& kind, std::size_t index, std::string_view field) const;

  std::vector<Kind> kinds_;
  std::vector<Label> labels_;
  std::vector<std::uint32_t> follower_;  // of each label: the label that came next the last time
  std::uint32_t last_label_ = 0;
};

}  // namespace sarsim
