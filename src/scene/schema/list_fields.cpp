#include "scene/schema/list_fields.hpp"

#include <iterator>

#include "scene/schema/form.hpp"

namespace sarsim::scene {

namespace {

using field_forms::form_of;

constexpr double new_length_m = 1000.0;

[[noreturn]] void throw_no_list(const Field& list) {
  throw std::invalid_argument("the field '" + list.id + "' is not a list of the object");
}

// Calls `visit` with the vector that a field of an object is.
template <class Visit>
decltype(auto) visit_list_field(AnyObject& object, const Field& list, const Visit& visit) {
  void* const found = std::visit(
      [&]<class Object>(Object& of) -> void* {
        for (const FieldOf<Object>& field : table_of<Object>().fields())
          if (&field.spec == list.spec && field.list != nullptr) return field.list(of);
        return nullptr;
      },
      object);
  if (found == nullptr) throw_no_list(list);
  return visit_elements(list.spec->list, found, visit);
}

template <class Visit>
decltype(auto) visit_list_field(const AnyObject& object, const Field& list, const Visit& visit) {
  const void* const found = std::visit(
      [&]<class Object>(const Object& of) -> const void* {
        for (const FieldOf<Object>& field : table_of<Object>().fields())
          if (&field.spec == list.spec && field.list != nullptr) return std::get<ConstListRef>(field.get(of)).list;
        return nullptr;
      },
      object);
  if (found == nullptr) throw_no_list(list);
  return visit_elements(list.spec->list, found, visit);
}

Leg new_entry(const std::vector<Leg>&, std::size_t) {
  Leg leg;
  leg.length_m = new_length_m;
  return leg;
}

// What continues the way behind the last waypoint, or before the first one.
core::Vec3 beyond(const core::Vec3& end, const core::Vec3& neighbour) { return end + (end - neighbour); }

Waypoint new_entry(const std::vector<Waypoint>& points, std::size_t at) {
  const std::size_t count = points.size();
  const auto place = [&](std::size_t i) { return points[i].position_m; };
  if (count == 0) return {};
  if (at > 0 && at < count) return {0.5 * (place(at - 1) + place(at))};
  if (count == 1) return {place(0) + core::Vec3{0.0, at == 0 ? -new_length_m : new_length_m, 0.0}};
  return at == 0 ? Waypoint{beyond(place(0), place(1))} : Waypoint{beyond(place(count - 1), place(count - 2))};
}

Oscillation new_entry(const std::vector<Oscillation>&, std::size_t) {
  Oscillation made;
  made.amplitude_m = 0.1;
  made.frequency_hz = 1.0;
  return made;
}

}  // namespace

const std::vector<Field>& entry_fields(const Field& list) {
  if (list.kind != FieldKind::list) throw_no_list(list);
  switch (list.spec->list) {
    case ListKind::legs: return form_of(Leg{}).fields();
    case ListKind::waypoints: return form_of(Waypoint{}).fields();
    case ListKind::sines: return form_of(Oscillation{}).fields();
    case ListKind::none: break;
  }
  throw_no_list(list);
}

std::size_t entry_count(const AnyObject& object, const Field& list) {
  return visit_list_field(object, list, [](const auto& entries) { return entries.size(); });
}

std::optional<std::string> entry_text(const AnyObject& object, const Field& list, std::size_t entry,
                                      std::string_view id) {
  return visit_list_field(object, list, [&](const auto& entries) -> std::optional<std::string> {
    const auto& of = entries.at(entry);
    if (!form_of(of).applies(of, id)) return std::nullopt;
    return form_of(of).text(of, id);
  });
}

std::string set_entry(AnyObject& object, const Field& list, std::size_t entry, std::string_view id,
                      std::string_view text, const LetNames* names) {
  return visit_list_field(object, list, [&](auto& entries) {
    auto& of = entries.at(entry);
    return form_of(of).set(of, id, text, names);
  });
}

void add_entry(AnyObject& object, const Field& list, std::size_t at) {
  visit_list_field(object, list, [&](auto& entries) {
    if (at > entries.size()) throw std::out_of_range("no place in a list for a new entry");
    entries.insert(std::next(entries.begin(), static_cast<std::ptrdiff_t>(at)), new_entry(entries, at));
  });
}

void remove_entry(AnyObject& object, const Field& list, std::size_t entry) {
  visit_list_field(object, list, [&](auto& entries) {
    static_cast<void>(entries.at(entry));
    entries.erase(std::next(entries.begin(), static_cast<std::ptrdiff_t>(entry)));
  });
}

void move_entry(AnyObject& object, const Field& list, std::size_t entry, std::size_t to) {
  visit_list_field(object, list, [&](auto& entries) {
    auto moved = entries.at(entry);
    static_cast<void>(entries.at(to));
    entries.erase(std::next(entries.begin(), static_cast<std::ptrdiff_t>(entry)));
    entries.insert(std::next(entries.begin(), static_cast<std::ptrdiff_t>(to)), std::move(moved));
  });
}

}  // namespace sarsim::scene
