#include "scene/language/recorded_text.hpp"

#include <algorithm>
#include <variant>

#include "scene/language/scene_writer.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace {

// The fields of a kind that may say what no script can.
template <class Object>
std::vector<const FieldOf<Object>*> newer_fields() {
  std::vector<const FieldOf<Object>*> fields;
  for (const FieldOf<Object>& field : table_of<Object>().fields())
    if (field.spec.since_2 || std::ranges::any_of(field.spec.choices, &Choice::since_2)) fields.push_back(&field);
  return fields;
}

template <class Object>
bool says_newer(const Object& object, const FieldOf<Object>& field) {
  static const Object initial{};
  if (!table_of<Object>().applies(object, field)) return false;
  const FieldValue value = field.get(object);
  if (field.spec.since_2) return !(value == field.get(initial));
  return chosen_word(field.spec, value) == nullptr;
}

template <class Object>
bool all_fit(const std::vector<Object>& objects) {
  static const auto newer = newer_fields<Object>();
  return newer.empty() || std::ranges::none_of(objects, [](const Object& object) {
           return std::ranges::any_of(newer, [&](const auto* field) { return says_newer(object, *field); });
         });
}

}  // namespace

bool fits_script(const AnyObject& object) {
  return std::visit([](const auto& one) { return all_fit(std::vector{one}); }, object);
}

bool fits_script(const Scene& scene) {
  bool fits = true;
  for_each_kind([&](const auto& kind) { fits = fits && all_fit(scene.*kind.list); });
  for_each_single([&]<class Table>(const Single<Table>& single) {
    fits = fits && (!single.command.empty() || scene.*single.member == Table{});
  });
  return fits;
}

std::string recorded_text(const Scene& scene, const core::WorkControl& control) {
  return fits_script(scene) ? write_script(scene, control) : write_format_2(scene);
}

void recorded_text(const Scene& scene, const core::WorkControl& control,
                   const std::function<void(std::string_view)>& take) {
  if (fits_script(scene)) return write_script(scene, control, take);
  take(write_format_2(scene));
}

}  // namespace sarsim::scene
