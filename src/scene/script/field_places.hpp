#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"

namespace sarsim::scene {

/// Where each field of a scene stands in its script. About two bytes for a field, so that scripts of millions of
/// targets can be kept; columns beyond a million are remembered as unknown (0).
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

  /// Memory that the places take.
  [[nodiscard]] std::size_t bytes() const;

  /// Whether both know the same places.
  friend bool operator==(const FieldPlaces& a, const FieldPlaces& b);

 private:
  // The name of a field together with the number of the file it was found in.
  struct Label {
    std::string field;
    std::size_t file = 0;
    friend bool operator==(const Label&, const Label&) = default;
  };
  struct Entry {
    std::uint32_t object = 0;
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t label = 0;
  };
  // Where the bytes of some entries begin, and what the first of them counts from.
  struct Block {
    std::uint32_t object = 0;
    std::uint32_t line = 0;
    std::size_t offset = 0;
  };
  // The entries of all objects of a kind, each as its differences from the one before.
  struct Kind {
    std::string name;
    std::vector<Label> labels;
    std::vector<std::uint32_t> follower;  // of each label: the label that came next the last time
    std::uint32_t last_label = 0;
    std::vector<std::uint8_t> bytes;  // ascending in object
    std::vector<Block> blocks;
    std::size_t in_block = 0;  // entries of the last block
    Entry last;
    std::vector<Entry> strays;  // of objects that came behind later ones

    void add(const Entry& entry);
    // Calls visit(entry) from a block on, for as long as that returns true.
    template <class Visit>
    void visit(std::size_t block, const Visit& visit) const;
    // Takes over entries whose labels have the same numbers here.
    void append(const Kind& later, std::size_t objects_before, double share);
  };

  [[nodiscard]] std::size_t kind_of(std::string_view name);
  [[nodiscard]] std::size_t file_of(std::string_view name);
  [[nodiscard]] static std::uint32_t label_of(Kind& kind, std::string_view field, std::size_t file);
  [[nodiscard]] core::Place find_exactly(const Kind& kind, std::size_t index, std::string_view field) const;
  [[nodiscard]] core::Place place_of(const Kind& kind, const Entry& entry) const;
  [[nodiscard]] bool knows_all_of(const FieldPlaces& other) const;
  void append_kind(const Kind& later, const std::vector<std::string>& files, std::size_t objects_before, double share);

  std::vector<Kind> kinds_;
  std::vector<std::string> files_;
  // The object at hand.
  std::size_t kind_ = 0;
  std::size_t object_ = 0;
  std::size_t file_ = 0;
};

template <class ObjectsBefore>
void FieldPlaces::append(const FieldPlaces& later, const ObjectsBefore& objects_before, double share) {
  for (const std::string& file : later.files_) static_cast<void>(file_of(file));
  for (const Kind& kind : later.kinds_) append_kind(kind, later.files_, objects_before(kind.name), share);
}

}  // namespace sarsim::scene
