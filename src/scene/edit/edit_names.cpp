#include "scene/edit/edit_names.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

bool is_taken(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](const std::string& other) { return core::equal_ignoring_case(other, name); });
}

std::string first_free(const std::vector<std::string>& taken, std::string beginning, const std::string& ending) {
  beginning.erase(beginning.find_last_not_of("0123456789") + 1);
  for (std::size_t number = 2;; ++number) {
    std::string name = fmt::format("{}{}{}", beginning, number, ending);
    if (!is_taken(taken, name)) return name;
  }
}

// The named objects of one kind before and after an edit, without anything but their names.
struct Names {
  Scene before;
  Scene after;
  std::vector<std::size_t> place_after;  // of each object before; not_found where it was removed
};

Scene only_names(const Scene& scene, ObjectKind kind) {
  Scene names;
  for (const std::string& name : names_of(scene, kind)) {
    if (kind == ObjectKind::platform)
      names.platforms.emplace_back().name = name;
    else
      names.radars.emplace_back().name = name;
  }
  return names;
}

// Only the name counts here, and what a scene says of the rest need not fit.
AnyObject only_name(ObjectKind kind, AnyObject object) {
  const std::string name = *name_in(object);
  AnyObject bare = kind == ObjectKind::platform ? AnyObject(Platform{}) : AnyObject(Radar{});
  *name_in(bare) = name;
  return bare;
}

Names names_around(const Scene& scene, const Edit& edit, ObjectKind kind) {
  Names names{only_names(scene, kind), {}, {}};
  Edit renaming;
  for (const ObjectChange& change : edit.changes) {
    if (change.id.kind != kind) continue;
    ObjectChange bare{change.id, {}, {}};
    if (change.before) bare.before = only_name(kind, *change.before);
    if (change.after) bare.after = only_name(kind, *change.after);
    renaming.changes.push_back(std::move(bare));
  }
  names.after = names.before;
  apply(renaming, names.after);
  for (std::size_t i = 0; i < count_of(scene, kind); ++i) {
    const std::optional<ObjectId> place = moved({kind, i}, renaming);
    names.place_after.push_back(place ? place->index : not_found);
  }
  return names;
}

std::size_t find_named(const Scene& names, ObjectKind kind, const std::string& name) {
  return kind == ObjectKind::platform ? find_platform(names, name) : find_radar(names, name);
}

// The name by which an object is meant after the edit that was meant by `name` before.
std::string name_after(const Names& names, ObjectKind kind, const std::string& name) {
  const std::size_t meant = find_named(names.before, kind, name);
  if (meant == not_found || names.place_after[meant] == not_found) return name;
  const std::size_t place = names.place_after[meant];
  if (find_named(names.after, kind, name) == place) return name;
  std::string whole = kind == ObjectKind::platform ? names.after.platforms[place].name : names.after.radars[place].name;
  return find_named(names.after, kind, whole) == place ? whole : name;
}

template <class Object>
void keep_in_list(const std::vector<Object>& list, ObjectKind kind, const Names& names,
                  const std::set<ObjectId>& touched, Edit& edit) {
  std::unordered_map<std::string, std::string> known;  // scenes name one platform a million times
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (touched.contains({kind, i})) continue;
    const std::string& name = *carrier_in(list[i]);
    const auto [entry, is_new] = known.try_emplace(name);
    if (is_new) entry->second = name_after(names, carrier_kind(kind), name);
    if (entry->second == name) continue;
    Object after = list[i];
    set_carrier(after, entry->second);
    edit.changes.push_back({{kind, i}, list[i], std::move(after)});
  }
}

}  // namespace

std::vector<std::string> names_of(const Scene& scene, ObjectKind kind) {
  std::vector<std::string> names;
  visit_list(scene, kind, [&]<class Object>(const std::vector<Object>& list) {
    if constexpr (Kind<Object>::is_named)
      for (const Object& object : list) names.push_back(object.name);
  });
  return names;
}

std::string free_name(const std::vector<std::string>& taken, const std::string& wanted) {
  if (!is_taken(taken, wanted)) return wanted;
  return first_free(taken, core::equal_ignoring_case(wanted, Platform{}.name) ? "Platform" : wanted, "");
}

std::string free_file_name(const std::vector<std::string>& taken, const std::string& wanted) {
  if (!is_taken(taken, wanted)) return wanted;
  const std::size_t name = wanted.find_last_of("/\\") + 1;  // npos + 1 is the beginning
  const std::size_t point = wanted.find_last_of('.');
  const std::size_t ending = point == std::string::npos || point <= name ? wanted.size() : point;
  return first_free(taken, wanted.substr(0, ending), wanted.substr(ending));
}

std::vector<std::string> file_names_of(const Scene& scene) {
  std::vector<std::string> files;
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if constexpr (Kind<Object>::belongs_to_radar)
      for (const Object& object : scene.*kind.list) files.push_back(object.file);
  });
  return files;
}

void keep_references(const Scene& scene, Edit& edit) {
  std::set<ObjectId> touched;
  bool of_named = false;
  for (const ObjectChange& change : edit.changes) {
    if (change.before) touched.insert(change.id);
    of_named = of_named || is_named(change.id.kind);
  }
  if (!of_named) return;
  const Names platforms = names_around(scene, edit, ObjectKind::platform);
  const Names radars = names_around(scene, edit, ObjectKind::radar);
  const bool other_platforms = !(platforms.before == platforms.after);
  const bool other_radars = !(radars.before == radars.after);
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if constexpr (Kind<Object>::stands_on_platform) {
      if (other_platforms) keep_in_list(scene.*kind.list, kind.kind, platforms, touched, edit);
    } else if constexpr (Kind<Object>::belongs_to_radar) {
      if (other_radars) keep_in_list(scene.*kind.list, kind.kind, radars, touched, edit);
    }
  });
}

}  // namespace sarsim::scene
