#include "scene/schema/field_names.hpp"

#include <set>

#include <gmock/gmock.h>

#include "scene/model/object.hpp"

namespace sarsim::scene {
namespace field_names_test {

using testing::HasSubstr;

// Two radars, two platforms, three targets, two recordings and a surface; one radar is called as a platform is.
Scene small_scene() {
  Scene scene;
  scene.platforms.resize(2);
  scene.platforms[1].name = "Ship 2.b";
  scene.radars.resize(2);
  scene.radars[0].pulse = Radar::Pulse::chirp;
  scene.radars[1].name = "earth";
  scene.targets.resize(3);
  scene.surfaces.resize(1);
  scene.simulations.resize(2);
  scene.simulations[1].file = "data\\second.bin";
  return scene;
}

std::string id_of(const Scene& scene, std::string_view name, std::string_view value = "1") {
  const NamedField named = find_named_field(scene, name, value);
  return named.field == nullptr ? "none: " + named.failure : named.field->id;
}

std::string set(Scene& scene, std::string_view name, std::string_view value) {
  const NamedField named = find_named_field(scene, name, value);
  return named.field == nullptr ? named.failure : set_named_field(scene, named, value);
}

TEST(FieldNames, FindsFieldsByIdWithoutUnitsAndByLabel) {
  const Scene scene = small_scene();
  for (const char* name : {"Radar1.bandwidth_hz", "radar1.bandwidth", "RADAR1.Chirp bandwidth", "Radar1.Band_Width"})
    EXPECT_EQ(id_of(scene, name), "bandwidth_hz") << name;
  EXPECT_EQ(id_of(scene, "Target2.position.x"), "position_m.x");
  EXPECT_EQ(id_of(scene, "Target2.y"), "position_m.y");
  EXPECT_EQ(id_of(scene, "Target2.rcs"), "rcs_m2");
  EXPECT_EQ(id_of(scene, "Surface1.corner2.z"), "corner_m[1].z");
  EXPECT_EQ(id_of(scene, "Radar1.spot.x"), "spot_world_m.x");
  EXPECT_EQ(id_of(scene, "Radar1.transmit_antenna.elevation_beamwidth"), "transmit_antenna.elevation_beamwidth");
}

TEST(FieldNames, FindsFieldsByTheirPathsInFormat2) {
  const Scene scene = small_scene();
  EXPECT_EQ(id_of(scene, "Radar1.pulse.bandwidth"), "bandwidth_hz");
  EXPECT_EQ(id_of(scene, "Radar1.repetition.frequency"), "prf_hz");
  EXPECT_EQ(id_of(scene, "Radar1.carrier.first"), "carrier_hz");
  EXPECT_EQ(id_of(scene, "Recording2.sample_rate"), "sample_rate_hz");
  EXPECT_EQ(id_of(scene, "Recording1.range[0]"), "range_start_m");
  EXPECT_EQ(id_of(scene, "Target2.position_deviation.y"), "position_stddev_m.y");
  for (const ObjectKind kind : {ObjectKind::platform, ObjectKind::target, ObjectKind::radar})
    for (const Field& field : fields_of(kind)) {
      if (field.spec->type == FieldType::vector || field.spec->key.empty() || field.spec->block != nullptr) continue;
      const char* const value = field.kind == FieldKind::quantity ? "1" : "word";
      const std::string name = std::string(name_of(kind)) + "1." + std::string(field.spec->key);
      EXPECT_EQ(id_of(scene, name, value).substr(0, 5) == "none:", false) << name;
    }
}

TEST(FieldNames, TakesTheWordsOfFormat2) {
  Scene scene = small_scene();
  EXPECT_EQ(set(scene, "Recording1.processing", "matched-filter"), "");
  EXPECT_EQ(scene.simulations[0].processing, Processing::matched_filter);
  EXPECT_EQ(set(scene, "Radar1.antenna", "sinx"), "");
  EXPECT_EQ(set(scene, "Radar1.stc", "range-law"), "");
}

TEST(FieldNames, TellsANumberFromAChoiceOfTheSameName) {
  const Scene scene = small_scene();
  EXPECT_EQ(id_of(scene, "Radar1.carrier", "1GHz"), "carrier_hz");
  EXPECT_EQ(id_of(scene, "Radar1.carrier", "Stepped"), "carrier");
  EXPECT_EQ(id_of(scene, "Radar1.carrier", ".5GHz"), "carrier_hz");
}

// The law of a rotation has the path that rotation against time is called by.
TEST(FieldNames, TellsAFileFromAChoiceOfTheSameName) {
  Scene scene = small_scene();
  EXPECT_EQ(set(scene, "Platform1.rotation", "nadir"), "");
  EXPECT_EQ(scene.platforms[0].rotation_kind, Platform::Rotation::nadir);
  EXPECT_EQ(set(scene, "Platform1.rotation.type", "zero-doppler"), "");
  EXPECT_EQ(scene.platforms[0].rotation_kind, Platform::Rotation::zero_doppler);
  EXPECT_EQ(id_of(scene, "Platform1.rotation", "turns.txt"), "rotation_deg");
}

TEST(FieldNames, FindsObjectsByNameFileKindAndNumber) {
  const Scene scene = small_scene();
  const auto objects = [&](std::string_view name) { return find_named_field(scene, name, "1").objects; };
  using Ids = std::vector<ObjectId>;
  EXPECT_EQ(objects("Ship 2.b.x"), (Ids{{ObjectKind::platform, 1}}));
  EXPECT_EQ(objects("Target3.x"), (Ids{{ObjectKind::target, 2}}));
  EXPECT_EQ(objects("target[3].x"), (Ids{{ObjectKind::target, 2}}));
  EXPECT_EQ(objects("Target 3.x"), (Ids{{ObjectKind::target, 2}}));
  EXPECT_EQ(objects("Surface.corner1.x"), (Ids{{ObjectKind::surface, 0}}));
  EXPECT_EQ(objects("second.bin.bits"), (Ids{{ObjectKind::simulation, 1}}));
  EXPECT_EQ(objects("Simulation*.bits"), (Ids{{ObjectKind::simulation, 0}, {ObjectKind::simulation, 1}}));
  EXPECT_TRUE(objects("seed").empty());
}

TEST(FieldNames, FindsOptionsWithAndWithoutTheirWord) {
  const Scene scene = small_scene();
  EXPECT_EQ(id_of(scene, "seed"), "seed");
  EXPECT_EQ(id_of(scene, "options.tolerance"), "tolerance");
  EXPECT_EQ(id_of(scene, "Profile", "Classic"), "profile");
}

TEST(FieldNames, ReachesTheAtmosphereButNotTheWorld) {
  Scene scene = small_scene();
  EXPECT_EQ(id_of(scene, "Atmosphere.rain.rate"), "rain_mm_per_h");
  EXPECT_EQ(set(scene, "atmosphere.rain.rate", "20"), "");
  EXPECT_EQ(scene.atmosphere.rain_mm_per_h, 20.0);
  EXPECT_THAT(set(scene, "Atmosphere.scale_height", "8 km"), HasSubstr("does not apply"));
  EXPECT_EQ(set(scene, "Atmosphere.refraction", "exponential"), "");
  EXPECT_EQ(set(scene, "Atmosphere.scale_height", "8 km"), "");
  EXPECT_EQ(scene.atmosphere.scale_height_m, 8000.0);
  EXPECT_EQ(named_field_text(scene, find_named_field(scene, "Atmosphere.scale_height")), "8 km");
  EXPECT_THAT(id_of(scene, "Atmosphere.refractivty"), HasSubstr("did you mean refractivity?"));
  EXPECT_THAT(id_of(scene, "World.frame"), HasSubstr("change the world there"));
}

TEST(FieldNames, OfObjectsWithOneNameTakesTheOneThatHasTheField) {
  const Scene scene = small_scene();
  EXPECT_EQ(id_of(scene, "Earth.prf"), "prf_hz");
  EXPECT_EQ(id_of(scene, "Earth.x"), "position_m.x");
  EXPECT_THAT(id_of(scene, "Earth.name", "a"), HasSubstr("can mean Radar2 and Platform1"));
}

TEST(FieldNames, SaysWhatIsWrongWithAName) {
  const Scene scene = small_scene();
  EXPECT_THAT(id_of(scene, "Radar1.bandwith"), HasSubstr("did you mean bandwidth?"));
  EXPECT_THAT(id_of(scene, "Rader1.bandwidth"), HasSubstr("did you mean Radar1?"));
  EXPECT_THAT(id_of(scene, "Target4.rcs"), HasSubstr("write Target1 to Target3, or Target* for all of them"));
  EXPECT_THAT(id_of(scene, "Target.rcs"), HasSubstr("has 3 of the kind target"));
  EXPECT_THAT(id_of(scene, "Target0.rcs"), HasSubstr("has 3 of the kind target"));
  EXPECT_THAT(id_of(scene, "Geometry1.file"), HasSubstr("the scene has no geometry"));
  EXPECT_THAT(id_of(scene, "sead"), HasSubstr("did you mean seed?"));
  EXPECT_THAT(id_of(scene, "bandwidth"), HasSubstr("OBJECT.FIELD"));
  EXPECT_THAT(id_of(scene, ""), HasSubstr("no field is named"));
  EXPECT_THAT(id_of(scene, "."), HasSubstr("none"));
}

TEST(FieldNames, SetsNumbersChoicesAndOptionsInTheScene) {
  Scene scene = small_scene();
  EXPECT_EQ(set(scene, "Radar1.bandwidth", "12.5MHz"), "");
  EXPECT_EQ(scene.radars[0].bandwidth_hz, 12.5e6);
  EXPECT_EQ(set(scene, "Target*.x", "2 km"), "");
  for (const Target& target : scene.targets) EXPECT_EQ(target.position_m.x, 2000.0);
  EXPECT_EQ(set(scene, "Simulation2.bits", "12"), "");
  EXPECT_EQ(scene.simulations[0].bits, 8);
  EXPECT_EQ(scene.simulations[1].bits, 12);
  EXPECT_EQ(set(scene, "seed", "18446744073709551615"), "");
  EXPECT_EQ(scene.options.seed, 18446744073709551615U);
}

TEST(FieldNames, TakesWordsOfTheScriptLanguageForChoices) {
  Scene scene = small_scene();
  EXPECT_EQ(set(scene, "Simulation1.processing", "MATCHED_FILTER"), "");
  EXPECT_EQ(scene.simulations[0].processing, Processing::matched_filter);
  EXPECT_EQ(set(scene, "Simulation1.format", "ascii"), "");
  EXPECT_EQ(scene.simulations[0].format, FileFormat::ascii);
  EXPECT_EQ(set(scene, "Radar1.stc", "1OVERR4"), "");
  EXPECT_EQ(scene.radars[0].stc, Radar::Stc::range_law);
  EXPECT_EQ(set(scene, "Radar1.window", "ham"), "");
  EXPECT_EQ(scene.radars[0].window, Radar::Window::hamming);
  EXPECT_EQ(set(scene, "pulse", "BAND_LIMITED"), "");
  EXPECT_EQ(scene.options.pulse, PulseDefinition::band_limited);
}

TEST(FieldNames, RefusesValuesInWords) {
  Scene scene = small_scene();
  EXPECT_THAT(set(scene, "Radar1.bandwidth", "5kg"), HasSubstr("not a valid frequency"));
  EXPECT_THAT(set(scene, "Radar2.bandwidth", "5MHz"), HasSubstr("does not apply"));
  EXPECT_THAT(set(scene, "Radar1.barker_code", "13"), HasSubstr("does not apply"));
  EXPECT_THAT(set(scene, "Simulation1.bits", "0"), HasSubstr("outside"));
  EXPECT_EQ(scene, small_scene());
}

TEST(FieldNames, FunctionsAreSetByTheNamesOfDataFiles) {
  Scene scene = small_scene();
  scene.platforms.resize(1);
  scene.platforms[0].path = Platform::Path::trajectory;
  scene.platforms[0].trajectory_m.part[1].method = core::Interpolation::cubic;
  const NamedField named = find_named_field(scene, scene.platforms[0].name + ".trajectory", "a.dat");
  ASSERT_NE(named.field, nullptr) << named.failure;
  const PointsLoader load = [](const std::string& name, const FunctionBlock& block) -> NamedPoints {
    if (name != "a.dat") return {{}, "no file " + name};
    return {std::vector<std::vector<core::Knot>>(block.count, {{0.0, 1.0}, {2.0, 3.0}}), {}};
  };
  EXPECT_EQ(set_named_field(scene, named, "b.dat", load), "no file b.dat");
  EXPECT_THAT(set_named_field(scene, named, "a.dat"), HasSubstr("only a data file"));
  EXPECT_EQ(set_named_field(scene, named, "a.dat", load), "");
  const UserFunction<3>& path = scene.platforms[0].trajectory_m;
  EXPECT_EQ(path.file, "a.dat");
  EXPECT_EQ(path.part[2].knots, (std::vector<core::Knot>{{0.0, 1.0}, {2.0, 3.0}}));
  EXPECT_EQ(path.part[1].method, core::Interpolation::cubic);
}

TEST(FieldNames, EveryShortNameAndAddressFindsItsField) {
  const Scene scene = small_scene();
  const auto value_for = [](const Field& field) { return field.kind == FieldKind::quantity ? "1" : "a"; };
  for (const ObjectKind kind : all_object_kinds)
    for (std::size_t i = 0; i < count_of(scene, kind); ++i)
      for (const Field& field : fields_of(kind)) {
        const std::string name = address_of(scene, {kind, i}) + "." + short_name(fields_of(kind), field);
        const NamedField named = find_named_field(scene, name, value_for(field));
        ASSERT_EQ(named.field, &field) << name << ": " << named.failure;
        EXPECT_EQ(named.objects, (std::vector<ObjectId>{{kind, i}})) << name;
        EXPECT_EQ(named_field_text(scene, named), field_text(object_of(scene, {kind, i}), field.id)) << name;
      }
  for (const Field& field : option_fields())
    EXPECT_EQ(find_named_field(scene, short_name(option_fields(), field), value_for(field)).field, &field) << field.id;
}

TEST(FieldNames, ShortNamesOfAKindDiffer) {
  for (const ObjectKind kind : all_object_kinds) {
    std::set<std::string> names;
    for (const Field& field : fields_of(kind))
      EXPECT_TRUE(names.insert(short_name(fields_of(kind), field)).second) << field.id;
  }
}

TEST(FieldNames, EveryFieldTakesTheValueThatItHas) {
  Scene scene = small_scene();
  scene.simulations[0].radar = "Radar1";
  scene.simulations[0].sample_rate_hz = 1e6;
  const Scene before = scene;
  for (const ObjectKind kind : all_object_kinds)
    for (const Field& field : fields_of(kind)) {
      if (count_of(scene, kind) == 0 || field.kind == FieldKind::function) continue;
      if (!field_applies(object_of(scene, {kind, 0}), field.id)) continue;
      const NamedField named{{{kind, 0}}, &field, {}};
      EXPECT_EQ(set_named_field(scene, named, named_field_text(scene, named)), "") << field.id;
    }
  EXPECT_EQ(scene, before);
}

}  // namespace field_names_test
}  // namespace sarsim::scene
