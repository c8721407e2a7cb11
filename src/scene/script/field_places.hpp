#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"

namespace sarsim::scene {

/// Where each field of a scene stands in its script. Twelve bytes for a field, so that scripts of millions of targets
/// can be kept; columns beyond a million are remembered as unknown (0).
class FieldPlaces {
 public:
  /// Notes the place of a field, or of the whole object where `subject.field` is empty; a field noted twice keeps its
  /// first place. Cheapest in the order of the objects.
  void add(const core::Subject& subject, const core::Place& place);

  /// The same in two steps, for readers, which note millions of fields: what the fields that follow belong to ...
  void begin_object(std::string_view kind, std::size_t index, std::string_view file);
  /// ... and one of them.
  void add_field(std::string_view field, std::size_t line, std::size_t column);

  /// Takes over what was noted of objects that come behind all of these.
  /// @param objects_before  (kind) -> number of objects of that kind that come before the first of `later`
  /// @param share           estimate of the part of all places that will have been noted then, above 0 to 1
  template <class ObjectsBefore>
  void append(const FieldPlaces& later, const ObjectsBefore& objects_before, double share = 1.0);

  /// Place of the field; where that is not known, of the part of its name before the first '.' or '[' (a member of a
  /// member), then of its object; else an empty place.
  [[nodiscard]] core::Place find(const core::Subject& subject) const;

  /// Whether both know the same places.
  friend bool operator==(const FieldPlaces& a, const FieldPlaces& b) {
    return a.kinds_ == b.kinds_ && a.labels_ == b.labels_ && a.files_ == b.files_;
  }

 private:
  // The name of a field together with the number of the file it was found in.
  struct Label {
    std::string field;
    std::size_t file = 0;
    friend bool operator==(const Label&, const Label&) = default;
  };
  struct Entry {
    std::uint32_t object;
    std::uint32_t line;
    std::uint32_t column_and_label;
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  struct Kind {
    std::string name;
    std::vector<Entry> entries;  // ascending in object
    friend bool operator==(const Kind&, const Kind&) = default;
  };

  [[nodiscard]] std::size_t kind_of(std::string_view name);
  [[nodiscard]] std::size_t file_of(std::string_view name);
  [[nodiscard]] std::uint32_t label_of(std::string_view field, std::size_t file);
  [[nodiscard]] core::Place find_exactly(const Kind& kind, std::size_t index, std::string_view field) const;
  [[nodiscard]] std::vector<std::uint32_t> labels_for(const FieldPlaces& later);
  void append_entries(const Kind& later, std::size_t objects_before, std::span<const std::uint32_t> labels,
                      double share);

  std::vector<Kind> kinds_;
  std::vector<Label> labels_;
  std::vector<std::string> files_;
  std::vector<std::uint32_t> follower_;  // of each label: the label that came next the last time
  std::uint32_t last_label_ = 0;
  // The object at hand.
  std::size_t kind_ = 0;
  std::size_t object_ = 0;
  std::size_t file_ = 0;
};

template <class ObjectsBefore>
void FieldPlaces::append(const FieldPlaces& later, const ObjectsBefore& objects_before, double share) {
  const std::vector<std::uint32_t> labels = labels_for(later);
  for (const Kind& kind : later.kinds_) append_entries(kind, objects_before(kind.name), labels, share);
}

}  // namespace sarsim::scene
