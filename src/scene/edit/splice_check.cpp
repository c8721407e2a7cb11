#include "scene/edit/splice_check.hpp"

#include <algorithm>

#include "scene/language/scene_reader.hpp"

namespace sarsim::scene::format_2 {

namespace {

// Expressions need the names, and places on the Earth the world.
bool is_read_with_all(std::string_view table) {
  return table == "let" || table == "world" || table.starts_with("world.");
}

// A stretch of the text, and what stands behind it where only stretches are read.
struct ReadStretch {
  TextStretch at;
  char behind = '\n';
};

// A table; of one in which only rows of its list are changed the other rows are left out.
void add_changed(std::vector<ReadStretch>& stretches, std::string_view text, const ObjectTables& tables,
                 const ChangedTable& changed) {
  const TextStretch all = stretch_of(text, tables, *changed.table);
  if (!changed.rows) {
    stretches.push_back({all});
    return;
  }
  const core::toml::Span list = changed.table->positions->span;
  stretches.push_back({{all.begin, list.begin + 1}});
  for (const ChangedRow& row : *changed.rows) stretches.push_back({row.at, ','});
  stretches.push_back({{list.end - 1, all.end}});
}

// What must be read to read some tables: the beginning of the text, its names and its world, and the tables.
std::vector<ReadStretch> stretches_to_read(std::string_view text, const ObjectTables& tables,
                                           const std::vector<ChangedTable>& changed) {
  const std::vector<core::toml::Table>& all = tables.document.tables;
  std::vector<ReadStretch> stretches{{{0, all.size() > 1 ? all[1].header.begin : text.size()}}};
  for (std::size_t i = 1; i < all.size(); ++i)
    if (is_read_with_all(core::toml::piece(text, all[i].name)))
      stretches.push_back({stretch_of(text, tables, {i, i + 1})});
  for (const ChangedTable& table : changed) add_changed(stretches, text, tables, table);
  std::ranges::sort(stretches, {}, [](const ReadStretch& stretch) { return stretch.at.begin; });
  return stretches;
}

// The stretches after the changes; empty where a change stands outside of them.
std::string changed_stretches(std::string_view text, const std::vector<ReadStretch>& stretches,
                              const TextChanges& changes) {
  std::string result;
  auto change = changes.begin();
  for (const auto& [at, behind] : stretches) {
    TextChanges within;
    for (; change != changes.end() && change->at + change->before.size() <= at.end; ++change) {
      if (change->at < at.begin) return {};
      within.push_back(*change);
      within.back().at -= at.begin;
    }
    result += apply_changes(text.substr(at.begin, at.end - at.begin), within);
    if (!result.ends_with(behind)) result += behind;
  }
  return change == changes.end() ? result : std::string();
}

// Whether the last objects of one list are those of the changed tables in another.
template <class Object>
bool lists_agree(const std::vector<Object>& read, const std::vector<Object>& after, ObjectKind kind,
                 const std::vector<ChangedTable>& changed) {
  std::size_t count = 0;
  for (const ChangedTable& table : changed)
    if (table.kind == kind) count += table.rows ? table.rows->size() : table.count;
  if (read.size() < count) return false;
  auto object = read.end() - static_cast<std::ptrdiff_t>(count);
  for (const ChangedTable& table : changed) {
    if (table.kind != kind) continue;
    const std::size_t own = table.rows ? table.rows->size() : table.count;
    for (std::size_t i = 0; i < own; ++i)
      if (!(*object++ == after[table.first + (table.rows ? (*table.rows)[i].object : i)])) return false;
  }
  return true;
}

}  // namespace

bool tables_say(std::string_view text, const ObjectTables& tables, const TextChanges& changes,
                const std::vector<ChangedTable>& changed, const Scene& after, const std::string& file,
                const DataFileLoader& loader) {
  const std::vector<ReadStretch> stretches = stretches_to_read(text, tables, changed);
  const std::string alone = changed_stretches(text, stretches, changes);
  if (alone.empty()) return false;
  const Scene read = read_format_2(alone, file, loader).scene;
  // A row alone does not show that it has become two.
  if (std::ranges::any_of(changed, [](const ChangedTable& table) { return table.rows.has_value(); })) {
    const Scene before = read_format_2(changed_stretches(text, stretches, {}), file, loader).scene;
    if (before.targets.size() != read.targets.size()) return false;
  }
  return std::ranges::all_of(all_object_kinds, [&](ObjectKind kind) {
    return visit_kind(kind, [&](const auto& of) { return lists_agree(read.*of.list, after.*of.list, kind, changed); });
  });
}

}  // namespace sarsim::scene::format_2
