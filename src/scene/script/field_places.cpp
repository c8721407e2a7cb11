#include "scene/script/field_places.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "scene/script/make_room.hpp"

namespace sarsim::scene {

namespace {

constexpr std::uint32_t label_limit = 1U << 12U;
constexpr std::size_t column_limit = std::size_t{1} << 20U;
constexpr std::size_t block_entries = 64;

// An entry is a byte with a bit for the next object, one for a label that is not the expected one and the difference of
// lines; then such a label, and the column. Where the differences are larger, the byte is another, and both differences
// and the label follow it as numbers. Numbers have seven bits in a byte, least significant first.
constexpr std::uint8_t large_step = 0xFF;
constexpr std::uint32_t next_object = 1;
constexpr std::uint32_t other_label = 2;
constexpr unsigned line_shift = 2;
constexpr std::uint32_t largest_line_step = large_step >> line_shift;
constexpr std::size_t longest_entry = 21;

// Labels are numbered in the order in which the fields of the first object came, in which those of the others come too.
constexpr std::uint32_t no_label = UINT32_MAX;
constexpr std::uint32_t label_after(std::uint32_t last, bool is_next_object) { return is_next_object ? 0 : last + 1; }

// Differences of either sign as numbers: 0, -1, 1, -2 ... are 0, 1, 2, 3 ...
constexpr std::uint32_t folded(std::uint32_t difference) { return (difference << 1U) ^ (0U - (difference >> 31U)); }
constexpr std::uint32_t unfolded(std::uint32_t number) { return (number >> 1U) ^ (0U - (number & 1U)); }

std::uint8_t* put(std::uint8_t* at, std::uint32_t number) {
  for (; number >= 0x80; number >>= 7U) *at++ = static_cast<std::uint8_t>(number | 0x80U);
  *at++ = static_cast<std::uint8_t>(number);
  return at;
}

std::uint32_t taken(const std::uint8_t*& at) {
  std::uint32_t number = 0;
  unsigned shift = 0;
  for (; (*at & 0x80U) != 0; shift += 7) number |= (*at++ & 0x7FU) << shift;
  return number | std::uint32_t{*at++} << shift;
}

}  // namespace

void FieldPlaces::Kind::add(const Entry& entry) {
  if (!blocks.empty() && entry.object < last.object) {
    strays.push_back(entry);
    return;
  }
  if (blocks.empty() || in_block == block_entries) {
    blocks.push_back({entry.object, entry.line, bytes.size()});
    last = entry;
    last.label = no_label;
    in_block = 0;
  }
  const std::uint32_t objects = entry.object - last.object;
  const std::uint32_t lines = folded(entry.line - last.line);
  std::array<std::uint8_t, longest_entry> text;
  std::uint8_t* at = text.data();
  const bool is_expected = entry.label == label_after(last.label, objects > 0);
  if (objects <= 1 && lines < largest_line_step) {
    *at++ = static_cast<std::uint8_t>(lines << line_shift | (is_expected ? 0 : other_label) | objects);
    if (!is_expected) at = put(at, entry.label);
  } else {
    *at++ = large_step;
    at = put(put(put(at, objects), lines), entry.label);
  }
  at = put(at, entry.column);
  bytes.insert(bytes.end(), text.data(), at);
  last = entry;
  ++in_block;
}

template <class Visit>
void FieldPlaces::Kind::visit(std::size_t block, const Visit& visit) const {
  for (; block < blocks.size(); ++block) {
    Entry entry{blocks[block].object, blocks[block].line, 0, no_label};
    const std::uint8_t* at = bytes.data() + blocks[block].offset;
    const std::uint8_t* const end =
        bytes.data() + (block + 1 < blocks.size() ? blocks[block + 1].offset : bytes.size());
    while (at < end) {
      const std::uint8_t step = *at++;
      const bool is_large = step == large_step;
      const std::uint32_t objects = is_large ? taken(at) : step & next_object;
      entry.object += objects;
      entry.line += unfolded(is_large ? taken(at) : std::uint32_t{step} >> line_shift);
      const bool is_given = is_large || (step & other_label) != 0;
      entry.label = is_given ? taken(at) : label_after(entry.label, objects > 0);
      entry.column = taken(at);
      if (!visit(entry)) return;
    }
  }
}

void FieldPlaces::Kind::append(const Kind& later, std::size_t objects_before, double share) {
  script::make_room(bytes, later.bytes.size(), share);
  script::make_room(blocks, later.blocks.size(), share);
  const auto before = static_cast<std::uint32_t>(objects_before);
  for (const Block& block : later.blocks)
    blocks.push_back({before + block.object, block.line, bytes.size() + block.offset});
  bytes.insert(bytes.end(), later.bytes.begin(), later.bytes.end());
  in_block = later.in_block;
  last = later.last;
  last.object += before;
}

std::size_t FieldPlaces::kind_of(std::string_view name) {
  if (kind_ < kinds_.size() && kinds_[kind_].name == name) return kind_;
  const auto found = std::ranges::find(kinds_, name, &Kind::name);
  if (found != kinds_.end()) return static_cast<std::size_t>(found - kinds_.begin());
  kinds_.emplace_back().name = name;
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
std::uint32_t FieldPlaces::label_of(Kind& kind, std::string_view field, std::size_t file) {
  const auto is_it = [&](const Label& label) { return label.file == file && label.field == field; };
  std::uint32_t& last = kind.last_label;
  if (!kind.labels.empty() && is_it(kind.labels[kind.follower[last]])) return last = kind.follower[last];
  const auto found = static_cast<std::uint32_t>(std::ranges::find_if(kind.labels, is_it) - kind.labels.begin());
  if (found == kind.labels.size()) {
    if (found == label_limit) return label_limit;
    kind.labels.push_back({std::string(field), file});
    kind.follower.push_back(0);
  }
  kind.follower[last] = found;
  return last = found;
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
  const std::uint32_t label = label_of(kinds_[kind_], field, file_);
  if (label == label_limit || object_ > UINT32_MAX || line > UINT32_MAX) return;
  const auto short_column = static_cast<std::uint32_t>(column < column_limit ? column : 0);
  kinds_[kind_].add({static_cast<std::uint32_t>(object_), static_cast<std::uint32_t>(line), short_column, label});
}

void FieldPlaces::append_kind(const Kind& later, const std::vector<std::string>& files, std::size_t objects_before,
                              double share) {
  Kind& kind = kinds_[kind_of(later.name)];
  std::vector<std::uint32_t> labels;
  for (const Label& label : later.labels) labels.push_back(label_of(kind, label.field, file_of(files[label.file])));
  bool same =
      later.strays.empty() && objects_before + later.last.object <= UINT32_MAX &&
      (kind.blocks.empty() || later.blocks.empty() || objects_before + later.blocks.front().object >= kind.last.object);
  for (std::uint32_t i = 0; i < labels.size(); ++i) same = same && labels[i] == i;
  if (same) {
    if (!later.blocks.empty()) kind.append(later, objects_before, share);
    return;
  }
  const auto take = [&](Entry entry) {
    const std::size_t object = objects_before + entry.object;
    entry.label = labels[entry.label];
    entry.object = static_cast<std::uint32_t>(object);
    if (entry.label != label_limit && object <= UINT32_MAX) kind.add(entry);
    return true;
  };
  later.visit(0, take);
  std::ranges::for_each(later.strays, take);
}

core::Place FieldPlaces::place_of(const Kind& kind, const Entry& entry) const {
  return {files_[kind.labels[entry.label].file], entry.line, entry.column};
}

core::Place FieldPlaces::find_exactly(const Kind& kind, std::size_t index, std::string_view field) const {
  const auto is_it = [&](const Entry& entry) {
    return entry.object == index && kind.labels[entry.label].field == field;
  };
  // The last block that begins before the object, which may begin in it.
  const auto after = std::ranges::lower_bound(kind.blocks, index, {}, &Block::object);
  const std::size_t first =
      after == kind.blocks.begin() ? 0 : static_cast<std::size_t>(after - kind.blocks.begin()) - 1;
  std::optional<Entry> found;
  kind.visit(first, [&](const Entry& entry) {
    if (is_it(entry)) found = entry;
    return !found && entry.object <= index;
  });
  if (found) return place_of(kind, *found);
  const auto stray = std::ranges::find_if(kind.strays, is_it);
  return stray == kind.strays.end() ? core::Place{} : place_of(kind, *stray);
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

std::size_t FieldPlaces::bytes() const {
  std::size_t sum = 0;
  for (const Kind& kind : kinds_)
    sum += kind.bytes.size() + kind.blocks.size() * sizeof(Block) + kind.strays.size() * sizeof(Entry);
  return sum;
}

bool FieldPlaces::knows_all_of(const FieldPlaces& other) const {
  for (const Kind& kind : other.kinds_) {
    const auto here = std::ranges::find(kinds_, kind.name, &Kind::name);
    bool all = true;
    const auto look = [&](const Entry& entry) {
      const std::string_view field = kind.labels[entry.label].field;
      // A field noted twice has one place.
      all = here != kinds_.end() &&
            find_exactly(*here, entry.object, field) == other.find_exactly(kind, entry.object, field);
      return all;
    };
    kind.visit(0, look);
    all = all && std::ranges::all_of(kind.strays, look);
    if (!all) return false;
  }
  return true;
}

bool operator==(const FieldPlaces& a, const FieldPlaces& b) { return a.knows_all_of(b) && b.knows_all_of(a); }

}  // namespace sarsim::scene
