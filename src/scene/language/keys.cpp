#include "scene/language/keys.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene::language {

namespace {

std::vector<std::string> paths_of_field(const FieldSpec& spec) {
  const std::string key(spec.key.substr(0, spec.key.find('[')));
  std::vector<std::string> paths;
  if (spec.block == nullptr) {
    paths.push_back(key);
    if (!spec.other_key.key.empty()) paths.emplace_back(spec.other_key.key);
    if (spec.type == FieldType::choice && has_words(spec)) paths.push_back(key + ".type");
    return paths;
  }
  for (std::size_t part = 0; part < spec.block->count; ++part) {
    const std::string below = spec.block->count == 1 ? key : key + "." + part_key(*spec.block, part);
    paths.push_back(fmt::format("{}.{}", below, points_key(*spec.block)));
    paths.push_back(below + ".interpolation");
  }
  paths.push_back(key + ".file");
  return paths;
}

template <class Object>
void add_paths(std::vector<std::string>& paths) {
  for (const FieldOf<Object>& field : table_of<Object>().fields())
    for (std::string& path : paths_of_field(field.spec))
      if (std::ranges::find(paths, path) == paths.end()) paths.push_back(std::move(path));
}

template <class Object>
std::string owner_in(const FieldTable<Object>& table, std::string_view path) {
  for (const FieldOf<Object>& field : table.fields()) {
    if (field.spec.when.among.empty()) continue;
    const std::vector<std::string> paths = paths_of_field(field.spec);
    if (std::ranges::find(paths, path) == paths.end()) continue;
    const FieldSpec& choice = table.fields()[field.spec.when.field].spec;
    const OtherKey& other = field.spec.other_key;
    std::string types;
    for (const Choice& alternative : choice.choices)
      if ((other.key.empty() || (alternative.value == other.alternative) == (path == other.key)) &&
          std::ranges::find(field.spec.when.among, alternative.value) != field.spec.when.among.end() &&
          types.find(type_word(alternative)) == std::string::npos)
        types += (types.empty() ? "" : " or ") + type_word(alternative);
    return choice.type == FieldType::check ? fmt::format("a {} of its own", choice.key)
                                           : fmt::format("{} of type {}", choice.key, types);
  }
  return {};
}

}  // namespace

std::string_view header_of(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::simulation: return "recording";
    case ObjectKind::cloud: return "target";  // with `positions` in a file
    default: return name_of(kind);
  }
}

std::string part_key(const FunctionBlock& block, std::size_t part) {
  const std::string_view name = block.y[part].name;
  return core::lower_case(name.substr(name.rfind(' ') + 1));  // npos + 1 is 0.
}

std::string_view points_key(const FunctionBlock& block) {
  return block.list_key.empty() ? std::string_view("points") : block.list_key;
}

std::string_view interpolation_word(core::Interpolation method) {
  switch (method) {
    case core::Interpolation::linear: return "linear";
    case core::Interpolation::cubic: return "cubic";
    case core::Interpolation::low_pass: return "low-pass";
  }
  return {};
}

Quantity quantity_of(const FunctionAxis& axis) {
  static constexpr std::array<std::pair<std::string_view, Quantity>, 6> known{{{"s", Quantity::time},
                                                                               {"m", Quantity::length},
                                                                               {"deg", Quantity::angle},
                                                                               {"dB", Quantity::ratio_db},
                                                                               {"GHz", Quantity::frequency},
                                                                               {"V", Quantity::voltage}}};
  const auto found = std::ranges::find(known, axis.unit, &std::pair<std::string_view, Quantity>::first);
  return found == known.end() ? Quantity::number : found->second;
}

const std::vector<std::string>& paths_of(ObjectKind kind) {
  static const auto all = [] {
    std::array<std::vector<std::string>, kind_count> made;
    for_each_kind(
        [&]<class Object>(const Kind<Object>& of) { add_paths<Object>(made[static_cast<std::size_t>(of.kind)]); });
    made[static_cast<std::size_t>(ObjectKind::target)].emplace_back("positions");
    made[static_cast<std::size_t>(ObjectKind::platform)].emplace_back("path.start");
    made[static_cast<std::size_t>(ObjectKind::platform)].emplace_back("path.velocity");
    return made;
  }();
  return all[static_cast<std::size_t>(kind)];
}

std::string owner_of(ObjectKind kind, std::string_view path) {
  if (kind == ObjectKind::platform && (path == "path.start" || path == "path.velocity")) return "path of type line";
  return visit_kind(kind, [&](const auto& of) { return owner_in(table_of(of), path); });
}

}  // namespace sarsim::scene::language
