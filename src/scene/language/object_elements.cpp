#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/toml/values.hpp"
#include "scene/language/object_reader.hpp"
#include "scene/language/plain_table.hpp"

/// What stands in tables within an object: the elements of lists, and places on the Earth.
namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

template <class Element>
const std::vector<std::string>& keys_of() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> made;
    for (const FieldOf<Element>& field : table_of<Element>().fields()) made.emplace_back(field.spec.key);
    return made;
  }();
  return keys;
}

// Places of more entries of a list are not kept: they take the place of the list.
constexpr std::size_t placed_entries = 1000;

FieldSpec place_spec(std::string_view id, std::string_view words, Quantity quantity, const Range& range) {
  FieldSpec spec;
  spec.id = id;
  spec.words = words;
  spec.quantity = quantity;
  spec.range = range;
  return spec;
}

// The leaves of a table of an object, with or without a header of its own, as an object; they then count as used.
// Nothing for a table that is none of its leaves: an element of an array.
std::optional<ObjectText> taken_from(ObjectText& object, const toml::Value& table) {
  const auto own = std::ranges::find_if(object.leaves, [&](const Leaf& leaf) { return leaf.value.span == table.span; });
  if (own == object.leaves.end()) return std::nullopt;
  const std::string_view path = own->path;
  ObjectText taken;
  for (Leaf& leaf : object.leaves) {
    if (!is_below(leaf.path, path) || leaf.path.size() == path.size()) continue;
    taken.leaves.push_back(leaf);
    taken.leaves.back().path.remove_prefix(path.size() + 1);
    leaf.used = true;
  }
  return taken;
}

}  // namespace

template <class Element>
void ObjectReader::read_list(const FieldSpec& spec, const Leaf& leaf, std::vector<Element>& list) {
  note_place(spec.problem_place(), leaf.value.span);
  if (leaf.value.kind != toml::Kind::array) text_.use_all_below(leaf.path);
  if (leaf.value.kind != toml::Kind::array)
    return error(
        leaf.value.span, spec.problem_place(),
        {fmt::format("{} is not an array", leaf.path), std::string(noun_of(leaf.value.kind)), "[{ ... }, { ... }]"});
  toml::Elements elements(source_.text, leaf.value);
  const PlainTable& entries = element_table(spec.list);
  list.clear();
  for (std::size_t entry = 0; const auto element = elements.next(); ++entry) {
    if (reading_.log.full()) return;
    if (entry < placed_entries) note_place(fmt::format("{}[{}]", spec.problem_place(), entry), element->value.span);
    const std::string name = fmt::format("{} {}", entries.header, entry + 1);
    if (element->value.kind != toml::Kind::table) {
      error(
          element->value.span, spec.problem_place(),
          {fmt::format("{} is not a table", name), std::string(noun_of(element->value.kind)), "{ key = value, ... }"});
      continue;
    }
    ObjectTexts texts(source_.text, source_.document);
    ObjectText text = texts.inner(element->value);
    text.kind = name;
    ObjectReader inner(*this, text, spec.problem_place(), &entries);
    Element& read = list.emplace_back();
    inner.read(read);
    inner.report_lacks(read, element->value.span);
    inner.finish(keys_of<Element>());
  }
}

// What has no default and is not said. A word that nobody knows may be it, misspelt.
template <class Element>
void ObjectReader::report_lacks(const Element& element, toml::Span at) {
  if (!std::ranges::all_of(text_.leaves, &Leaf::used)) return;
  const FieldTable<Element>& table = table_of<Element>();
  for (const FieldOf<Element>& field : table.fields())
    if (field.spec.needed && table.applies(element, field) && text_.find(field.spec.key) == nullptr)
      error(at, field.spec.problem_place(),
            {fmt::format("{} lacks the {}", text_.kind, field.spec.words), "",
             fmt::format("{} = {}", field.spec.key, field.spec.example)});
}

template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Leg>&);
template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Waypoint>&);
template void ObjectReader::read_list(const FieldSpec&, const Leaf&, std::vector<Oscillation>&);

// A place on the Earth: { latitude, longitude, height }, or an altitude above the geoid in place of the height.
bool ObjectReader::read_place(const FieldSpec& spec, const toml::Value& value, core::Vec3& vector) {
  const FieldSpec latitude = place_spec(spec.problem_place(), "latitude", Quantity::angle, {-90.0, 90.0});
  const FieldSpec longitude = place_spec(spec.problem_place(), "longitude", Quantity::angle, {-360.0, 360.0});
  const FieldSpec height = place_spec(spec.problem_place(), "height", Quantity::length, {-1e4, 1e9});
  if (!reading_.earth) {
    static_cast<void>(taken_from(text_, value));  // one complaint is enough
    error(value.span, spec.problem_place(),
          {fmt::format("{}: the world is flat and has no latitudes", spec.words), "", "[x, y, z]",
           "write [world] with frame = \"earth\" and an anchor"});
    return false;
  }
  ObjectTexts texts(source_.text, source_.document);
  ObjectText text = taken_from(text_, value).value_or(texts.inner(value));
  text.kind = spec.words;
  ObjectReader inner(*this, text, spec.problem_place(), nullptr);
  std::array<double, 3> numbers{};
  bool sound = true;
  const auto read = [&](std::string_view key, const FieldSpec& of, double& number) {
    const Leaf* const leaf = inner.find(key);
    if (leaf != nullptr) sound = inner.number_in(of, leaf->value, number) && sound;
    return leaf != nullptr;
  };
  const bool has_latitude = read("latitude", latitude, numbers[0]);
  const bool has_longitude = read("longitude", longitude, numbers[1]);
  const bool has_height = read("height", height, numbers[2]);
  const bool has_altitude = read("altitude", height, numbers[2]);
  static const std::vector<std::string> known{"latitude", "longitude", "height", "altitude"};
  inner.finish(known);
  if (!has_latitude || !has_longitude || (has_height && has_altitude)) {
    error(value.span, spec.problem_place(),
          {fmt::format("{}: {}", spec.words,
                       has_height && has_altitude ? "a place has a height or an altitude, not both"
                                                  : "a place on the Earth needs latitude and longitude"),
           "", "{ latitude = \"-33.9 deg\", longitude = \"18.4 deg\", height = \"120 m\" }"});
    return false;
  }
  if (!sound) return false;
  const double latitude_rad = numbers[0] * core::rad_per_deg;
  const double longitude_rad = numbers[1] * core::rad_per_deg;
  const auto undulation_m =
      has_altitude ? reading_.earth->undulation_m(latitude_rad, longitude_rad) : std::optional<double>(0.0);
  if (!undulation_m) {
    error(value.span, spec.problem_place(),
          {fmt::format("{}: the grid of the geoid has no value there", spec.words), "", "",
           "give a height above the ellipsoid, or a grid that holds the place"});
    return false;
  }
  vector = reading_.earth->world_of({latitude_rad, longitude_rad, numbers[2] + *undulation_m});
  if (geodetic_at_ == toml::Span{}) geodetic_at_ = value.span;
  return true;
}

}  // namespace sarsim::scene::language
