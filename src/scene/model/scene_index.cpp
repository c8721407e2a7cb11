#include "scene/model/scene_index.hpp"

#include <algorithm>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::scene {

namespace {

template <class Object>
std::vector<std::string_view> views_of_names(const std::vector<Object>& objects) {
  std::vector<std::string_view> names;
  names.reserve(objects.size());
  for (const Object& object : objects) names.emplace_back(object.name);
  return names;
}

}  // namespace

bool share_prefix(std::string_view a, std::string_view b) {
  const std::size_t shared = std::min(a.size(), b.size());
  return shared > 0 && core::equal_ignoring_case(a.substr(0, shared), b.substr(0, shared));
}

NameTable::NameTable(std::vector<std::string_view> names) : names_(std::move(names)) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto [first, is_new] = first_.try_emplace(core::lower_case(names_[i]), i);
    if (!is_new) duplicates_.emplace_back(i, first->second);
  }
}

NameTable::Result NameTable::find(std::string_view name) const {
  if (const auto exact = first_.find(core::lower_case(name)); exact != first_.end())
    return {Match::exact, exact->second};
  Result result;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!share_prefix(names_[i], name)) continue;
    if (result.match == Match::prefix) return {Match::ambiguous, not_found};
    result = {Match::prefix, i};
  }
  return result;
}

std::string NameTable::candidates(std::string_view name) const {
  std::string text;
  for (const std::string_view candidate : names_) {
    if (!share_prefix(candidate, name)) continue;
    if (!text.empty()) text += ", ";
    text += candidate;
  }
  return text;
}

SceneIndex::SceneIndex(const Scene& scene)
    : platforms_(views_of_names(scene.platforms), true), radars_(views_of_names(scene.radars), false) {}

std::size_t SceneIndex::Names::find(std::string_view name) {
  if (last_ != nullptr && last_->first == name) return last_->second;
  const auto [entry, is_new] = known_.try_emplace(std::string(name), not_found);
  if (is_new) entry->second = look_up(name);
  last_ = &*entry;
  return entry->second;
}

std::size_t SceneIndex::Names::look_up(std::string_view name) const {
  const NameTable::Result found = table_.find(name);
  // "Earth" is the world itself, not short for a platform "Earth2".
  const bool short_for_other = found.match == NameTable::Match::prefix && with_world_;
  return short_for_other && core::equal_ignoring_case(name, "Earth") ? not_found : found.index;
}

}  // namespace sarsim::scene
