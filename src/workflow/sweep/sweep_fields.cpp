#include "workflow/sweep/sweep_fields.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/model/object.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t max_listed = 5;

struct Line {
  std::string name;
  std::string value;
  std::string takes;
};

// What may be written for a field.
std::string takes(const scene::Field& field) {
  switch (field.kind) {
    case scene::FieldKind::quantity: return fmt::format("{}", fmt::join(scene::units_of(field.quantity), ", "));
    case scene::FieldKind::choice: return fmt::format("{}", fmt::join(field.choices, " | "));
    case scene::FieldKind::check: return "yes | no";
    case scene::FieldKind::function: return "name of a data file";
    case scene::FieldKind::list: return "nothing: it is edited in the text";
    default: return {};
  }
}

void add_object(std::vector<Line>& lines, const scene::Scene& scene, scene::ObjectId id) {
  const scene::AnyObject object = scene::object_of(scene, id);
  const std::vector<scene::Field>& fields = scene::fields_of(id.kind);
  const std::string address = scene::address_of(scene, id);
  for (const scene::Field& field : fields)
    if (scene::field_applies(object, field.id))
      lines.push_back({fmt::format("{}.{}", address, scene::short_name(fields, field)),
                       scene::field_text(object, field.id), takes(field)});
}

void add_let(std::vector<Line>& lines, const NamedThings& things, std::string_view name) {
  const SweptField swept = find_swept_field(things, std::string(let_prefix) + std::string(name), "");
  if (swept.let == nullptr) return;
  const bool number = swept.let->kind == scene::FieldKind::quantity;
  lines.push_back({swept.let->id,
                   number ? scene::quantity_text(things.names.find(name)->value, swept.let->quantity) : "",
                   number ? takes(*swept.let) : ""});
}

}  // namespace

std::string field_list(const NamedThings& things) {
  const scene::Scene& scene = things.scene;
  std::vector<Line> lines;
  for (const scene::ObjectKind kind : scene::all_object_kinds) {
    const std::size_t count = scene::count_of(scene, kind);
    const std::size_t listed = scene::reflects(kind) ? std::min(count, max_listed) : count;
    for (std::size_t i = 0; i < listed; ++i) add_object(lines, scene, {kind, i});
    if (listed < count) lines.push_back({fmt::format("... and {} more", count - listed), "", ""});
  }
  for (const scene::Field& field : scene::atmosphere_fields())
    if (scene::field_applies(scene.atmosphere, field.id))
      lines.push_back({"Atmosphere." + scene::short_name(scene::atmosphere_fields(), field),
                       scene::field_text(scene.atmosphere, field.id), takes(field)});
  for (const scene::Field& field : scene::option_fields())
    lines.push_back(
        {scene::short_name(scene::option_fields(), field), scene::field_text(scene.options, field.id), takes(field)});
  for (const std::string_view name : things.names.all()) add_let(lines, things, name);
  std::size_t name_width = 0;
  std::size_t value_width = 0;
  for (const Line& line : lines) {
    name_width = std::max(name_width, line.name.size());
    value_width = std::max(value_width, line.value.size());
  }
  std::string text;
  for (const Line& line : lines) {
    std::string row = fmt::format("{:<{}}  {:<{}}  {}", line.name, name_width, line.value, value_width, line.takes);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

}  // namespace sarsim::workflow
