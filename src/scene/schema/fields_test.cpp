#include "scene/schema/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "scene/check/check.hpp"
#include "scene/model/kinds.hpp"
#include "scene/script/random_scene_test_support.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace fields_test {

constexpr ObjectKind all_kinds[] = {ObjectKind::platform, ObjectKind::target, ObjectKind::cloud,
                                    ObjectKind::surface,  ObjectKind::radar,  ObjectKind::simulation,
                                    ObjectKind::geometry};

AnyObject initial(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::platform: return Platform{};
    case ObjectKind::target: return Target{};
    case ObjectKind::cloud: return Cloud{};
    case ObjectKind::surface: return Surface{};
    case ObjectKind::radar: return Radar{};
    case ObjectKind::simulation: return Simulation{};
    case ObjectKind::geometry: return GeometryTable{};
  }
  return Platform{};
}

const Field& field_named(ObjectKind kind, std::string_view id) {
  const auto& fields = fields_of(kind);
  const auto found = std::ranges::find(fields, id, &Field::id);
  if (found == fields.end()) throw std::out_of_range(std::string(id));
  return *found;
}

// Becomes anything.
struct Anything {
  template <class Type>
  operator Type() const;
};

// How many members a structure has: as many as initial values fit.
template <class Object, class... Values>
constexpr std::size_t member_count() {
  if constexpr (requires { Object{Values{}..., Anything{}}; })
    return member_count<Object, Values..., Anything>();
  else
    return sizeof...(Values);
}

struct OfThree {
  std::array<core::Angle, 3> array;
  std::string text = "initial";
  bool last = true;
};
static_assert(member_count<OfThree>() == 3);

// The members that the fields of a structure begin with.
template <class Object>
std::set<std::string> members_with_fields(std::string_view within = "") {
  std::set<std::string> members;
  for (const auto& field : table_of<Object>().fields()) {
    std::string_view id = field.spec.id;
    if (!id.starts_with(within)) continue;
    id.remove_prefix(within.size());
    members.emplace(id.substr(0, id.find_first_of(".[")));
  }
  return members;
}

TEST(Fields, EveryMemberOfEveryObjectHasAField) {
  for_each_kind([]<class Object>(const Kind<Object>& kind) {
    const std::set<std::string> members = members_with_fields<Object>();
    // What files hold is no field.
    constexpr std::size_t read = std::is_same_v<Object, Cloud> ? 1 : std::is_same_v<Object, Platform> ? 2 : 0;
    std::size_t count = member_count<Object>();
    if constexpr (requires(Object object) { object.traits; }) count += member_count<TargetTraits>() - 1;
    EXPECT_EQ(members.size() + read, count) << kind.name;
    for (const std::string& member : members) {
      const std::string_view id = field_of_problem(kind.kind, member);
      EXPECT_FALSE(id.empty()) << member;
      EXPECT_TRUE(id.starts_with(member)) << id;
    }
  });
  EXPECT_EQ(member_count<Radar>(), 42U);
  EXPECT_EQ(members_with_fields<Radar>("transmit_antenna.").size(), member_count<Antenna>());
  EXPECT_EQ(members_with_fields<Radar>("receive_antenna.").size(), member_count<Antenna>());
  EXPECT_EQ(members_with_fields<RunOptions>().size(), member_count<RunOptions>());
  for (const char* member : {"profile", "seed", "pulse", "tolerance"})
    EXPECT_EQ(option_field_of_problem(member), member);
}

TEST(Fields, VectorsCornersAntennasAndColumnsHaveAFieldForEachPart) {
  for (const char* id : {"position_m.z", "rotation.y", "rotation_stddev.x", "rotation_rate.z"})
    EXPECT_NO_THROW(static_cast<void>(field_named(ObjectKind::platform, id))) << id;
  for (const char* id : {"corner_m[0].x", "corner_m[2].z"})
    EXPECT_NO_THROW(static_cast<void>(field_named(ObjectKind::surface, id))) << id;
  for (const char* id : {"transmit_antenna.pattern", "transmit_antenna.elevation_beamwidth",
                         "receive_antenna.azimuth_beamwidth", "receive_antenna.gain_db", "spot_world_m.y"})
    EXPECT_NO_THROW(static_cast<void>(field_named(ObjectKind::radar, id))) << id;
  std::size_t columns = 0;
  for (const Field& field : fields_of(ObjectKind::geometry))
    if (field.id.starts_with("columns.")) ++columns;
  EXPECT_EQ(columns, 8U);
}

TEST(Fields, IdsAreUniqueAndEveryFieldIsExplained) {
  for (const ObjectKind kind : all_kinds) {
    std::set<std::string> ids;
    for (const Field& field : fields_of(kind)) {
      EXPECT_TRUE(ids.insert(field.id).second) << field.id;
      EXPECT_FALSE(field.label.empty()) << field.id;
      EXPECT_FALSE(field.group.empty()) << field.id;
      EXPECT_GT(field.tooltip.size(), 15U) << field.id;
      EXPECT_EQ(field.kind == FieldKind::choice, !field.choices.empty()) << field.id;
    }
  }
}

TEST(Fields, OfManyObjectsTheCommonTextIsThatOfEach) {
  Scene scene;
  for (const ObjectKind kind : all_kinds)
    for (const Field& field : fields_of(kind)) {
      EXPECT_EQ(common_field_text(scene, kind, field.id), std::nullopt) << field.id;
      EXPECT_TRUE(field_applies(scene, kind, field.id)) << field.id;
    }
  for (int i = 0; i < 3; ++i) scene.targets.emplace_back().position_m = {1000.0 * i, 5.0, 0.0};
  scene.targets[1].platform = "Ship";
  scene.targets[2].rcs_m2 = std::nan("");
  EXPECT_EQ(common_field_text(scene, ObjectKind::target, "position_m.x"), std::nullopt);
  EXPECT_EQ(common_field_text(scene, ObjectKind::target, "platform"), std::nullopt);
  EXPECT_EQ(common_field_text(scene, ObjectKind::target, "rcs_m2"), std::nullopt);
  EXPECT_EQ(common_field_text(scene, ObjectKind::target, "position_m.y"),
            field_text(AnyObject(scene.targets[0]), "position_m.y"));
  scene.targets[1].rcs_m2 = scene.targets[0].rcs_m2 = std::nan("");
  EXPECT_EQ(common_field_text(scene, ObjectKind::target, "rcs_m2"), field_text(AnyObject(scene.targets[0]), "rcs_m2"));
  scene.radars.resize(2);
  scene.radars[0].pulse = Radar::Pulse::chirp;
  EXPECT_FALSE(field_applies(scene, ObjectKind::radar, "bandwidth_hz"));
  scene.radars[1].pulse = Radar::Pulse::chirp;
  EXPECT_TRUE(field_applies(scene, ObjectKind::radar, "bandwidth_hz"));
  EXPECT_THROW(static_cast<void>(common_field_text(scene, ObjectKind::radar, "none")), std::invalid_argument);
}

TEST(Fields, AProblemOfAWholeMemberIsShownAtItsFirstPart) {
  EXPECT_EQ(field_of_problem(ObjectKind::platform, "position_m"), "position_m.x");
  EXPECT_EQ(field_of_problem(ObjectKind::radar, "pulse_width_s"), "pulse_width_s");
  EXPECT_EQ(field_of_problem(ObjectKind::radar, "transmit_antenna"), "transmit_antenna.pattern");
  EXPECT_EQ(field_of_problem(ObjectKind::radar, "receive_antenna.azimuth_beamwidth"),
            "receive_antenna.azimuth_beamwidth");
  EXPECT_EQ(field_of_problem(ObjectKind::surface, "corner_m"), "corner_m[0].x");
  EXPECT_EQ(field_of_problem(ObjectKind::geometry, "columns"), "columns.time");
  EXPECT_EQ(field_of_problem(ObjectKind::radar, ""), "");
  EXPECT_EQ(field_of_problem(ObjectKind::radar, "colour"), "");
}

// Every object of a scene with its place in it.
std::vector<ObjectId> ids_of(const Scene& scene) {
  std::vector<ObjectId> ids;
  for (const ObjectKind kind : all_kinds)
    for (std::size_t i = 0; i < count_of(scene, kind); ++i) ids.push_back({kind, i});
  return ids;
}

TEST(Fields, TheTextOfEveryFieldSetsItToWhatItIs) {
  test::RandomScenes random(11);
  for (int round = 0; round < 60; ++round) {
    const Scene scene = random.scene();
    for (const ObjectId id : ids_of(scene)) {
      const AnyObject object = object_of(scene, id);
      for (const Field& field : fields_of(id.kind)) {
        AnyObject copy = object;
        const std::string text = field_text(object, field.id);
        EXPECT_EQ(set_field(copy, field.id, text), "") << field.id << " = " << text;
        EXPECT_TRUE(copy == object) << field.id << " = " << text;
      }
    }
    for (const Field& field : option_fields()) {
      RunOptions copy = scene.options;
      EXPECT_EQ(set_field(copy, field.id, field_text(scene.options, field.id)), "") << field.id;
      EXPECT_TRUE(copy == scene.options) << field.id;
    }
  }
}

TEST(Fields, EveryFieldKeepsItsTextThroughAScript) {
  test::RandomScenes random(12);
  for (int round = 0; round < 60; ++round) {
    const Scene scene = random.scene();
    const Scene read = read_script(write_script(scene), "written.scr", {}).scene;
    for (const ObjectId id : ids_of(scene))
      for (const Field& field : fields_of(id.kind))
        EXPECT_EQ(field_text(object_of(read, id), field.id), field_text(object_of(scene, id), field.id)) << field.id;
    for (const Field& field : option_fields())
      EXPECT_EQ(field_text(read.options, field.id), field_text(scene.options, field.id)) << field.id;
  }
}

// A text that the field takes and that is not the one it has; empty where there is none.
std::string other_text(const Field& field, const std::string& present) {
  switch (field.kind) {
    case FieldKind::quantity: {
      const Range& range = field.spec->range;
      if (std::isfinite(range.high) && range.holds(0.5 * (range.low + range.high)) && !range.holds(7.0))
        return quantity_text(0.5 * (range.low + range.high), field.quantity);
      return present.starts_with("7") ? "3" : field.id == "hanning_pedestal" ? "0.25" : "7";
    }
    case FieldKind::choice: return field.choices[present == field.choices[0] ? 1 : 0];
    case FieldKind::check: return present == "yes" ? "no" : "yes";
    case FieldKind::text:
    case FieldKind::platform:
    case FieldKind::radar: return present + " other";
    case FieldKind::function:
    case FieldKind::list: return "";
  }
  return "";
}

// The object with such choices made that a field means something.
AnyObject made_to_apply(const AnyObject& object, std::string_view id, int depth = 2) {
  if (field_applies(object, id) || depth == 0) return object;
  for (const Field& field : fields_of(kind_of(object))) {
    if (!field_applies(object, field.id)) continue;
    std::vector<std::string> values = field.choices;
    if (field.kind == FieldKind::check) values = {"yes", "no"};
    for (const std::string& value : values) {
      AnyObject changed = object;
      EXPECT_EQ(set_field(changed, field.id, value), "");
      changed = made_to_apply(changed, id, depth - 1);
      if (field_applies(changed, id)) return changed;
    }
  }
  return object;
}

TEST(Fields, SettingAFieldChangesTheObjectAndShowsWhatWasSet) {
  for (const ObjectKind kind : all_kinds)
    for (const Field& field : fields_of(kind)) {
      const AnyObject before = made_to_apply(initial(kind), field.id);
      ASSERT_TRUE(field_applies(before, field.id)) << field.id;
      AnyObject object = before;
      const std::string text = other_text(field, field_text(object, field.id));
      if (text.empty()) continue;
      EXPECT_EQ(set_field(object, field.id, text), "") << field.id << " = " << text;
      EXPECT_FALSE(object == before) << field.id;
      const std::string shown = field_text(object, field.id);
      EXPECT_TRUE(shown == text || shown.starts_with(text + " ")) << field.id << ": " << shown;
    }
  for (const Field& field : option_fields()) {
    RunOptions options;
    EXPECT_EQ(set_field(options, field.id, other_text(field, field_text(options, field.id))), "") << field.id;
    EXPECT_FALSE(options == RunOptions{}) << field.id;
  }
}

TEST(Fields, AFieldThatMeansNothingCannotBeChanged) {
  AnyObject object = Target{};
  EXPECT_EQ(set_field(object, "azimuth", "0 deg"), "");
  EXPECT_NE(set_field(object, "azimuth", "5 deg").find("Azimuth does not apply"), std::string::npos);
  EXPECT_NE(set_field(object, "gain", "User"), "");
  EXPECT_TRUE(std::get<Target>(object) == Target{});
}

// One of the choices that the script language has.
std::string shown_in_script(const FieldSpec& spec, std::uint64_t draw) {
  std::vector<Choice> choices = spec.choices;
  std::erase_if(choices, [](const Choice& choice) { return choice.since_2(); });
  return std::string(choices[draw % choices.size()].shown);
}

// Every object that choosing can lead to within the script language is one that a script can say: the writer's
// requirement.
TEST(Fields, AfterAnyChoiceTheObjectIsOneThatAScriptKeeps) {
  std::mt19937_64 engine(13);
  for (const ObjectKind kind : all_kinds) {
    AnyObject object = initial(kind);
    if (auto* simulation = std::get_if<Simulation>(&object)) {
      simulation->radar = "Radar1";
      simulation->sample_rate_hz = 1e8;
    }
    if (auto* table = std::get_if<GeometryTable>(&object)) table->radar = "Radar1";
    for (int step = 0; step < 600; ++step) {
      const Field& field = fields_of(kind)[engine() % fields_of(kind).size()];
      if (field.kind == FieldKind::function || !field_applies(object, field.id) || field.spec->since_2) continue;
      const std::string text =
          field.kind == FieldKind::choice ? shown_in_script(*field.spec, engine())
          : field.kind == FieldKind::text || field.kind == FieldKind::platform || field.kind == FieldKind::radar
              ? "Name" + std::to_string(engine() % 9)
              : other_text(field, field_text(object, field.id));
      ASSERT_EQ(set_field(object, field.id, text), "") << field.id << " = " << text;
      Scene scene;
      std::visit(
          [&](const auto& one) {
            using Object = std::decay_t<decltype(one)>;
            if constexpr (std::is_same_v<Object, Platform>) scene.platforms.push_back(one);
            if constexpr (std::is_same_v<Object, Target>) scene.targets.push_back(one);
            if constexpr (std::is_same_v<Object, Cloud>) scene.clouds.push_back(one);
            if constexpr (std::is_same_v<Object, Surface>) scene.surfaces.push_back(one);
            if constexpr (std::is_same_v<Object, Radar>) scene.radars.push_back(one);
            if constexpr (std::is_same_v<Object, Simulation>) scene.simulations.push_back(one);
            if constexpr (std::is_same_v<Object, GeometryTable>) scene.geometries.push_back(one);
          },
          object);
      const ScriptReading reading = read_script(write_script(scene), "written.scr", {});
      ASSERT_FALSE(core::has_errors(reading.problems))
          << core::to_string(reading.problems.front()) << write_script(scene);
      ASSERT_TRUE(reading.scene == scene) << field.id << " = " << text << "\n" << write_script(scene);
    }
  }
}

TEST(Fields, UnitsMayBeTyped) {
  AnyObject object = Radar{};
  EXPECT_EQ(set_field(object, "pulse", "Chirp"), "");
  EXPECT_EQ(set_field(object, "bandwidth_hz", "80 mhz"), "");
  EXPECT_EQ(set_field(object, "pulse_width_s", "3 us"), "");
  EXPECT_EQ(set_field(object, "losses", "x2"), "");
  const auto& radar = std::get<Radar>(object);
  EXPECT_EQ(radar.bandwidth_hz, 80e6);
  EXPECT_EQ(radar.pulse_width_s, 3e-6);
  EXPECT_NEAR(radar.losses.db(), 3.0103, 1e-4);
}

TEST(Fields, ChoicesAreMatchedWithoutCaseAndByAUniqueBeginning) {
  AnyObject object = Radar{};
  EXPECT_EQ(set_field(object, "pulse", "chirp"), "");
  EXPECT_EQ(field_text(object, "pulse"), "Chirp");
  EXPECT_EQ(set_field(object, "pulse", " BARK "), "");
  EXPECT_EQ(field_text(object, "pulse"), "Barker");
  EXPECT_EQ(set_field(object, "barker_code", "13"), "");
  EXPECT_EQ(std::get<Radar>(object).barker_code, 6);
  EXPECT_EQ(set_field(object, "window", "han"), "");
  EXPECT_EQ(field_text(object, "window"), "Hann");
}

struct InvalidRequest {
  ObjectKind kind;
  const char* id;
  const char* text;
  const char* says;
};

TEST(Fields, WhatCannotBeSetIsRefusedInWordsAndChangesNothing) {
  const InvalidRequest table[] = {
      {ObjectKind::radar, "window", "Ha", "'Ha' can mean Hann or Hamming"},
      {ObjectKind::radar, "pulse", "Chrip", "did you mean Chirp?"},
      {ObjectKind::radar, "pulse", "", "nothing is chosen; expected Monochrome, Chirp"},
      {ObjectKind::radar, "barker_code", "6", "'6' is none of 2, 3, 4, 5, 7, 11 and 13"},
      {ObjectKind::radar, "barker_code", "1", "'1' can mean 11 or 13"},
      {ObjectKind::radar, "pulse_width_s", "5 m", "is not a valid time; try s, ns"},
      {ObjectKind::radar, "pulse_width_s", "-1 us", "0 or more"},
      {ObjectKind::radar, "carrier_steps", "2000", "number of frequencies is 1 to 1000"},
      {ObjectKind::radar, "carrier_steps", "2.5", "is not a valid whole number"},
      {ObjectKind::radar, "prf_hz", "0", "0.00001 Hz or more"},
      {ObjectKind::radar, "transmit_gain", "301 dB", "0 to 300 dB"},
      {ObjectKind::radar, "hanning_pedestal", "1.5", "Hanning constant is 0 to 1"},
      {ObjectKind::radar, "carrier_hz", "1e19", "too large to compute with"},
      {ObjectKind::radar, "same_antenna", "maybe", "'maybe' is neither yes nor no"},
      {ObjectKind::radar, "pulse_iq", "3 points", "function editor"},
      {ObjectKind::radar, "name", "", "name of the radar is empty"},
      {ObjectKind::platform, "name", "A\nB", "control character"},
      {ObjectKind::platform, "position_m.x", "1,5", "the decimal mark is the point: 1.5"},
      {ObjectKind::target, "rcs_stddev_m2", "-1", "0 or more"},
      {ObjectKind::simulation, "bits", "65", "1 to 64"},
      {ObjectKind::simulation, "sample_rate_hz", "0", "above 0"},
      {ObjectKind::simulation, "oversampling", "0.5", "1 to 100"},
  };
  for (const InvalidRequest& refused : table) {
    const AnyObject before = made_to_apply(initial(refused.kind), refused.id);
    AnyObject object = before;
    const std::string failure = set_field(object, refused.id, refused.text);
    EXPECT_TRUE(object == before) << refused.id;
    EXPECT_NE(failure.find(refused.says), std::string::npos) << refused.id << ": " << failure;
  }
  RunOptions options;
  for (const char* seed : {"-1", "1.5", "18446744073709551616", "", "abc"})
    EXPECT_NE(set_field(options, "seed", seed), "") << seed;
  EXPECT_NE(set_field(options, "tolerance", "0"), "");
  EXPECT_TRUE(options == RunOptions{});
}

TEST(Fields, WhatOnlyTheCheckOfASceneJudgesIsTaken) {
  AnyObject simulation = Simulation{};
  EXPECT_EQ(set_field(simulation, "range_end_m", "-5 km"), "");
  AnyObject target = Target{};
  EXPECT_EQ(set_field(target, "rcs_m2", "-1"), "");
  EXPECT_EQ(set_field(target, "platform", "Nowhere"), "");
  AnyObject radar = Radar{};
  EXPECT_EQ(set_field(radar, "pulse_width_s", "0"), "");
}

TEST(Fields, TheSeedTakesAll64Bits) {
  RunOptions options;
  EXPECT_EQ(set_field(options, "seed", "18446744073709551615"), "");
  EXPECT_EQ(options.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(field_text(options, "seed"), "18446744073709551615");
}

TEST(Fields, ColumnsAreSetOneByOne) {
  AnyObject object = GeometryTable{};
  EXPECT_EQ(set_field(object, "columns.velocity", "yes"), "");
  EXPECT_EQ(std::get<GeometryTable>(object).columns, 227 + 8);
  EXPECT_EQ(set_field(object, "columns.time", "off"), "");
  EXPECT_EQ(std::get<GeometryTable>(object).columns, 226 + 8);
}

TEST(Fields, WhatDoesNotApplyIsToldAndLosesItsValueWithTheChoice) {
  AnyObject object = Radar{};
  EXPECT_FALSE(field_applies(object, "bandwidth_hz"));
  EXPECT_EQ(set_field(object, "pulse", "Chirp"), "");
  EXPECT_TRUE(field_applies(object, "bandwidth_hz"));
  EXPECT_EQ(set_field(object, "bandwidth_hz", "80 MHz"), "");
  EXPECT_EQ(set_field(object, "pulse", "Chirp"), "");
  EXPECT_EQ(std::get<Radar>(object).bandwidth_hz, 80e6) << "the same choice again changes nothing";
  EXPECT_EQ(set_field(object, "pulse", "Mono"), "");
  EXPECT_TRUE(std::get<Radar>(object) == Radar{});
}

TEST(Fields, ChoicesWithinChoicesLoseTheirMeaningTogether) {
  AnyObject object = Target{};
  EXPECT_FALSE(field_applies(object, "gain"));
  for (const auto& [id, text] : {std::pair("reflectivity", "Directional"), std::pair("azimuth", "30"),
                                 std::pair("gain", "User"), std::pair("reflectivity", "Isotropic")})
    EXPECT_EQ(set_field(object, id, text), "");
  EXPECT_TRUE(std::get<Target>(object) == Target{});
  AnyObject radar = Radar{};
  for (const auto& [id, text] : {std::pair("same_antenna", "no"), std::pair("receive_antenna.pattern", "User"),
                                 std::pair("same_antenna", "yes")})
    EXPECT_EQ(set_field(radar, id, text), "");
  EXPECT_TRUE(std::get<Radar>(radar) == Radar{});
}

TEST(Fields, AFunctionThatIsChosenBeginsAsWhatWasThere) {
  AnyObject object = Platform{};
  EXPECT_EQ(set_field(object, "position_m.y", "2 km"), "");
  EXPECT_EQ(set_field(object, "path", "Trajectory"), "");
  const Platform moving = std::get<Platform>(object);
  EXPECT_EQ(moving.trajectory_m.part[1].knots, (std::vector<core::Knot>{{0.0, 2000.0}}));
  EXPECT_EQ(moving.position_m, core::Vec3{});
  EXPECT_EQ(set_field(object, "path", "Stationary"), "");
  EXPECT_EQ(std::get<Platform>(object).position_m.y, 2000.0);
  EXPECT_TRUE(std::get<Platform>(object).trajectory_m.part[1].knots.empty());

  AnyObject radar = Radar{};
  EXPECT_EQ(set_field(radar, "prf_hz", "2 kHz"), "");
  EXPECT_EQ(set_field(radar, "repetition", "User"), "");
  EXPECT_EQ(std::get<Radar>(radar).pri_s.part[0].knots, (std::vector<core::Knot>{{0.0, 0.0005}}));
  EXPECT_EQ(std::get<Radar>(radar).prf_hz, 1000.0);
}

TEST(Fields, EveryFunctionThatIsChosenIsOneThatCanBeSimulated) {
  for (const auto& [id, choice] :
       {std::pair("pulse", "User"), std::pair("envelope", "User"), std::pair("repetition", "User"),
        std::pair("carrier", "User"), std::pair("transmit_antenna.pattern", "User"), std::pair("beam", "User"),
        std::pair("window", "User"), std::pair("stc", "User")}) {
    AnyObject object = Radar{};
    EXPECT_EQ(set_field(object, id, choice), "");
    Scene scene;
    scene.platforms.emplace_back();
    scene.radars.push_back(std::get<Radar>(object));
    EXPECT_FALSE(core::has_errors(check(scene))) << id << ": " << core::to_string(check(scene).front());
  }
}

TEST(Fields, AFunctionIsSummarised) {
  Platform platform;
  platform.path = Platform::Path::trajectory;
  platform.trajectory_m.part[0] = {core::Interpolation::cubic, {{0, 0}, {1, 1}, {2, 4}}};
  platform.trajectory_m.part[1] = {core::Interpolation::cubic, {{0, 0}, {1, 1}, {2, 4}}};
  platform.trajectory_m.part[2] = {core::Interpolation::cubic, {{0, 0}, {1, 1}, {2, 4}}};
  EXPECT_EQ(field_text(AnyObject(platform), "trajectory_m"), "3 points, cubic");
  platform.trajectory_m.part[2] = {core::Interpolation::linear, {{0, 0}}};
  EXPECT_EQ(field_text(AnyObject(platform), "trajectory_m"), "3, 3 and 1 points, cubic, cubic and linear");
  platform.trajectory_m.file = "track.dat";
  EXPECT_EQ(field_text(AnyObject(platform), "trajectory_m"), "track.dat");
}

TEST(Fields, ValuesThatNoOneCouldTypeAreShownAllTheSame) {
  Radar radar;
  radar.pulse_width_s = std::nan("");
  radar.barker_code = 9;
  EXPECT_EQ(field_text(AnyObject(radar), "pulse_width_s"), "nan s");
  EXPECT_EQ(field_text(AnyObject(radar), "barker_code"), "9");
}

TEST(Fields, AnUnknownIdIsAProgrammersMistake) {
  AnyObject object = Radar{};
  EXPECT_THROW(static_cast<void>(field_text(object, "colour")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(set_field(object, "colour", "red")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(field_applies(object, "position_m.x")), std::invalid_argument);
}

}  // namespace fields_test

}  // namespace sarsim::scene
