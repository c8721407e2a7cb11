#include "scene/script/field_places.hpp"

#include <algorithm>

#include "scene/script/make_room.hpp"

namespace sarsim::scene {

namespace {

constexpr std::uint32_t label_bits = 12;
constexpr std::uint32_t label_limit = 1U << label_bits;
constexpr std::size_t column_limit = std::size_t{1} << (32 - label_bits);

}  // namespace

std::size_t FieldPlaces::kind_of(std::string_view name) {
  if (kind_ < kinds_.size() && kinds_[kind_].name == name) return kind_;
  const auto found = std::ranges::find(kinds_, name, &Kind::name);
  if (found != kinds_.end()) return static_cast<std::size_t>(found - kinds_.begin());
  kinds_.push_back({std::string(name), {}});
  return kinds_.size() - 1;
}

std::size_t FieldPlaces::file_of(std::string_view name) {
  if (file_ < files_.size() && files_[file_] == name) return file_;
  const auto found = std::ranges::find(files_, name);
  if (found != files_.end()) return static_cast<std::size_t>(found - files_.begin());
  files_.emplace_back(name);
  return files_.size() - 1;
}

// Fields come in the same order in object after object, so the label that followed the last one the previous time is
// nearly always the right one.
std::uint32_t FieldPlaces::label_of(std::string_view field, std::size_t file) {
  const auto is_it = [&](const Label& label) { return label.file == file && label.field == field; };
  if (!labels_.empty() && is_it(labels_[follower_[last_label_]])) return last_label_ = follower_[last_label_];
  const auto found = static_cast<std::uint32_t>(std::ranges::find_if(labels_, is_it) - labels_.begin());
  if (found == labels_.size()) {
    if (found == label_limit) return label_limit;
    labels_.push_back({std::string(field), file});
    follower_.push_back(0);
  }
  follower_[last_label_] = found;
  return last_label_ = found;
}

void FieldPlaces::add(const core::Subject& subject, const core::Place& place) {
  begin_object(subject.kind, subject.index, place.file);
  add_field(subject.field, place.line, place.column);
}

void FieldPlaces::begin_object(std::string_view kind, std::size_t index, std::string_view file) {
  kind_ = kind_of(kind);
  file_ = file_of(file);
  object_ = index;
}

void FieldPlaces::add_field(std::string_view field, std::size_t line, std::size_t column) {
  const std::uint32_t label = label_of(field, file_);
  if (label == label_limit || object_ > UINT32_MAX || line > UINT32_MAX) return;
  const auto short_column = static_cast<std::uint32_t>(column < column_limit ? column : 0);
  const auto object = static_cast<std::uint32_t>(object_);
  std::vector<Entry>& entries = kinds_[kind_].entries;
  const auto at = entries.empty() || entries.back().object <= object
                      ? entries.end()
                      : std::ranges::upper_bound(entries, object, {}, &Entry::object);
  entries.emplace(at, object, static_cast<std::uint32_t>(line), (short_column << label_bits) | label);
}

std::vector<std::uint32_t> FieldPlaces::labels_for(const FieldPlaces& later) {
  std::vector<std::uint32_t> labels;
  labels.reserve(later.labels_.size());
  for (const std::string& file : later.files_) static_cast<void>(file_of(file));
  for (const Label& label : later.labels_) labels.push_back(label_of(label.field, file_of(later.files_[label.file])));
  return labels;
}

void FieldPlaces::append_entries(const Kind& later, std::size_t objects_before, std::span<const std::uint32_t> labels,
                                 double share) {
  std::vector<Entry>& entries = kinds_[kind_of(later.name)].entries;
  script::make_room(entries, later.entries.size(), share);
  for (const Entry& entry : later.entries) {
    const std::size_t object = objects_before + entry.object;
    const std::uint32_t label = labels[entry.column_and_label % label_limit];
    if (label == label_limit || object > UINT32_MAX) continue;
    entries.push_back(
        {static_cast<std::uint32_t>(object), entry.line, (entry.column_and_label & ~(label_limit - 1)) | label});
  }
}

core::Place FieldPlaces::find_exactly(const Kind& kind, std::size_t index, std::string_view field) const {
  for (const Entry& entry : std::ranges::equal_range(kind.entries, index, {}, &Entry::object)) {
    const Label& label = labels_[entry.column_and_label % label_limit];
    if (label.field == field) return {files_[label.file], entry.line, entry.column_and_label >> label_bits};
  }
  return {};
}

core::Place FieldPlaces::find(const core::Subject& subject) const {
  const auto kind = std::ranges::find(kinds_, subject.kind, &Kind::name);
  if (kind == kinds_.end()) return {};
  const std::string_view field = subject.field;
  for (const std::string_view name : {field, field.substr(0, field.find_first_of(".[")), std::string_view{}}) {
    const core::Place place = find_exactly(*kind, subject.index, name);
    if (place.line > 0) return place;
  }
  return {};
}

}  // namespace sarsim::scene
