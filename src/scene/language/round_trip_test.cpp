#include <gtest/gtest.h>

#include "scene/language/scene_reader.hpp"
#include "scene/language/scene_writer.hpp"
#include "scene/model/object.hpp"
#include "scene/script/random_scene_test_support.hpp"
#include "scene/script/writer.hpp"

namespace sarsim::scene {

namespace {

// Scripts may hold names in any coding, format 2 in UTF-8 alone.
template <class Object>
void make_ascii(Object& object) {
  for (const FieldOf<Object>& field : table_of<Object>().fields()) {
    if (field.spec.type != FieldType::text && field.spec.type != FieldType::name) continue;
    FieldValue value = field.get(object);
    if ((field.spec.optional || field.spec.since_2) && std::get<std::string>(value).empty()) continue;
    for (char& c : std::get<std::string>(value)) c = static_cast<char>(c & 0x7F);
    std::erase_if(std::get<std::string>(value), [](char c) { return c < 0x20; });
    std::get<std::string>(value) += '~';
    field.put(object, value);
  }
}

// The scenes of the generator name platforms and radars that nobody defines; format 2 asks for them.
void define_names(Scene& scene) {
  for_each_kind([&](const auto& kind) {
    for (auto& object : scene.*kind.list) make_ascii(object);
  });
  make_ascii(scene.world);
  std::vector<std::string> platforms{"Earth"};
  std::vector<std::string> radars;
  for (const Platform& platform : scene.platforms) platforms.push_back(platform.name);
  for (const Radar& radar : scene.radars) radars.push_back(radar.name);
  const auto meant = [](const std::vector<std::string>& names, const std::string& name) {
    return names.empty() ? std::string() : names[std::hash<std::string>()(name) % names.size()];
  };
  for (Platform& platform : scene.platforms) {
    if (!platform.parent.empty()) platform.parent = meant(platforms, platform.parent);
    if (!platform.leader.empty()) platform.leader = meant(platforms, platform.leader);
  }
  for (Target& target : scene.targets) target.platform = meant(platforms, *target.platform);
  for (Cloud& cloud : scene.clouds) cloud.platform = meant(platforms, cloud.platform);
  for (Surface& surface : scene.surfaces) surface.platform = meant(platforms, surface.platform);
  for (Radar& radar : scene.radars) radar.platform = meant(platforms, radar.platform);
  for (Simulation& simulation : scene.simulations) simulation.radar = meant(radars, simulation.radar);
  for (GeometryTable& table : scene.geometries) table.radar = meant(radars, table.radar);
}

// Files of functions are not there.
DataFileLoader no_files() {
  return [](const std::string& name) { return DataFileText{name, {}, "not there"}; };
}

std::string errors_of(const core::Problems& problems) {
  std::string text;
  for (const core::Problem& problem : problems)
    if (problem.severity == core::Severity::error) text += core::to_string(problem) + "\n";
  return text;
}

template <class Object>
std::string fields_that_differ(const Object& a, const Object& b) {
  std::string text;
  for (const FieldOf<Object>& field : table_of<Object>().fields())
    if (!(field.get(a) == field.get(b))) text += " " + std::string(field.spec.id);
  return text;
}

std::string first_difference(const Scene& a, const Scene& b) {
  std::string text;
  for_each_kind([&](const auto& kind) {
    const auto& first = a.*kind.list;
    const auto& second = b.*kind.list;
    if (first.size() != second.size()) text += std::string(kind.name) + ": another number of them; ";
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
      if (!(first[i] == second[i]))
        text += std::string(kind.name) + " " + std::to_string(i) + ":" + fields_that_differ(first[i], second[i]) + "; ";
  });
  if (!(a.options == b.options)) text += "options";
  if (!(a.world == b.world)) text += "world";
  return text;
}

}  // namespace

TEST(Format2RoundTrip, RandomScenesComeBackBitForBit) {
  test::RandomScenes random(2026, Language::format_2);
  for (int i = 0; i < 1000; ++i) {
    Scene scene = random.scene();
    define_names(scene);
    for (const Saying saying : {Saying::differences, Saying::everything}) {
      const std::string text = write_format_2(scene, saying);
      const ScriptReading back = read_format_2(text, "scene.toml", no_files());
      ASSERT_EQ(errors_of(back.problems), "") << text;
      ASSERT_EQ(back.scene, scene) << first_difference(scene, back.scene) << "\n" << text;
    }
  }
}

TEST(Format2RoundTrip, ThroughTheLanguageOf1998AndBackTheScriptIsTheSame) {
  test::RandomScenes random(1998);
  for (int i = 0; i < 300; ++i) {
    Scene scene = random.scene();
    define_names(scene);
    const std::string script = write_script(scene);
    const ScriptReading read = read_script(script, "scene.scr", no_files());
    const ScriptReading back = read_format_2(write_format_2(read.scene), "scene.toml", no_files());
    ASSERT_EQ(errors_of(back.problems), "");
    ASSERT_EQ(write_script(back.scene), script);
  }
}

}  // namespace sarsim::scene
