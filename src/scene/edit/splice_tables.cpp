#include "scene/edit/splice_tables.hpp"

#include <algorithm>
#include <iterator>

#include "core/toml/lines.hpp"
#include "core/toml/parse.hpp"
#include "core/toml/scan.hpp"
#include "core/toml/values.hpp"
#include "scene/edit/splice_command.hpp"
#include "scene/edit/splice_value.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/object_text.hpp"

namespace sarsim::scene::format_2 {

namespace toml = core::toml;

namespace {

std::optional<ObjectKind> kind_of_table(language::ObjectText& object) {
  for (const ObjectKind kind : all_object_kinds)
    if (language::header_of(kind) == object.kind)
      return kind == ObjectKind::target && object.find("positions.file") != nullptr ? ObjectKind::cloud : kind;
  return std::nullopt;
}

// Files an object away, as the reader does.
void add_object_table(ObjectTables& tables, std::string_view text, language::ObjectText& object, ObjectTable table) {
  if (object.kind == "options") {
    tables.options = table;
    return;
  }
  if (object.kind == "world") {
    tables.world = table;
    return;
  }
  if (object.kind == "atmosphere") {
    tables.atmosphere = table;
    return;
  }
  const auto kind = kind_of_table(object);
  if (!kind || !object.is_element) return;
  if (const language::Leaf* const list = object.find("positions"); *kind == ObjectKind::target && list != nullptr) {
    table.positions = list->value;
    table.positions_key = list->key;
    toml::Elements rows(text, list->value);
    for (table.objects = 0; list->value.kind == toml::Kind::array && rows.next();) ++table.objects;
  }
  std::vector<ObjectTable>& list = tables.of[static_cast<std::size_t>(*kind)];
  if (!list.empty()) table.preceding = list.back().preceding + list.back().objects;
  list.push_back(table);
}

// A key as it stands in a text: with a line of its own, as a table with a header, or as one that dotted keys make.
struct TypedKey {
  std::string key;
  bool is_line = false;
  toml::Span at;  // of a line: from the key to behind its value
  toml::Value value;
  std::optional<std::size_t> table;  // with a header of its own: in Document::tables
  std::vector<TypedKey> below;
};

TypedKey& typed_below(TypedKey& parent, const std::string& key) {
  const auto found = std::ranges::find(parent.below, key, &TypedKey::key);
  if (found != parent.below.end()) return *found;
  TypedKey& made = parent.below.emplace_back();
  made.key = key;
  return made;
}

TypedKey typed_keys(std::string_view text, const toml::Document& document, const ObjectTable& table) {
  TypedKey root;
  for (std::size_t i = table.first; i < table.last; ++i) {
    const toml::Table& part = document.tables[i];
    TypedKey* own = &root;
    const std::vector<std::string> path = toml::key_parts(text, part.name);
    for (std::size_t depth = 1; depth < path.size(); ++depth) own = &typed_below(*own, path[depth]);
    own->table = i;
    for (std::size_t entry = part.first_entry; entry < part.first_entry + part.entries; ++entry) {
      const toml::Entry& line = document.entries[entry];
      TypedKey* key = own;
      for (const std::string& name : toml::key_parts(text, line.key)) key = &typed_below(*key, name);
      key->is_line = true;
      key->at = {line.key.begin, line.value.span.end};
      key->value = line.value;
    }
  }
  return root;
}

// The end of a table's last entry, or of its header.
std::size_t last_end(const toml::Document& document, std::size_t table) {
  const toml::Table& part = document.tables[table];
  return part.entries == 0 ? part.header.end : document.entries[part.first_entry + part.entries - 1].value.span.end;
}

// Behind the last line of tables and the comment lines directly below it that are not about the next one.
std::size_t tables_end(std::string_view text, const toml::Document& document, std::size_t first, std::size_t last) {
  std::size_t end = 0;
  for (std::size_t i = first; i < last; ++i) end = std::max(end, last_end(document, i));
  end = behind_line(text, end);
  const std::size_t limit =
      last < document.tables.size() ? comments_begin(text, document, document.tables[last].header.begin) : text.size();
  while (end < limit && toml::byte_at(text, toml::skip(text, end, toml::blank_byte)) == '#')
    end = behind_line(text, end);
  return end;
}

// Changes the text of one object.
class TableChanger {
 public:
  TableChanger(std::string_view text, const ObjectTables& tables, const ObjectTable& table)
      : text_(text), document_(tables.document), end_(stretch_of(text, tables, table).end) {}

  // False where a key has no place in lines of a table; what was changed then counts for nothing.
  bool change(const TypedKey& typed, const std::string& path, const std::vector<Said>& before,
              const std::vector<Said>& after) {
    for (const Said& becomes : after) {
      const Said* const was = find_typed(before, becomes.key);
      if (says_same(was, &becomes)) continue;
      const auto found = std::ranges::find(typed.below, becomes.key, &TypedKey::key);
      const bool done =
          found == typed.below.end() ? add(typed, path, becomes) : change_key(typed, *found, path, was, becomes);
      if (!done) return false;
    }
    for (const Said& was : before) {
      if (find_typed(after, was.key) != nullptr) continue;
      const auto found = std::ranges::find(typed.below, was.key, &TypedKey::key);
      if (found != typed.below.end()) remove(*found, false);
    }
    return true;
  }

  [[nodiscard]] TextChanges take() {
    if (!new_tables_.empty()) insert(end_, std::move(new_tables_));
    return std::move(changes_);
  }

 private:
  bool change_key(const TypedKey& parent, const TypedKey& typed, const std::string& path, const Said* was,
                  const Said& becomes) {
    if (typed.is_line) {
      const std::string_view value = toml::piece(text_, typed.value.span);
      const bool other_type = !value.starts_with('{') || (was != nullptr && !same_type(*was, becomes));
      if (other_type && is_long(becomes, path)) return replace(parent, typed, path, becomes);
      replace_stretch(changes_, text_, typed.value.span, value_after(value, was, becomes));
      return true;
    }
    const std::size_t mark = changes_.size();
    const std::size_t tables_mark = new_tables_.size();
    static const std::vector<Said> nothing;
    const std::vector<Said>& before = was == nullptr ? nothing : was->below;
    if (!becomes.below.empty() && has_type_of(typed, was) &&
        change(typed, path + "." + typed.key, before, becomes.below))
      return true;
    changes_.resize(mark);
    new_tables_.resize(tables_mark);
    return replace(parent, typed, path, becomes);
  }

  static bool same_type(const Said& a, const Said& b) {
    return says_same(find_typed(a.below, "type"), find_typed(b.below, "type"));
  }

  [[nodiscard]] bool has_type_of(const TypedKey& typed, const Said* was) const {
    const auto type = std::ranges::find(typed.below, "type", &TypedKey::key);
    return type == typed.below.end() || is_type_of(toml::piece(text_, type->value.span), was);
  }

  // Whether the writer gives a table a header of its own.
  static bool is_long(const Said& said, const std::string& path) { return lines_of(said, path).starts_with('['); }

  bool replace(const TypedKey& parent, const TypedKey& typed, const std::string& path, const Said& becomes) {
    remove(typed, false);
    return add(parent, path, becomes);
  }

  bool add(const TypedKey& parent, const std::string& path, const Said& said) {
    const std::string lines = lines_of(said, path);
    if (lines.starts_with('[')) {
      new_tables_ += lines;
      return true;
    }
    if (parent.table) {
      const toml::Table& table = document_.tables[*parent.table];
      const std::size_t last =
          table.entries == 0 ? table.header.begin : document_.entries[table.first_entry + table.entries - 1].key.begin;
      insert(behind_line(text_, last_end(document_, *parent.table)), indentation(last) + lines);
      return true;
    }
    // Behind the last of the dotted keys that make the table.
    const auto last = std::ranges::find_if(parent.below.rbegin(), parent.below.rend(), &TypedKey::is_line);
    if (last == parent.below.rend()) return false;
    toml::Span key{last->at.begin, last->value.span.begin};
    std::size_t own = key.begin;
    while (const auto part = toml::next_key_part(text_, key)) own = part->begin;
    const std::string before(text_.substr(last->at.begin, own - last->at.begin));
    insert(behind_line(text_, last->at.end), indentation(last->at.begin) + before + lines);
    return true;
  }

  [[nodiscard]] std::string indentation(std::size_t at) const {
    const std::size_t begin = line_begin(text_, at);
    return std::string(text_.substr(begin, toml::skip(text_, begin, toml::blank_byte) - begin));
  }

  // Lines at the begin of a line, or behind the last one.
  void insert(std::size_t at, std::string lines) {
    if (at > 0 && text_[at - 1] != '\n') {
      lines.pop_back();
      lines.insert(0, "\n");
    }
    changes_.push_back({at, "", with_ends_of(text_, std::move(lines))});
  }

  // @param gone  the lines of the table that it stands in go as a whole
  void remove(const TypedKey& typed, bool gone) {
    if (typed.is_line && !gone) cut(line_begin(text_, typed.at.begin), behind_line(text_, typed.at.end));
    if (typed.table) {
      std::size_t begin = comments_begin(text_, document_, document_.tables[*typed.table].header.begin);
      while (begin > 0 && blank_line_before(text_, begin)) begin = line_begin(text_, line_feed_before(begin));
      cut(begin, tables_end(text_, document_, *typed.table, *typed.table + 1));
    }
    for (const TypedKey& below : typed.below) remove(below, gone || typed.table.has_value());
  }

  // Where the line end before the begin of a line begins.
  [[nodiscard]] std::size_t line_feed_before(std::size_t begin) const {
    return begin > 1 && text_[begin - 2] == '\r' ? begin - 2 : begin - 1;
  }

  void cut(std::size_t begin, std::size_t end) {
    changes_.push_back({begin, std::string(text_.substr(begin, end - begin)), ""});
  }

  std::string_view text_;
  const toml::Document& document_;
  std::size_t end_;
  TextChanges changes_;
  std::string new_tables_;  // which come behind all that the object has
};

}  // namespace

ObjectTables find_tables(std::string_view text) {
  ObjectTables tables;
  tables.document = toml::parse(text);
  language::ObjectTexts objects(text, tables.document);
  language::ObjectText object;
  std::size_t first = 0;
  while (objects.next(object)) {
    std::size_t last = first + 1;
    for (const language::Leaf& leaf : object.leaves)
      if (leaf.is_header && leaf.key != object.header) ++last;
    if (first > 0) add_object_table(tables, text, object, {first, last});
    first = last;
  }
  return tables;
}

const ObjectTable* table_with(const ObjectTables& tables, ObjectKind kind, std::size_t index) {
  const std::vector<ObjectTable>& list = tables[kind];
  const auto behind = std::ranges::upper_bound(list, index, {}, &ObjectTable::preceding);
  if (behind == list.begin()) return nullptr;
  const ObjectTable& table = *std::prev(behind);
  return index < table.preceding + table.objects ? &table : nullptr;
}

namespace {

// Where bytes of a text are after changes of it.
class Shift {
 public:
  explicit Shift(const TextChanges& changes) {
    std::ptrdiff_t grown = 0;
    for (const TextChange& change : changes) {
      grown += std::ssize(change.after) - std::ssize(change.before);
      ends_.push_back(change.at + change.before.size());
      grown_.push_back(grown);
    }
  }

  // What a change touches begins where it began and ends where it ends now.
  [[nodiscard]] std::size_t of(std::size_t at) const {
    const auto behind = std::ranges::upper_bound(ends_, at) - ends_.begin();
    return behind == 0 ? at : at + static_cast<std::size_t>(grown_[static_cast<std::size_t>(behind) - 1]);
  }
  void move(toml::Span& span) const {
    span = {static_cast<std::uint32_t>(of(span.begin)), static_cast<std::uint32_t>(of(span.end))};
  }

 private:
  std::vector<std::size_t> ends_;
  std::vector<std::ptrdiff_t> grown_;
};

}  // namespace

ObjectTables after_changes(ObjectTables tables, const TextChanges& changes) {
  const Shift shift(changes);
  for (toml::Table& table : tables.document.tables) {
    shift.move(table.header);
    shift.move(table.name);
  }
  for (toml::Entry& entry : tables.document.entries) {
    shift.move(entry.key);
    shift.move(entry.value.span);
  }
  for (toml::Mistake& mistake : tables.document.mistakes) shift.move(mistake.at);
  for (std::vector<ObjectTable>& list : tables.of)
    for (ObjectTable& table : list) {
      if (!table.positions) continue;
      shift.move(table.positions->span);
      shift.move(table.positions_key);
    }
  return tables;
}

std::vector<toml::Value> rows_of(std::string_view text, const toml::Value& array) {
  std::vector<toml::Value> rows;
  toml::Elements elements(text, array);
  while (const auto element = elements.next()) rows.push_back(element->value);
  return rows;
}

TextStretch stretch_of(std::string_view text, const ObjectTables& tables, const ObjectTable& table) {
  return {tables.document.tables[table.first].header.begin, tables_end(text, tables.document, table.first, table.last)};
}

std::size_t lead_of(std::string_view text, const ObjectTables& tables, const ObjectTable& table) {
  return comments_begin(text, tables.document, tables.document.tables[table.first].header.begin);
}

TextChanges change_tables(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
                          const std::string& header, const std::vector<Said>& before, const std::vector<Said>& after) {
  TableChanger changer(text, tables, table);
  static_cast<void>(changer.change(typed_keys(text, tables.document, table), header, before, after));
  return changer.take();
}

bool would_be_empty(std::string_view text, const ObjectTables& tables, const ObjectTable& table,
                    const std::vector<Said>& before, const std::vector<Said>& after) {
  const TypedKey typed = typed_keys(text, tables.document, table);
  return after.empty() &&
         std::ranges::all_of(typed.below, [&](const TypedKey& key) { return find_typed(before, key.key) != nullptr; });
}

std::string with_ends_of(std::string_view text, std::string lines) {
  if (line_end_of(text) == "\n") return lines;
  std::erase(lines, '\r');  // of lines copied from the text
  return scene::detail::with_line_ends(lines, "\r\n");
}

}  // namespace sarsim::scene::format_2

namespace sarsim::scene {

CommandPlaces find_objects(std::string_view text, const format_2::ObjectTables& tables) {
  CommandPlaces places;
  for (const ObjectKind kind : all_object_kinds)
    for (const format_2::ObjectTable& table : tables[kind]) {
      if (!table.positions) {
        places[kind].push_back(stretch_of(text, tables, table));
        continue;
      }
      for (const core::toml::Value& row : format_2::rows_of(text, *table.positions))
        places[kind].push_back({row.span.begin, row.span.end});
    }
  if (tables.options) places.of[CommandPlaces::options].push_back(stretch_of(text, tables, *tables.options));
  return places;
}

CommandPlaces after_changes(CommandPlaces places, const TextChanges& changes) {
  const format_2::Shift shift(changes);
  for (std::vector<TextStretch>& list : places.of)
    for (TextStretch& stretch : list) stretch = {shift.of(stretch.begin), shift.of(stretch.end)};
  return places;
}

}  // namespace sarsim::scene
