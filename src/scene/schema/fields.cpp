#include "scene/schema/fields.hpp"

#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

namespace {

using namespace field_tables;

// The table of each alternative of AnyObject.
const FieldTable<Platform>& table_of(const Platform&) { return platform_table(); }
const FieldTable<Target>& table_of(const Target&) { return target_table(); }
const FieldTable<Surface>& table_of(const Surface&) { return surface_table(); }
const FieldTable<Radar>& table_of(const Radar&) { return radar_table(); }
const FieldTable<Simulation>& table_of(const Simulation&) { return simulation_table(); }
const FieldTable<GeometryTable>& table_of(const GeometryTable&) { return geometry_table(); }

std::string_view matching_field(const std::vector<Field>& fields, std::string_view name) {
  if (name.empty()) return {};
  std::string_view within;
  for (const Field& field : fields) {
    if (field.id == name) return field.id;
    const std::string_view id = field.id;
    if (!within.empty() || id.size() <= name.size() || !id.starts_with(name)) continue;
    if (id[name.size()] == '.' || id[name.size()] == '[') within = id;
  }
  return within;
}

}  // namespace

const std::vector<Field>& fields_of(ObjectKind kind) {
  static const std::array<std::vector<Field>, 6> fields{platform_table().fields(),   target_table().fields(),
                                                        surface_table().fields(),    radar_table().fields(),
                                                        simulation_table().fields(), geometry_table().fields()};
  return fields.at(static_cast<std::size_t>(kind));
}

const std::vector<Field>& option_fields() {
  static const std::vector<Field> fields = options_table().fields();
  return fields;
}

std::string_view field_of_problem(ObjectKind kind, std::string_view problem_field) {
  return matching_field(fields_of(kind), problem_field);
}

std::string_view option_field_of_problem(std::string_view problem_field) {
  return matching_field(option_fields(), problem_field);
}

bool field_applies(const AnyObject& object, std::string_view id) {
  return std::visit([&](const auto& alternative) { return table_of(alternative).applies(alternative, id); }, object);
}

std::string field_text(const AnyObject& object, std::string_view id) {
  return std::visit([&](const auto& alternative) { return table_of(alternative).text(alternative, id); }, object);
}

std::string field_text(const RunOptions& options, std::string_view id) { return options_table().text(options, id); }

std::string set_field(AnyObject& object, std::string_view id, std::string_view text) {
  return std::visit([&](auto& alternative) { return table_of(alternative).set(alternative, id, text); }, object);
}

std::string set_field(RunOptions& options, std::string_view id, std::string_view text) {
  return options_table().set(options, id, text);
}

}  // namespace sarsim::scene
