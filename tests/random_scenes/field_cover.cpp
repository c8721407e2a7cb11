#include "random_scenes/field_cover.hpp"

#include <sstream>

#include "random_scenes/scene_maker.hpp"
#include "scene/model/object.hpp"
#include "scene/script/order.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::test {

namespace {

// The most values of a field that are worth remembering.
constexpr std::size_t enough = 50;

std::string word_at(const std::vector<std::string>& lines, const core::Place& place) {
  if (place.line == 0 || place.line > lines.size() || place.column == 0) return {};
  const std::string& line = lines[place.line - 1];
  const std::size_t begin = std::min(place.column - 1, line.size());
  if (begin < line.size() && line[begin] == '"') return line.substr(begin, line.find('"', begin + 1) - begin);
  return line.substr(begin, line.find_first_of(" ,\t!", begin) - begin);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t objects_of(const scene::Scene& scene, const std::string& kind) {
  std::size_t count = 1;  // $OPTIONS
  scene::for_each_kind([&](const auto& of) {
    if (of.name == kind) count = (scene.*of.list).size();
  });
  return count;
}

}  // namespace

FieldCover::FieldCover() {
  const auto add = [this]<class Object>(const std::string& kind, const scene::FieldTable<Object>& table) {
    for (const scene::FieldOf<Object>& field : table.fields()) {
      if (field.spec.since_2) continue;  // A script has no such field.
      values_[{kind, std::string(field.spec.problem_place())}];
      for (const scene::Choice& choice : field.spec.choices)
        if (!choice.word.empty()) keywords_[{kind, std::string(choice.word)}] = 0;
    }
  };
  scene::for_each_kind([&](const auto& kind) {
    // Clouds stand in files of their own, which workflow/input/cloud_input_test.cpp makes.
    if (kind.kind != scene::ObjectKind::cloud) add(std::string(kind.name), scene::table_of(kind));
  });
  add("options", scene::table_of<scene::RunOptions>());
  for (const auto& option : scene::table_of<scene::RunOptions>().fields())
    keywords_[{"options", scene::script::option_key(option.spec)}] = 0;
  keywords_[{"radar", std::string(scene::script::stc_switch)}] = 0;
  for (const scene::FunctionBlock* block : scene::function_blocks::all) {
    for (const auto& method : scene::script::interpolations)
      blocks_[std::string(block->words) + " by " + std::string(method.word)] = 0;
    blocks_[std::string(block->words) + " INLINE"] = 0;
    blocks_[std::string(block->words) + " in a FILE"] = 0;
  }
}

void FieldCover::note(const scene::Scene& scene) {
  const std::string text = scene::write_script(scene);
  note_fields(scene, text);
  note_fields(scene, spelled_otherwise(text));
  note_keywords(text);
  note_keywords(spelled_otherwise(text));
  note_blocks(scene);
}

// A member of a member that a script leaves out has the place of what is in front of its '.'.
void FieldCover::note_fields(const scene::Scene& scene, const std::string& text) {
  const scene::ScriptReading reading = scene::read_script(text, "scene.scr", loader_of(scene));
  const std::vector<std::string> lines = lines_of(text);
  for (auto& [field, seen] : values_)
    for (std::size_t i = 0; i < objects_of(reading.scene, field.first) && seen.size() < enough; ++i) {
      const core::Place place = reading.places.find({field.first, i, field.second});
      const std::size_t dot = field.second.find('.');
      const std::string owner = dot == std::string::npos ? "" : field.second.substr(0, dot);
      if (place == core::Place{} || place == reading.places.find({field.first, i, owner})) continue;
      if (const std::string word = word_at(lines, place); !word.empty()) seen.insert(word);
    }
}

void FieldCover::note_keywords(const std::string& text) {
  std::string kind;
  for (const std::string& line : lines_of(text)) {
    std::istringstream words(line.substr(0, line.find('!')));
    for (std::string word; words >> word;) {
      for (char& c : word)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
      if (word.front() == '$') {
        kind.clear();
        for (const char c : word.substr(1)) kind += static_cast<char>(c - 'A' + 'a');
      } else if (const auto known = keywords_.find({kind, word}); known != keywords_.end()) {
        ++known->second;
      }
    }
  }
}

void FieldCover::note_blocks(const scene::Scene& scene) {
  visit_functions(scene, [&](const scene::FunctionBlock& block, std::span<const core::SampledFunction> parts,
                             const std::string& file) {
    const std::string words(block.words);
    bool used = false;
    for (const core::SampledFunction& part : parts) {
      if (part.knots.empty()) continue;
      used = true;
      for (const auto& method : scene::script::interpolations)
        if (method.value == part.method) ++blocks_.at(words + " by " + std::string(method.word));
    }
    if (used) ++blocks_.at(words + (file.empty() ? " INLINE" : " in a FILE"));
  });
}

std::vector<std::string> FieldCover::missing() const {
  std::vector<std::string> names;
  for (const auto& [field, seen] : values_)
    if (seen.size() < 2) names.push_back(field.first + "." + field.second);
  for (const auto& [keyword, times] : keywords_)
    if (times == 0) names.push_back(keyword.first + " " + keyword.second);
  for (const auto& [block, times] : blocks_)
    if (times == 0) names.push_back(block);
  return names;
}

}  // namespace sarsim::test
