#include "scene/check/check_names.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::scene {

NameCheck::NameCheck(std::string_view kind, std::vector<std::string_view> names)
    : kind_(kind), table_(std::make_shared<const NameTable>(std::move(names))) {}

NameTable::Result NameCheck::find(std::string_view name) {
  if (last_ && last_name_ == name) return *last_;
  last_name_ = name;
  auto known = known_.find(last_name_);
  if (known == known_.end()) known = known_.emplace(last_name_, table_->find(name)).first;
  last_ = known->second;
  return *last_;
}

void NameCheck::check_definitions(Findings& findings) const {
  for (std::size_t i = 0; i < table_->names().size(); ++i) {
    if (!table_->names()[i].empty()) continue;
    findings.about(kind_, i);
    findings.error("name", {.id = "name.none",
                            .message = fmt::format("the {} has no name", kind_),
                            .expected = "a name",
                            .hint = "Other objects refer to it by its name."});
  }
  for (const auto& [index, first] : table_->duplicates()) {
    if (table_->names()[index].empty()) continue;
    findings.about(kind_, index);
    findings.warning(Consequence::other_object, "name",
                     {.id = "name.not-unique",
                      .message = fmt::format("another {0} has the same name; the name means the first {0}", kind_),
                      .found = std::string(table_->names()[index]),
                      .expected = "a name of its own"});
  }
}

std::size_t NameCheck::resolve(Findings& findings, std::string_view field, std::string_view name) {
  const NameTable::Result result = find(name);
  if (result.match == NameTable::Match::exact) return result.index;
  if (result.match == NameTable::Match::prefix) {
    findings.warning(
        Consequence::other_object, field,
        {.id = "name.shortened",
         .message = fmt::format("no {} has exactly this name; the only one that begins like it is used", kind_),
         .found = std::string(name),
         .expected = std::string(table_->names()[result.index]),
         .hint = "Write the whole name."});
    return result.index;
  }
  // The world is there without being defined: it rests at the origin.
  if (kind_ == "platform" && core::equal_ignoring_case(name, "Earth")) return not_found;
  if (result.match == NameTable::Match::ambiguous) {
    findings.error(field, {.id = "name.ambiguous",
                           .message = fmt::format("several {}s begin like this name", kind_),
                           .found = std::string(name),
                           .expected = fmt::format("one of {}", table_->candidates(name)),
                           .hint = "Write the whole name."});
    return not_found;
  }
  report_unknown(findings, field, name);
  return not_found;
}

// Those of the scene, and the world, which is always there.
std::vector<std::string_view> NameCheck::candidates() const {
  std::vector<std::string_view> names = table_->names();
  if (kind_ == "platform" && std::ranges::find(names, "Earth") == names.end()) names.emplace_back("Earth");
  return names;
}

// The names that can be given, or the first few of them.
std::string NameCheck::expected_name() const {
  constexpr std::size_t max_listed = 8;
  std::string text;
  std::size_t listed = 0;
  for (const std::string_view name : candidates()) {
    if (name.empty() || name.size() > 60) continue;
    if (++listed > max_listed) break;
    text += fmt::format("{}{}", listed > 1 ? ", " : "", name);
  }
  if (listed == 0) return fmt::format("the name of a {}", kind_);
  return fmt::format("the name of a {}: {}{}", kind_, text, listed > max_listed ? ", ..." : "");
}

void NameCheck::report_unknown(Findings& findings, std::string_view field, std::string_view name) const {
  const std::string nearest = core::nearest_word(name, candidates());
  std::string hint;
  if (!nearest.empty())
    hint = fmt::format("Did you mean {}?", nearest);
  else if (table_->names().empty())
    hint = fmt::format("The scene defines no {}.", kind_);
  findings.error(field, {.id = "name.unknown",
                         .message = fmt::format("no {} has this name", kind_),
                         .found = std::string(name),
                         .expected = expected_name(),
                         .hint = std::move(hint)});
}

}  // namespace sarsim::scene
