#include "scene/edit/splice_check.hpp"

#include <algorithm>

#include "scene/language/scene_reader.hpp"

namespace sarsim::scene::format_2 {

namespace {

// Expressions need the names, and places on the Earth the world.
bool is_read_with_all(std::string_view table) {
  return table == "let" || table == "world" || table.starts_with("world.");
}

// What must be read to read some tables: the beginning of the text, its names and its world, and the tables.
std::vector<TextStretch> stretches_to_read(std::string_view text, const ObjectTables& tables,
                                           const std::vector<ChangedTable>& changed) {
  const std::vector<core::toml::Table>& all = tables.document.tables;
  std::vector<TextStretch> stretches{{0, all.size() > 1 ? all[1].header.begin : text.size()}};
  for (std::size_t i = 1; i < all.size(); ++i)
    if (is_read_with_all(core::toml::piece(text, all[i].name)))
      stretches.push_back(stretch_of(text, tables, {i, i + 1}));
  for (const ChangedTable& table : changed) stretches.push_back(stretch_of(text, tables, *table.table));
  std::ranges::sort(stretches, {}, &TextStretch::begin);
  return stretches;
}

// The stretches after the changes; empty where a change stands outside of them.
std::string changed_stretches(std::string_view text, const std::vector<TextStretch>& stretches,
                              const TextChanges& changes) {
  std::string result;
  auto change = changes.begin();
  for (const TextStretch at : stretches) {
    TextChanges within;
    for (; change != changes.end() && change->at + change->before.size() <= at.end; ++change) {
      if (change->at < at.begin) return {};
      within.push_back(*change);
      within.back().at -= at.begin;
    }
    result += apply_changes(text.substr(at.begin, at.end - at.begin), within);
    if (!result.ends_with('\n')) result += '\n';
  }
  return change == changes.end() ? result : std::string();
}

// Whether the last objects of one list are those of the changed tables in another.
template <class Object>
bool lists_agree(const std::vector<Object>& read, const std::vector<Object>& after, ObjectKind kind,
                 const std::vector<ChangedTable>& changed) {
  std::size_t count = 0;
  for (const ChangedTable& table : changed) count += table.kind == kind ? table.count : 0;
  if (read.size() < count) return false;
  auto object = read.end() - static_cast<std::ptrdiff_t>(count);
  for (const ChangedTable& table : changed)
    for (std::size_t i = 0; table.kind == kind && i < table.count; ++i)
      if (!(*object++ == after[table.first + i])) return false;
  return true;
}

}  // namespace

bool tables_say(std::string_view text, const ObjectTables& tables, const TextChanges& changes,
                const std::vector<ChangedTable>& changed, const Scene& after, const std::string& file,
                const DataFileLoader& loader) {
  const std::string alone = changed_stretches(text, stretches_to_read(text, tables, changed), changes);
  if (alone.empty()) return false;
  const Scene read = read_format_2(alone, file, loader).scene;
  return std::ranges::all_of(all_object_kinds, [&](ObjectKind kind) {
    return visit_kind(kind, [&](const auto& of) { return lists_agree(read.*of.list, after.*of.list, kind, changed); });
  });
}

}  // namespace sarsim::scene::format_2
