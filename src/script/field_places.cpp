#include "script/field_places.hpp"

#include <algorithm>

namespace sarsim {

namespace {

constexpr std::uint32_t label_bits = 12;
constexpr std::uint32_t label_limit = 1U << label_bits;
constexpr std::size_t column_limit = std::size_t{1} << (32 - label_bits);

}  // namespace

FieldPlaces::Kind& FieldPlaces::kind_of(std::string_view name) {
  for (Kind& kind : kinds_)
    if (kind.name == name) return kind;
  return kinds_.emplace_back(Kind{std::string(name), {}});
}

// Fields come in the same order in object after object, so the label that followed the last one the previous time is
// nearly always the right one.
std::uint32_t FieldPlaces::label_of(std::string_view field, std::string_view file) {
  const auto is_it = [&](const Label& label) { return label.first == field && label.second == file; };
  if (!labels_.empty() && is_it(labels_[follower_[last_label_]])) return last_label_ = follower_[last_label_];
  const auto found = static_cast<std::uint32_t>(std::ranges::find_if(labels_, is_it) - labels_.begin());
  if (found == labels_.size()) {
    if (found == label_limit) return label_limit;
    labels_.emplace_back(field, file);
    follower_.push_back(0);
  }
  follower_[last_label_] = found;
  return last_label_ = found;
}

void FieldPlaces::add(const Subject& subject, const Place& place) {
  add(subject.kind, subject.index, subject.field, place.file, place.line, place.column);
}

void FieldPlaces::add(std::string_view kind, std::size_t index, std::string_view field, std::string_view file,
                      std::size_t line, std::size_t column) {
  const std::uint32_t label = label_of(field, file);
  if (label == label_limit || index > UINT32_MAX || line > UINT32_MAX) return;
  const auto short_column = static_cast<std::uint32_t>(column < column_limit ? column : 0);
  const Entry entry{static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(line),
                    (short_column << label_bits) | label};
  std::vector<Entry>& entries = kind_of(kind).entries;
  if (entries.empty() || entries.back().object <= entry.object)
    entries.push_back(entry);
  else
    entries.insert(std::ranges::upper_bound(entries, entry.object, {}, &Entry::object), entry);
}

Place FieldPlaces::find_exactly(const Kind& kind, std::size_t index, std::string_view field) const {
  for (const Entry& entry : std::ranges::equal_range(kind.entries, index, {}, &Entry::object)) {
    const Label& label = labels_[entry.column_and_label % label_limit];
    if (label.first == field) return {label.second, entry.line, entry.column_and_label >> label_bits};
  }
  return {};
}

Place FieldPlaces::find(const Subject& subject) const {
  const auto kind = std::ranges::find(kinds_, subject.kind, &Kind::name);
  if (kind == kinds_.end()) return {};
  const std::string_view field = subject.field;
  for (const std::string_view name : {field, field.substr(0, field.find_first_of(".[")), std::string_view{}}) {
    const Place place = find_exactly(*kind, subject.index, name);
    if (place.line > 0) return place;
  }
  return {};
}

}  // namespace sarsim
