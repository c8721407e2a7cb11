#include "scene/edit/included_texts.hpp"

#include <utility>

#include "scene/language/json_text.hpp"
#include "scene/language/sources.hpp"

namespace sarsim::scene {

std::vector<IncludedText> included_texts(std::string_view text, const std::string& file, const DataFileLoader& loader) {
  std::vector<IncludedText> included;
  if (text.find("include") == std::string_view::npos || language::is_json(text)) return included;
  language::Reading reading{script::ProblemLog(1), {}, loader, {}};
  language::Sources sources;
  language::take_apart(text, file, reading, sources);
  for (const language::Source& source : sources.sources) {
    if (source.name.empty()) continue;
    std::string typed(source.typed);
    format_2::ObjectTables tables;
    if (!language::is_json(typed)) tables = format_2::find_tables(typed);
    included.push_back({source.name, std::move(typed), std::move(tables)});
  }
  return included;
}

ObjectCounts counts_of(const format_2::ObjectTables& tables) {
  ObjectCounts counts{};
  for (std::size_t kind = 0; kind < kind_count; ++kind)
    for (const format_2::ObjectTable& table : tables.of[kind]) counts[kind] += table.objects;
  return counts;
}

DataFileLoader with_texts(DataFileLoader loader, std::map<std::string, std::string> texts) {
  return [loader = std::move(loader), texts = std::move(texts)](const std::string& name) {
    DataFileText found = loader ? loader(name) : DataFileText{};
    const auto text = texts.find(name);
    if (text == texts.end()) return found;
    return DataFileText{found.path.empty() ? name : found.path, text->second, {}};
  };
}

}  // namespace sarsim::scene
