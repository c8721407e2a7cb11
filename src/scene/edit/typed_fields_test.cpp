#include "scene/edit/typed_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "scene/edit/document.hpp"
#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {
namespace typed_fields_test {

constexpr const char* scene_text = R"toml(format = "sarsim 2"
[let]
speed = "200 m/s"
a = "30 deg"

# the ground
[[target]]
position = ["15 km * sin(a)", "3 km", 0]
rcs = 2  # bare

[[target]]
positions = [
  [1, 2, 3],  # plain
  ["speed * 2 s", 0, 0],
]
rcs = "2 * 3 m2"

[[radar]]
name = "R"
pulse = { type = "chirp", bandwidth = "50 MHz * 2", width = "800 ns" }
carrier = "c / 3 cm"
repetition = "600 Hz"
[radar.beam]
type = "fixed"
elevation = "-a"

[[recording]]
radar = "R"
file = "a.h5"
range = ["10 km", "10 km + 2 * 1 km"]
sample_rate = "150 MHz"

[options]
seed = 7
)toml";

ObjectId target_id(std::size_t index) { return {ObjectKind::target, index}; }
constexpr ObjectId radar_id{ObjectKind::radar, 0};
constexpr ObjectId recording_id{ObjectKind::simulation, 0};

TypedField typed_of(const Document& document, std::optional<ObjectId> id, const std::string& field) {
  return document.typed_fields(id).at(field);
}

const Field& field_called(std::optional<ObjectId> id, std::string_view name) {
  const std::vector<Field>& fields = id ? fields_of(id->kind) : option_fields();
  return *std::ranges::find(fields, name, &Field::id);
}

// What a form does with a text that is entered; says why not.
std::string type_into(Document& document, ObjectId id, const Field& field, const std::string& text) {
  AnyObject object = object_of(document.scene(), id);
  std::string failure = set_field(object, field.id, text, document.let_names());
  if (!failure.empty()) return failure;
  Edit edit = replace_object(document.scene(), id, object, "Change");
  edit.typed.push_back({id, &field, text_as_typed(field, text, *document.let_names())});
  document.perform(edit);
  return {};
}
void type_into(Document& document, ObjectId id, const std::string& field, const std::string& text) {
  EXPECT_EQ(type_into(document, id, field_called(id, field), text), "");
}

// And with the way back to the default.
void go_back(Document& document, ObjectId id, const std::string& field) {
  AnyObject object = object_of(document.scene(), id);
  reset_field(object, field);
  Edit edit = replace_object(document.scene(), id, object, "Reset");
  edit.typed.push_back({id, &field_called(id, field), ""});
  document.perform(edit);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

// The scene must be what the text says, and the way back must lead to the same bytes.
void expect_text(Document& document, const std::string& expected) {
  EXPECT_EQ(document.text(), expected);
  EXPECT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene()) << document.text();
  document.undo();
  EXPECT_EQ(document.text(), scene_text);
  EXPECT_TRUE(read_format_2(scene_text, "", {}).scene == document.scene());
}

TEST(TypedFields, TellsWhatTheTextSays) {
  const Document document = Document::from_text(scene_text);
  ASSERT_FALSE(core::has_errors(document.problems())) << core::to_string(document.problems().front());
  EXPECT_TRUE(typed_of(document, radar_id, "pulse_width_s").said);
  EXPECT_TRUE(typed_of(document, radar_id, "carrier_hz").said);
  EXPECT_FALSE(typed_of(document, radar_id, "power_w").said);
  EXPECT_FALSE(typed_of(document, radar_id, "platform").said);
  EXPECT_TRUE(typed_of(document, recording_id, "range_start_m").said);
  EXPECT_FALSE(typed_of(document, recording_id, "time_start_s").said);
  for (const std::size_t index : {0U, 1U, 2U}) EXPECT_TRUE(typed_of(document, target_id(index), "position_m.y").said);
  EXPECT_FALSE(typed_of(document, target_id(2), "rcs_stddev_m2").said);
  EXPECT_TRUE(typed_of(document, std::nullopt, "seed").said);
  EXPECT_FALSE(document.typed_fields(radar_id).contains("name"));  // names have no default
}

TEST(TypedFields, TellsExpressionsFromNumbersWithUnits) {
  const Document document = Document::from_text(scene_text);
  const auto expression = [&](ObjectId id, const char* field) { return typed_of(document, id, field).expression; };
  EXPECT_EQ(expression(target_id(0), "position_m.x"), "15 km * sin(a)");
  EXPECT_EQ(expression(target_id(0), "position_m.y"), "");
  EXPECT_EQ(expression(target_id(0), "rcs_m2"), "");
  EXPECT_EQ(expression(target_id(1), "position_m.x"), "");
  EXPECT_EQ(expression(target_id(2), "position_m.x"), "speed * 2 s");
  EXPECT_EQ(expression(target_id(2), "rcs_m2"), "2 * 3 m2");
  EXPECT_EQ(expression(radar_id, "bandwidth_hz"), "50 MHz * 2");
  EXPECT_EQ(expression(radar_id, "pulse_width_s"), "");
  EXPECT_EQ(expression(radar_id, "carrier_hz"), "c / 3 cm");
  EXPECT_EQ(expression(recording_id, "range_start_m"), "");
  EXPECT_EQ(expression(recording_id, "range_end_m"), "10 km + 2 * 1 km");
}

TEST(TypedFields, KnowsNothingOfTheLanguageOf1998) {
  Document document = Document::from_text(write_script(read_format_2(scene_text, "", {}).scene));
  EXPECT_TRUE(document.typed_fields(radar_id).empty());
  EXPECT_EQ(document.let_names(), nullptr);
  AnyObject target = object_of(document.scene(), target_id(0));
  EXPECT_NE(set_field(target, "rcs_m2", "2 * 3 m2", document.let_names()), "");
}

TEST(TypedFields, FollowsTheTextWhileItIsTyped) {
  Document document = Document::from_text(scene_text);
  document.type_text(replaced(scene_text, "name = \"R\"", "name = \"R\"\npower = \"1 W\""));
  EXPECT_TRUE(typed_of(document, radar_id, "power_w").said);
  document.type_text(replaced(document.text(), "power = ", "power = oops"));
  EXPECT_TRUE(document.text_broken());
  EXPECT_TRUE(typed_of(document, radar_id, "power_w").said);
  document.undo();
  EXPECT_FALSE(typed_of(document, radar_id, "power_w").said);
}

TEST(TypedFields, WritesWhatWasTyped) {
  struct Case {
    ObjectId id;
    const char* field;
    const char* typed;
    const char* before;
    const char* after;
  };
  for (const auto& [id, field, typed, before, after] : std::initializer_list<Case>{
           {target_id(0), "position_m.y", "speed * 10 s", "\"3 km\", 0]", "\"speed * 10 s\", 0]"},
           {target_id(0), "position_m.x", "15 km * cos(a)", "sin(a)", "cos(a)"},
           {target_id(0), "position_m.z", "2.50 km", "\"3 km\", 0]", "\"3 km\", \"2.50 km\"]"},
           {target_id(0), "rcs_m2", "2", "rcs = 2  #", "rcs = \"2 m2\"  #"},  // as the writer says it
           {target_id(0), "rcs_m2", "1 m2 + 1 m2", "rcs = 2  #", "rcs = \"1 m2 + 1 m2\"  #"},
           {target_id(0), "rcs_m2", "1 m2", "rcs = 2  #", "rcs = \"1 m2\"  #"},  // the default, said
           {target_id(1), "position_m.y", "2 * 1 m", "[1, 2, 3]", "[1, \"2 * 1 m\", 3]"},
           {target_id(2), "position_m.x", "speed * 3 s", "speed * 2 s", "speed * 3 s"},
           {target_id(2), "position_m.x", "0.4 km", "speed * 2 s", "0.4 km"},  // the same value
           {radar_id, "pulse_width_s", "0.7 us + 0.1 us", "800 ns", "0.7 us + 0.1 us"},
           {radar_id, "carrier_hz", "c / 4 cm", "c / 3 cm", "c / 4 cm"},
           {radar_id, "prf_hz", "speed / 1 m", "600 Hz", "speed / 1 m"},
           {radar_id, "beam_elevation", "-a / 2", "\"-a\"", "\"-a / 2\""},
           {recording_id, "range_start_m", "speed * 40 s", "[\"10 km\",", "[\"speed * 40 s\","}}) {
    SCOPED_TRACE(typed);
    if (std::ranges::find(fields_of(id.kind), std::string_view(field), &Field::id) == fields_of(id.kind).end()) {
      ADD_FAILURE() << field;
      continue;
    }
    Document document = Document::from_text(scene_text);
    type_into(document, id, field, typed);
    EXPECT_TRUE(document.replaced_expressions().empty());
    expect_text(document, replaced(scene_text, before, after));
  }
}

TEST(TypedFields, AddsAKeyWithAnExpression) {
  Document document = Document::from_text(scene_text);
  type_into(document, radar_id, "power_w", "2 * 5 W");
  expect_text(document,
              replaced(scene_text, "repetition = \"600 Hz\"\n", "repetition = \"600 Hz\"\npower = \"2 * 5 W\"\n"));
}

TEST(TypedFields, SplitsAListWhereOneTargetGetsAnExpression) {
  Document document = Document::from_text(scene_text);
  type_into(document, target_id(1), "rcs_m2", "2 m2 * 2");
  EXPECT_EQ(typed_of(document, target_id(1), "rcs_m2").expression, "2 m2 * 2");
  EXPECT_EQ(typed_of(document, target_id(2), "rcs_m2").expression, "2 * 3 m2");
  EXPECT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene());
  document.undo();
  EXPECT_EQ(document.text(), scene_text);
}

TEST(TypedFields, DoesNothingWhereNothingElseWasTyped) {
  Document document = Document::from_text(scene_text);
  type_into(document, radar_id, "pulse_width_s", "800 ns");
  EXPECT_FALSE(document.changed());
  EXPECT_FALSE(document.history().can_undo());
}

TEST(TypedFields, RefusesWhatAFileWouldRefuse) {
  Document document = Document::from_text(scene_text);
  const auto refusal = [&](const char* field, const char* text) {
    return type_into(document, target_id(0), field_called(target_id(0), field), text);
  };
  EXPECT_NE(refusal("position_m.x", "speed * 2").find("speed"), std::string::npos);
  EXPECT_NE(refusal("position_m.x", "speedy * 2 s").find("speedy"), std::string::npos);
  EXPECT_EQ(refusal("position_m.x", "5 kg"), read_quantity("5 kg", Quantity::length).failure);
  EXPECT_NE(refusal("rcs_m2", "2 * 1 km"), "");
  EXPECT_EQ(document.text(), scene_text);
}

TEST(TypedFields, TakesWhatIsSaidOutOfTheText) {
  Document document = Document::from_text(scene_text);
  go_back(document, target_id(0), "rcs_m2");
  expect_text(document, replaced(scene_text, "rcs = 2  # bare\n", ""));
  go_back(document, radar_id, "pulse_width_s");
  expect_text(document, replaced(scene_text, ", width = \"800 ns\" }", " }"));
  go_back(document, radar_id, "beam_elevation");
  EXPECT_FALSE(typed_of(document, radar_id, "beam_elevation").said);
  document.undo();
  EXPECT_EQ(document.text(), scene_text);
}

TEST(TypedFields, TakesADefaultOutOfTheTextThatSaysIt) {
  const std::string text =
      replaced(scene_text, "name = \"R\"", "name = \"R\"\nplatform = \"Earth\"\npower = \"500 mW * 2\"");
  Document document = Document::from_text(text);
  document.type_text(replaced(text, "500 mW * 2", quantity_text(Radar().power_w, Quantity::power)));
  document.end_run();
  go_back(document, radar_id, "platform");
  EXPECT_EQ(document.text().find("platform"), std::string::npos);
  go_back(document, radar_id, "power_w");
  EXPECT_EQ(document.text(), scene_text);
  go_back(document, radar_id, "power_w");  // there is nothing left
  document.undo();
  document.undo();
  EXPECT_NE(document.text().find("platform"), std::string::npos);
}

TEST(TypedFields, TellsWhichExpressionsAnEditReplaced) {
  Document document = Document::from_text(scene_text);
  Target moved = document.scene().targets[0];
  moved.position_m.x = 7000.0;
  moved.position_m.y = 1.0;
  document.perform(replace_object(document.scene(), target_id(0), moved, "Move", "drag"));
  ASSERT_EQ(document.replaced_expressions().size(), 1U);
  const ReplacedExpression& replaced_one = document.replaced_expressions().front();
  EXPECT_EQ(replaced_one.object, target_id(0));
  EXPECT_EQ(replaced_one.field->id, "position_m.x");
  EXPECT_EQ(replaced_one.expression, "15 km * sin(a)");
  moved.position_m.x = 7001.0;
  document.perform(replace_object(document.scene(), target_id(0), moved, "Move", "drag"));
  EXPECT_TRUE(document.replaced_expressions().empty());
  document.undo();
  EXPECT_EQ(document.text(), scene_text);
}

// Objects of a kind with each of their choices.
std::vector<AnyObject> objects_of_all_choices(ObjectKind kind) {
  const AnyObject first = visit_kind(kind, []<class Object>(const Kind<Object>&) { return AnyObject(Object{}); });
  std::vector<AnyObject> objects{first};
  for (const Field& field : fields_of(kind))
    for (const std::string& choice : field.choices) {
      AnyObject other = first;
      if (field_applies(first, field.id) && set_field(other, field.id, choice).empty() && other != first)
        objects.push_back(other);
    }
  return objects;
}

// An expression that a field takes and that is not its value; empty where there is none.
std::string expression_for(const AnyObject& object, const Field& field, const LetNames& names) {
  const std::vector<std::string_view> units = units_of(field.quantity);
  const std::string unit = units.empty() ? "" : " " + std::string(units.front());
  for (const char* number : {"3", "0.5", "30", "3000", "7"}) {
    AnyObject other = object;
    const std::string text = "2 * " + std::string(number) + unit;
    if (set_field(other, field.id, text, &names).empty() && other != object) return text;
  }
  return {};
}

TEST(TypedFields, EveryNumberTakesAnExpressionAndGoesBack) {
  std::size_t tried = 0;
  for (const ObjectKind kind : all_object_kinds)
    for (const AnyObject& object : objects_of_all_choices(kind)) {
      Scene scene;
      visit_list(scene, kind, [&]<class Object>(std::vector<Object>& list) { list = {std::get<Object>(object)}; });
      const Document made = Document::from_text(write_format_2(scene));
      if (made.text_broken() || object_of(made.scene(), {kind, 0}) != object) continue;
      for (const Field& field : fields_of(kind)) {
        if (field.kind != FieldKind::quantity || !field_applies(object, field.id)) continue;
        Document document = Document::from_text(made.text());
        const std::string typed = expression_for(object, field, *document.let_names());
        if (typed.empty()) continue;
        SCOPED_TRACE(std::string(name_of(kind)) + " " + field.id + " = " + typed + "\n" + made.text());
        ++tried;
        const ObjectId id{kind, 0};
        ASSERT_EQ(type_into(document, id, field, typed), "");
        EXPECT_EQ(typed_of(document, id, field.id).expression, typed) << document.text();
        EXPECT_TRUE(read_format_2(document.text(), "", {}).scene == document.scene());
        go_back(document, id, field.id);
        AnyObject by_default = object;
        reset_field(by_default, field.id);
        EXPECT_TRUE(object_of(document.scene(), id) == by_default) << document.text();
        EXPECT_EQ(document.text().find(typed), std::string::npos) << document.text();
        document.undo();
        document.undo();
        EXPECT_EQ(document.text(), made.text());
      }
    }
  EXPECT_GT(tried, 100U);
}

}  // namespace typed_fields_test
}  // namespace sarsim::scene
