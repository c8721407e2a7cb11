#include "cli/command/sweep_fields.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/model/object_lists.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::cli {

namespace {

constexpr std::size_t most_listed = 5;

struct Line {
  std::string name;
  std::string value;
  std::string takes;
};

// What may be written for a field.
std::string takes(const Field& field) {
  switch (field.kind) {
    case FieldKind::quantity: return fmt::format("{}", fmt::join(units_of(field.quantity), ", "));
    case FieldKind::choice: return fmt::format("{}", fmt::join(field.choices, " | "));
    case FieldKind::check: return "yes | no";
    default: return {};
  }
}

void add_object(std::vector<Line>& lines, const Scene& scene, ObjectId id) {
  const AnyObject object = object_of(scene, id);
  const std::vector<Field>& fields = fields_of(id.kind);
  const std::string address = address_of(scene, id);
  for (const Field& field : fields)
    if (field.kind != FieldKind::function && field_applies(object, field.id))
      lines.push_back(
          {fmt::format("{}.{}", address, short_name(fields, field)), field_text(object, field.id), takes(field)});
}

}  // namespace

std::string field_list(const Scene& scene) {
  std::vector<Line> lines;
  for (const ObjectKind kind : all_object_kinds) {
    const std::size_t count = count_of(scene, kind);
    const bool points = kind == ObjectKind::target || kind == ObjectKind::surface;
    const std::size_t listed = points ? std::min(count, most_listed) : count;
    for (std::size_t i = 0; i < listed; ++i) add_object(lines, scene, {kind, i});
    if (listed < count) lines.push_back({fmt::format("... and {} more", count - listed), "", ""});
  }
  for (const Field& field : option_fields())
    lines.push_back({short_name(option_fields(), field), field_text(scene.options, field.id), takes(field)});
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

}  // namespace sarsim::cli
