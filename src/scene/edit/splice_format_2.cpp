#include "scene/edit/splice_format_2.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "core/toml/values.hpp"
#include "scene/edit/edit_runs.hpp"
#include "scene/edit/splice_check.hpp"
#include "scene/edit/splice_tables.hpp"
#include "scene/edit/splice_value.hpp"
#include "scene/edit/typed_fields.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/value_text.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

using namespace format_2;
namespace toml = core::toml;

// An object of a list as the edit leaves it. New ones, and those of included files, stand nowhere in the text.
struct ListedObject {
  const ObjectTable* table = nullptr;
  std::size_t row = 0;    // in a list of positions
  std::size_t index = 0;  // in the scene before, of those in the text
  bool is_new = false;
  const SharedObject* after = nullptr;  // where replaced or new
};

using Listed = std::span<const ListedObject>;

// Fields that were typed into: as the text says them, and as it is to say them.
struct TypedWords {
  std::vector<FieldText> before;
  std::vector<FieldText> after;
};

bool is_position(const TypedText& typed) { return typed.field->spec->key == "position"; }

bool differ_in_position_alone(const Target& a, const Target& b) {
  Target moved = a;
  moved.position_m = b.position_m;
  return moved == b;
}

// Objects of a list of positions that come to stand in one table.
struct ListPart {
  Listed objects;
  bool is_new = false;
  const Target* alike = nullptr;  // what they have in common; null: what they had
};

// A text that makes objects, and how many stand before its own in the scene.
struct SplicedText {
  std::string name = {};  // as files are included; empty: the one that includes them
  std::string_view text;
  const ObjectTables* tables = nullptr;
  ObjectCounts preceding = {};
};

class TableSplicer {
 public:
  // @param fine  false: changed objects are written anew
  TableSplicer(const SplicedText& text, const Scene& before, bool fine)
      : text_(text.text),
        tables_(*text.tables),
        preceding_(text.preceding),
        takes_new_(text.name.empty()),
        before_(before),
        fine_(fine) {}

  TextChanges make(const Edit& edit) {
    for (const TypedText& typed : edit.typed) typed_.insert({typed.object, &typed});
    std::array<std::vector<ListedObject>, kind_count> lists;
    for (const ObjectChange& change : edit.changes) {
      std::vector<ListedObject>& list = lists[static_cast<std::size_t>(change.id.kind)];
      if (list.empty()) list = standing(change.id.kind);
    }
    const std::vector<ListChange> changes = list_changes(edit, true);
    for (std::span<const ListChange> rest = changes; !rest.empty();) {
      const std::size_t count = run_length(rest);
      follow(lists[static_cast<std::size_t>(rest.front().id.kind)], rest.first(count));
      rest = rest.subspan(count);
    }
    for (const ObjectKind kind : written_object_kinds)
      if (touched_[static_cast<std::size_t>(kind)]) write_list(kind, lists[static_cast<std::size_t>(kind)]);
    const bool options_typed = typed_.contains(std::nullopt);
    if (edit.options_before && edit.options_after && (options_typed || *edit.options_before != *edit.options_after))
      write_options(*edit.options_before, *edit.options_after);
    if (edit.air_before && edit.air_after && *edit.air_before != *edit.air_after)
      write_single(tables_.atmosphere, "atmosphere", said_of(*edit.air_before), said_of(*edit.air_after));
    if (edit.world_before && edit.world_after && *edit.world_before != *edit.world_after)
      write_single(tables_.world, "world", said_of(*edit.world_before), said_of(*edit.world_after), begin_of_objects());
    return finish();
  }

  // The tables that were changed, where that is all that was done.
  [[nodiscard]] const std::vector<ChangedTable>* changed_alone() const { return alone_ ? &changed_ : nullptr; }

 private:
  std::vector<ListedObject> standing(ObjectKind kind) {
    touched_[static_cast<std::size_t>(kind)] = true;
    std::vector<ListedObject> list(preceding_[static_cast<std::size_t>(kind)]);
    for (const ObjectTable& table : tables_[kind])
      for (std::size_t row = 0; row < table.objects; ++row) list.push_back({&table, row, list.size()});
    list.resize(std::max(list.size(), count_of(before_, kind)));
    return list;
  }

  static void follow(std::vector<ListedObject>& list, std::span<const ListChange> run) {
    change_list(
        list, run, [](const ListedObject&, const ListChange&) { return true; },
        [](ListedObject& object, const ListChange& change) { object.after = change.in; },
        [](ListedObject&&, const ListChange&) {},
        [](const ListChange& change) {
          ListedObject object;
          object.is_new = true;
          object.after = change.in;
          return object;
        });
  }

  void write_list(ObjectKind kind, Listed objects) {
    const std::vector<ObjectTable>& tables = tables_[kind];
    const ObjectTable* next = tables.data();  // the first that is not passed yet
    const ObjectTable* last = nullptr;
    const auto remove_up_to = [&](const ObjectTable* end) {
      for (; next != end; ++next)
        if (next->objects > 0) remove(*next);
    };
    for (std::size_t at = 0; at < objects.size();) {
      std::size_t end = at + 1;
      if (const ObjectTable* const table = objects[at].table) {
        end = end_of_table(objects, at);
        write_table(kind, *table, at, objects.subspan(at, end - at));
        remove_up_to(table);
        last = next++;
      } else if (objects[at].is_new) {
        while (end < objects.size() && objects[end].is_new) ++end;
        if (takes_new_)
          insert(kind, last, end < objects.size() ? objects[end].table : nullptr, objects.subspan(at, end - at));
      } else if (objects[at].after != nullptr) {
        alone_ = false;  // it stands in an included file
      }
      at = end;
    }
    remove_up_to(tables.data() + tables.size());
  }

  // New ones between the rows of a list count as its own.
  static std::size_t end_of_table(Listed objects, std::size_t first) {
    std::size_t end = first + 1;
    for (std::size_t i = end; i < objects.size(); ++i) {
      if (objects[i].table == objects[first].table)
        end = i + 1;
      else if (!objects[i].is_new)
        break;
    }
    return end;
  }

  void write_table(ObjectKind kind, const ObjectTable& table, std::size_t first, Listed objects) {
    const bool changed = std::ranges::any_of(objects, [](const ListedObject& o) { return o.after != nullptr; });
    if (!changed && objects.size() == table.objects) return;
    changed_.push_back({kind, &table, first, objects.size()});
    if (!fine_) return write_anew(kind, table, objects);
    if (table.positions) return write_positions(table, objects);
    const ObjectId id{kind, objects.front().index};
    const AnyObject before = object_of(before_, id);
    const TypedWords words = words_of(id, before, table);
    append(changes_, change_tables(text_, tables_, table, std::string(language::header_of(kind)),
                                   said_of(before, words.before), said_of(**objects.front().after, words.after)));
  }

  // @param id   nothing: the options
  // @param row  of a target in a list: its position alone; nothing: all that its table says
  template <class Values>
  [[nodiscard]] TypedWords words_of(std::optional<ObjectId> id, const Values& before, const ObjectTable& table,
                                    std::optional<toml::Value> row = std::nullopt) const {
    TypedWords words;
    const auto [first, last] = typed_.equal_range(id);
    if (first == last) return words;
    TypedObject object(text_, tables_, table, row);
    for (auto entry = first; entry != last; ++entry) {
      const TypedText& typed = *entry->second;
      if (table.positions && is_position(typed) != row.has_value()) continue;
      const Field& field = *typed.field;
      if (const auto value = object.find(before, field))
        words.before.push_back({field.spec, field.part, std::string(toml::piece(text_, value->span))});
      if (!typed.text.empty()) words.after.push_back({field.spec, field.part, typed.text});
    }
    return words;
  }

  void write_anew(ObjectKind kind, const ObjectTable& table, Listed objects) {
    const TextStretch at = stretch_of(text_, tables_, table);
    std::string lines = with_ends_of(text_, written(kind, objects).substr(1));
    if (text_[at.end - 1] != '\n') lines.resize(lines.find_last_not_of("\r\n") + 1);
    changes_.push_back({at.begin, std::string(text_.substr(at.begin, at.end - at.begin)), std::move(lines)});
  }

  // The writer's text of objects, an empty line above each.
  [[nodiscard]] std::string written(ObjectKind kind, Listed objects) const {
    Scene scene;
    visit_list(scene, kind, [&]<class Object>(std::vector<Object>& list) {
      list.reserve(objects.size());
      for (const ListedObject& object : objects)
        list.push_back(object.after != nullptr ? *object.after->get_if<Object>()
                                               : std::get<Object>(object_of(before_, {kind, object.index})));
    });
    return write_objects(scene, kind);
  }

  // ---- lists of positions

  [[nodiscard]] const Target& target_before(const ListedObject& object) const { return before_.targets[object.index]; }
  [[nodiscard]] const Target& target_after(const ListedObject& object) const {
    return object.after != nullptr ? *object.after->get_if<Target>() : target_before(object);
  }

  [[nodiscard]] bool is_typed_beside_position(const ListedObject& object) const {
    const auto [first, last] = typed_.equal_range(ObjectId{ObjectKind::target, object.index});
    return std::any_of(first, last, [](const auto& entry) { return !is_position(*entry.second); });
  }

  // Objects in a row that have the same in common are one part.
  [[nodiscard]] std::vector<ListPart> parts_of(Listed objects) const {
    std::vector<ListPart> parts;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const ListedObject& object = objects[i];
      const Target& after = target_after(object);
      const bool moved =
          !object.is_new && (object.after == nullptr || (!is_typed_beside_position(object) &&
                                                         differ_in_position_alone(target_before(object), after)));
      ListPart* const part = parts.empty() ? nullptr : &parts.back();
      const bool joins =
          part != nullptr && part->is_new == object.is_new &&
          (object.is_new ||
           (moved ? part->alike == nullptr : part->alike != nullptr && differ_in_position_alone(*part->alike, after)));
      if (joins)
        part->objects = {part->objects.data(), part->objects.size() + 1};
      else
        parts.push_back({objects.subspan(i, 1), object.is_new, moved || object.is_new ? nullptr : &after});
    }
    return parts;
  }

  // The table stays where it is with the first part that keeps its values; the others get tables of their own.
  void write_positions(const ObjectTable& table, Listed objects) {
    constexpr std::size_t max_parts = 50;  // each copies the table
    const std::vector<ListPart> parts = parts_of(objects);
    if (parts.size() > max_parts) return write_anew(ObjectKind::target, table, objects);
    const auto stands = [](const ListPart& part) { return !part.is_new; };
    auto main =
        std::ranges::find_if(parts, [&](const ListPart& part) { return stands(part) && part.alike == nullptr; });
    if (main == parts.end()) main = std::ranges::find_if(parts, stands);
    if (parts.size() == 1 && stands(*main) && main->alike == nullptr && objects.size() == table.objects)
      return write_rows(table, *main);
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      if (part == main)
        append(changes_, changes_of_part(table, *part));
      else
        add_block(part < main ? lead_of(text_, tables_, table) : stretch_of(text_, tables_, table).end,
                  part->is_new ? written(ObjectKind::target, part->objects) : "\n" + copy_of_part(table, *part));
    }
  }

  [[nodiscard]] TextChanges changes_of_keys(const ObjectTable& table, const ListPart& part) const {
    if (part.alike == nullptr) return {};
    Target before = target_before(part.objects.front());
    Target after = *part.alike;
    before.position_m = after.position_m = {};
    const TypedWords words = words_of(ObjectId{ObjectKind::target, part.objects.front().index}, before, table);
    return change_tables(text_, tables_, table, "target", said_of(before, words.before), said_of(after, words.after));
  }

  [[nodiscard]] std::optional<std::string> new_row(const ListedObject& object, const toml::Value& row) const {
    if (object.after == nullptr) return std::nullopt;
    const Target& before = target_before(object);
    const core::Vec3& position = target_after(object).position_m;
    const TypedWords words = words_of(ObjectId{ObjectKind::target, object.index}, before, *object.table, row);
    if (position == before.position_m && words.before.empty()) return std::nullopt;
    const FieldSpec& field = table_of<Target>().field<&Target::position_m>().spec;
    const Said was{"position", field_value_text(field, before.position_m, words.before)};
    return value_after(toml::piece(text_, row.span), &was,
                       {"position", field_value_text(field, position, words.after)});
  }

  // The rows of a list that a part keeps, as they are to be.
  [[nodiscard]] std::vector<RowChange> row_changes_of(const ObjectTable& table, const ListPart& part,
                                                      const std::vector<toml::Value>& rows) const {
    std::vector<RowChange> changes(table.objects, RowChange{true});
    for (const ListedObject& object : part.objects) changes[object.row] = {false, new_row(object, rows[object.row])};
    return changes;
  }

  [[nodiscard]] TextChanges changes_of_part(const ObjectTable& table, const ListPart& part) const {
    TextChanges changes = changes_of_keys(table, part);
    const std::vector<toml::Value> rows = rows_of(text_, *table.positions);
    append(changes, change_rows(text_, *table.positions, row_changes_of(table, part, rows)));
    return changes;
  }

  // All of them stay where they are: what is changed are rows.
  void write_rows(const ObjectTable& table, const ListPart& part) {
    const std::vector<toml::Value> rows = rows_of(text_, *table.positions);
    const std::vector<RowChange> changes = row_changes_of(table, part, rows);
    changed_.back().rows.emplace();
    for (std::size_t row = 0; row < rows.size(); ++row)
      if (changes[row].text) changed_.back().rows->push_back({row, {rows[row].span.begin, rows[row].span.end}});
    append(changes_, change_rows(text_, *table.positions, changes));
  }

  // The same for one target with values of its own.
  [[nodiscard]] TextChanges changes_of_single(const ObjectTable& table, const ListPart& part) const {
    TextChanges changes = changes_of_keys(table, part);
    const ListedObject& object = part.objects.front();
    const toml::Value row = rows_of(text_, *table.positions)[object.row];
    const std::string position = new_row(object, row).value_or(std::string(toml::piece(text_, row.span)));
    const toml::Span line{table.positions_key.begin, table.positions->span.end};
    changes.push_back({line.begin, std::string(toml::piece(text_, line)), "position = " + position});
    return changes;
  }

  // The table as it was typed, but of a part of its rows.
  [[nodiscard]] std::string copy_of_part(const ObjectTable& table, const ListPart& part) const {
    const bool single = part.objects.size() == 1 && part.alike != nullptr;
    const TextStretch all = stretch_of(text_, tables_, table);
    TextChanges changes = single ? changes_of_single(table, part) : changes_of_part(table, part);
    sort_changes(changes);
    for (TextChange& change : changes) change.at -= all.begin;
    std::string copy = apply_changes(text_.substr(all.begin, all.end - all.begin), changes);
    return copy.ends_with('\n') ? copy : copy + "\n";
  }

  // ---- objects that come and go

  // New objects between two tables of their kind, either of which may be missing.
  void insert(ObjectKind kind, const ObjectTable* last, const ObjectTable* next, Listed objects) {
    if (last != nullptr) return add_block(stretch_of(text_, tables_, *last).end, written(kind, objects));
    if (next != nullptr) return add_block(lead_of(text_, tables_, *next), written(kind, objects));
    add_block(end_of_objects(), written(kind, objects));
  }

  // The end of the text, but before [options].
  [[nodiscard]] std::size_t end_of_objects() const {
    const bool options_last = tables_.options && tables_.options->last == tables_.document.tables.size();
    return options_last ? lead_of(text_, tables_, *tables_.options) : text_.size();
  }

  // Lines that begin with an empty one come to stand at the begin of a line, or at the end of the text.
  void add_block(std::size_t at, const std::string& lines) {
    alone_ = false;
    blocks_[at] += lines;
  }

  // Takes an object away, with the comments about it and the empty lines that would be too many.
  void remove(const ObjectTable& table) {
    alone_ = false;
    const std::size_t begin = lead_of(text_, tables_, table);
    std::size_t end = stretch_of(text_, tables_, table).end;
    if (blank_line_before(text_, begin))
      for (std::size_t next = behind_line(text_, end); next > end; next = behind_line(text_, end)) {
        if (text_.substr(end, next - end).find_first_not_of(" \t\r\n") != std::string_view::npos) break;
        end = next;
      }
    changes_.push_back({begin, std::string(text_.substr(begin, end - begin)), ""});
  }

  void write_options(const RunOptions& before, const RunOptions& after) {
    const TypedWords words = tables_.options ? words_of(std::nullopt, before, *tables_.options) : new_options_words();
    write_single(tables_.options, "options", said_of(before, words.before), said_of(after, words.after));
  }

  // Where the first of the objects stands, with the comments above it; the end of a text without any.
  [[nodiscard]] std::size_t begin_of_objects() const {
    std::size_t begin = text_.size();
    for (const std::vector<ObjectTable>& tables : tables_.of)
      if (!tables.empty()) begin = std::min(begin, lead_of(text_, tables_, tables.front()));
    for (const std::optional<ObjectTable>& table : {tables_.options, tables_.atmosphere})
      if (table) begin = std::min(begin, lead_of(text_, tables_, *table));
    return begin;
  }

  // A table that a text has once or not at all; a new one comes to stand at a place, or at the end.
  void write_single(const std::optional<ObjectTable>& table, const std::string& name, const std::vector<Said>& was,
                    const std::vector<Said>& becomes, std::optional<std::size_t> at = std::nullopt) {
    alone_ = false;
    if (!table) {
      if (becomes.empty()) return;
      std::string lines = "\n[" + name + "]\n";
      for (const Said& said : becomes) lines += lines_of(said, name);
      return add_block(at.value_or(text_.size()), lines);
    }
    if (would_be_empty(text_, tables_, *table, was, becomes)) return remove(*table);
    append(changes_, change_tables(text_, tables_, *table, name, was, becomes));
  }

  // Where the text has no table of them yet.
  [[nodiscard]] TypedWords new_options_words() const {
    TypedWords words;
    const auto [first, last] = typed_.equal_range(std::nullopt);
    for (auto entry = first; entry != last; ++entry) {
      const TypedText& typed = *entry->second;
      if (!typed.text.empty()) words.after.push_back({typed.field->spec, typed.field->part, typed.text});
    }
    return words;
  }

  // ---- changes

  static void append(TextChanges& changes, TextChanges more) { std::ranges::move(more, std::back_inserter(changes)); }

  static void sort_changes(TextChanges& changes) {
    std::ranges::stable_sort(changes, {},
                             [](const TextChange& change) { return std::pair(change.at, !change.before.empty()); });
  }

  // An empty line stands on either side of what comes in.
  [[nodiscard]] std::string spaced(std::size_t at, std::string lines) const {
    if (at > 0 && text_[at - 1] != '\n')
      lines.insert(0, "\n");
    else if (blank_line_before(text_, at))
      lines.erase(0, 1);
    const bool at_text = at < text_.size() && text_[at] != '\n' && text_[at] != '\r';
    return with_ends_of(text_, at_text ? lines + "\n" : lines);
  }

  TextChanges finish() {
    for (const auto& [at, lines] : blocks_) changes_.push_back({at, "", spaced(at, lines)});
    sort_changes(changes_);
    return std::move(changes_);
  }

  std::string_view text_;
  const ObjectTables& tables_;
  const ObjectCounts& preceding_;
  bool takes_new_;
  const Scene& before_;
  bool fine_;
  std::multimap<std::optional<ObjectId>, const TypedText*> typed_;
  std::array<bool, kind_count> touched_{};
  std::map<std::size_t, std::string> blocks_;  // what comes in, by where
  TextChanges changes_;
  std::vector<ChangedTable> changed_;
  bool alone_ = true;
};

std::vector<SplicedText> spliced_texts(std::string_view text, const ObjectTables& tables,
                                       const std::vector<IncludedText>& included, const Scene& before) {
  std::vector<SplicedText> texts;
  ObjectCounts preceding{};
  for (const IncludedText& file : included) {
    texts.push_back({file.name, file.text, &file.tables, preceding});
    const ObjectCounts own = counts_of(file.tables);
    for (std::size_t kind = 0; kind < kind_count; ++kind) preceding[kind] += own[kind];
  }
  const ObjectCounts own = counts_of(tables);
  for (const ObjectKind kind : all_object_kinds) {
    const auto at = static_cast<std::size_t>(kind);
    preceding[at] = count_of(before, kind) - std::min(own[at], count_of(before, kind));
  }
  texts.push_back({"", text, &tables, preceding});
  return texts;
}

}  // namespace

Format2Splice splice_format_2(std::string_view text, const ObjectTables& tables,
                              const std::vector<IncludedText>& included, const Scene& before, const Edit& edit,
                              const std::string& file, const DataFileLoader& loader) {
  Scene after = before;
  apply(edit, after);
  const auto scene_of = [&](const std::string& said) { return read_format_2(said, file, loader).scene; };
  const std::vector<SplicedText> all = spliced_texts(text, tables, included, before);
  Format2Splice splice;
  for (const bool fine : {true, false}) {
    Format2Splice tried;
    std::map<std::string, std::string> texts;
    for (const SplicedText& one : std::span(all).first(included.size())) {
      TextChanges changes = TableSplicer(one, before, fine).make(edit);
      if (changes.empty()) continue;
      texts[one.name] = apply_changes(one.text, changes);
      tried.included[one.name] = std::move(changes);
    }
    TableSplicer splicer(all.back(), before, fine);
    tried.changes = splicer.make(edit);
    tried.text = apply_changes(text, tried.changes);
    const std::vector<ChangedTable>* const alone = splicer.changed_alone();
    const bool right = edit.world_after ? scene_of(tried.text).world == after.world
                       : tried.included.empty() && alone != nullptr
                           ? tables_say(text, tables, tried.changes, *alone, after, file, loader)
                           : read_format_2(tried.text, file, with_texts(loader, std::move(texts))).scene == after;
    tried.rows_alone =
        tried.included.empty() && alone != nullptr &&
        std::ranges::all_of(*alone, [](const ChangedTable& changed) { return changed.rows.has_value(); });
    if (right || fine) splice = std::move(tried);
    if (right) return splice;
  }
  splice.included.clear();
  // What no text can say, a number that is none for example, is no reason to write all of it anew.
  std::string whole = write_format_2(after);
  splice.rows_alone = false;
  if (scene_of(whole) == scene_of(splice.text)) return splice;
  TextChanges changes = text_difference(text, whole);
  return {std::move(changes), std::move(whole), {}};
}

}  // namespace sarsim::scene
