#include "scene/language/plain_table.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "scene/language/keys.hpp"
#include "scene/model/kinds.hpp"
#include "scene/schema/field_names.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::scene::language {

namespace {

std::string capital(std::string_view word) {
  std::string text(word);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

// What the 1998 language and `--set` call the objects of a kind.
struct Names {
  std::string_view command;
  std::string set_prefix;  // "Radar1."
};

template <class Object>
Names names_of(const Kind<Object>& kind) {
  return {kind.command, capital(kind.name) + "1."};
}

template <class Object>
PlainField plain(const FieldTable<Object>& table, const FieldOf<Object>& field, const std::vector<Field>& form,
                 const Names& names) {
  static const Object initial{};
  PlainField made{field.spec};
  made.command = names.command;
  if (field.spec.type != FieldType::function && field.spec.type != FieldType::list) made.initial = field.get(initial);
  if (field.spec.type == FieldType::choice && has_words(field.spec))
    if (const FieldSpec* const standing = shorthand(table, field)) made.shorthand = standing->key;
  for (const Field& part : form) {
    if (part.spec != &field.spec) continue;
    made.labels.push_back(part.label);
    made.set_names.push_back(names.set_prefix + short_name(form, part));
  }
  return made;
}

// A yes or no with one word is an alternative of the choice with the same key.
void join_alternative(std::vector<PlainField>& fields, std::size_t at) {
  PlainField& word = fields[at];
  if (word.spec.type != FieldType::check || word.spec.choices.size() != 1) return;
  for (PlainField& other : fields) {
    if (other.spec.type != FieldType::choice || other.spec.key != word.spec.key) continue;
    Choice added = word.spec.choices.front();
    const bool is_initial = chosen(*word.initial) == added.value;
    added.value = first_added_value;
    other.spec.choices.insert(other.spec.choices.begin(), added);
    other.spec.when = {};
    if (is_initial) other.initial = first_added_value;
    word.spec.key = {};
  }
}

template <class Object>
std::vector<PlainField> plain_fields(const std::vector<Field>& form, const Names& names) {
  const FieldTable<Object>& table = table_of<Object>();
  std::vector<PlainField> fields;
  for (const FieldOf<Object>& field : table.fields()) fields.push_back(plain(table, field, form, names));
  for (std::size_t i = 0; i < fields.size(); ++i) join_alternative(fields, i);
  return fields;
}

// Targets that are alike, in one table.
void add_positions(PlainTable& targets) {
  FieldSpec positions{.key = "positions",
                      .quantity = Quantity::length,
                      .on_earth = true,
                      .tip =
                          "Many targets that differ only in position: a row [x, y, z] for each, or { file = \"FILE\" } "
                          "with a table of them."};
  positions.type = FieldType::vector;
  positions.group = targets.fields.front().spec.group;
  targets.fields.push_back({positions});
  targets.fields.back().in_script = "a $TARGET for each row, or $CLOUD with a file";
  const Names clouds = names_of(std::get<Kind<Cloud>>(kinds));
  for (PlainField& field : plain_fields<Cloud>(fields_of(ObjectKind::cloud), clouds)) {
    if (field.spec.key != "positions.file") continue;
    field.initial.reset();
    targets.fields.push_back(std::move(field));
  }
}

// A path that is told by a point and a velocity.
void add_line(PlainTable& platforms) {
  std::vector<PlainField>& fields = platforms.fields;
  const auto path = std::ranges::find_if(
      fields, [](const PlainField& field) { return field.spec.key == "path" && field.spec.type == FieldType::choice; });
  const auto at = static_cast<std::size_t>(path - fields.begin());
  path->spec.choices.emplace_back("", first_added_value, "", "straight, at constant velocity", "line");
  for (PlainField& field : fields)
    if (field.spec.key == "path.aligned") field.spec.when.among.push_back(first_added_value);
  FieldSpec start{
      .key = "path.start", .quantity = Quantity::length, .on_earth = true, .tip = "World position at time 0."};
  start.type = FieldType::vector;
  start.group = path->spec.group;
  start.when = {at, {first_added_value}};
  start.likely = likely_range(Quantity::length);
  FieldSpec velocity = start;
  velocity.key = "path.velocity";
  velocity.quantity = Quantity::speed;
  velocity.likely = likely_range(Quantity::speed);
  velocity.tip = "World velocity, which stays; without it there is no such path.";
  constexpr std::string_view in_script = "TRAJECTORY with one or two points for each coordinate";
  fields.push_back({.spec = start, .initial = core::Vec3{}, .in_script = in_script});
  fields.push_back({.spec = velocity, .in_script = in_script});
}

std::vector<PlainTable> make_tables() {
  std::vector<PlainTable> tables;
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if (kind.kind == ObjectKind::cloud) return;
    PlainTable& table = tables.emplace_back();
    table = {header_of(kind.kind), kind.meaning, kind.command, true,
             plain_fields<Object>(fields_of(kind.kind), names_of(kind))};
    if (kind.kind == ObjectKind::target) add_positions(table);
    if (kind.kind == ObjectKind::platform) add_line(table);
  });
  for_each_single([&]<class Table>(const Single<Table>& single) {
    const bool is_options = std::is_same_v<Table, RunOptions>;
    const std::vector<Field>& form = is_options                     ? option_fields()
                                     : std::is_same_v<Table, World> ? world_fields()
                                                                    : atmosphere_fields();
    tables.push_back(
        {single.header, single.meaning, single.command, false, plain_fields<Table>(form, {single.command, ""})});
    if (is_options) return;
    // They are set in the text: places are turned into positions as it is read.
    for (PlainField& field : tables.back().fields) field.set_names.clear();
  });
  return tables;
}

}  // namespace

std::string PlainTable::header_line() const {
  return is_list ? fmt::format("[[{}]]", header) : fmt::format("[{}]", header);
}

const std::vector<PlainTable>& plain_tables() {
  static const std::vector<PlainTable> made = make_tables();
  return made;
}

const PlainTable& element_table(ListKind kind) {
  const auto made = []<class Element>(std::string_view header, std::string_view meaning, std::type_identity<Element>) {
    PlainTable table{header, meaning, "", false, plain_fields<Element>({}, {}), true};
    for (PlainField& field : table.fields) {
      field.spec.since_2 = true;
      if (field.spec.needed) field.initial.reset();
    }
    return table;
  };
  static const PlainTable legs = made("leg", "A piece of a path.", std::type_identity<Leg>{});
  static const PlainTable waypoints = made("waypoint", "A point of a route.", std::type_identity<Waypoint>{});
  static const PlainTable sines =
      made("oscillation", "A sinusoid of a coordinate or an angle.", std::type_identity<Oscillation>{});
  switch (kind) {
    case ListKind::legs: return legs;
    case ListKind::waypoints: return waypoints;
    default: return sines;
  }
}

const PlainTable* plain_table(std::string_view header) {
  for (const PlainTable& table : plain_tables())
    if (table.header == header) return &table;
  return nullptr;
}

}  // namespace sarsim::scene::language
