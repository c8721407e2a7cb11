#include "scene/model/scene_index.hpp"

#include <algorithm>

#include <fmt/format.h>

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

NameTable::NameTable(std::vector<std::string_view> names) : names_(std::move(names)) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto [first, is_new] = first_.try_emplace(core::lower_case(names_[i]), i);
    if (is_new) {
      lengths_.insert(names_[i].size());
    } else {
      duplicates_.emplace_back(i, first->second);
      repeated_.insert(first->second);
    }
  }
}

NameTable::Result NameTable::find(std::string_view name) const {
  if (const auto exact = first_.find(core::lower_case(name)); exact != first_.end())
    return {Match::exact, exact->second};
  const std::vector<std::size_t> alike = sharing_prefix(name, 2);
  if (alike.empty()) return {};
  const bool only_one = alike.size() == 1 && !repeated_.contains(alike.front());
  return only_one ? Result{Match::prefix, alike.front()} : Result{Match::ambiguous, not_found};
}

// The first so many of the names that begin like this one, or like which it begins, in the order of their definitions.
std::vector<std::size_t> NameTable::sharing_prefix(std::string_view name, std::size_t most) const {
  std::vector<std::size_t> found;
  if (name.empty()) return found;
  const std::string whole = core::lower_case(name);
  for (const std::size_t length : lengths_) {
    if (length >= whole.size() || found.size() == most) break;
    if (length == 0) continue;
    if (const auto shorter = first_.find(std::string_view(whole).substr(0, length)); shorter != first_.end())
      found.push_back(shorter->second);
  }
  for (auto longer = first_.lower_bound(whole); longer != first_.end() && found.size() < most; ++longer) {
    if (!longer->first.starts_with(whole)) break;
    found.push_back(longer->second);
  }
  std::ranges::sort(found);
  return found;
}

std::string NameTable::candidates(std::string_view name) const {
  constexpr std::size_t max_listed = 8;
  const std::vector<std::size_t> alike = sharing_prefix(name, max_listed + 1);
  std::string text;
  for (std::size_t i = 0; i < std::min(alike.size(), max_listed); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", names_[alike[i]]);
  return alike.size() > max_listed ? text + ", ..." : text;
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
