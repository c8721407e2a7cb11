#include "scene/edit/script_values.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "scene/edit/splice_command.hpp"
#include "scene/model/kinds.hpp"
#include "scene/model/object.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/script/random_scene_test_support.hpp"

namespace sarsim::scene {
namespace script_values_test {

TEST(AsScriptSays, DropsWhatAChoiceMakesMeaningless) {
  Radar radar;
  radar.bandwidth_hz = 7e6;  // of a chirp, but the pulse is monochrome
  EXPECT_TRUE(as_script_says(radar, {}) == AnyObject(Radar{}));
}

TEST(AsScriptSays, ReplacesControlCharactersInNames) {
  Platform platform;
  platform.name = "two\nlines";
  EXPECT_EQ(std::get<Platform>(as_script_says(platform, {})).name, "two_lines");
}

TEST(AsScriptSays, KeepsFaultyValues) {
  Radar radar;
  radar.prf_hz = -5.0;
  EXPECT_TRUE(as_script_says(radar, {}) == AnyObject(radar));
}

TEST(AsScriptSays, KeepsAnObjectWhoseChoiceIsNone) {
  Target target;
  target.traits.edit().reflectivity = static_cast<Target::Reflectivity>(7);
  target.traits.edit().azimuth = core::Angle::from_deg(3.0);
  EXPECT_TRUE(as_script_says(target, {}) == AnyObject(target));
}

// By definition: the writer's text, read again.
AnyObject written_and_read(const AnyObject& object, const DataFileLoader& loader) {
  AnyObject named = object;
  make_names_sayable(named);
  const ScriptReading reading = read_command_text(command_text(named), loader);
  if (core::has_errors(reading.problems)) return named;
  return only_object(reading.scene).value_or(named);
}

RunOptions written_and_read(const RunOptions& options) {
  const ScriptReading reading = read_command_text(command_text(options), {});
  return core::has_errors(reading.problems) ? options : reading.scene.options;
}

// A text that differs where any bit of two objects does: == knows neither the sign of a zero nor two equal NaN.
class Bits {
 public:
  void add(double value) { text_ += std::to_string(std::bit_cast<std::uint64_t>(value)) + ' '; }
  void add(const core::Vec3& value) { add(value.x), add(value.y), add(value.z); }
  void add(const std::string& value) { text_ += value + '\0'; }
  void add(std::uint64_t value) { text_ += std::to_string(value) + ' '; }
  void add(int value) { text_ += std::to_string(value) + ' '; }
  void add(bool value) { text_ += value ? 'y' : 'n'; }
  void add(const ConstFunctionRef& function) {
    add(*function.file);
    for (const core::SampledFunction& part : function.parts) {
      add(static_cast<int>(part.method));
      for (const core::Knot& knot : part.knots) add(knot.x), add(knot.y);
    }
  }
  void add(const ConstListRef& list) {
    visit_elements(list.kind, list.list, [&](const auto& elements) {
      for (const auto& element : elements) text_ += of(element);
    });
  }
  template <class Object>
  static std::string of(const Object& object) {
    Bits bits;
    for (const auto& field : table_of<Object>().fields()) {
      bits.add(std::string(field.spec.id));
      std::visit([&](const auto& value) { bits.add(value); }, field.get(object));
    }
    return bits.text_;
  }

 private:
  std::string text_;
};

std::string bits_of(const AnyObject& object) {
  return std::visit([](const auto& any) { return Bits::of(any); }, object);
}

DataFileText data_file(const std::string& name) {
  if (name == "three.dat") return {"/three.dat", "2\n0, 1\n1, 2\n1\n0, -0.0\n2\n3, 4.5\n5, 6E-320\n", ""};
  if (name == "one.dat") return {"/one.dat", "2\n0, 1\n1, 2\n", ""};
  if (name == "down.dat") return {"/down.dat", "2\n1, 1\n0, 2\n2\n1, 1\n0, 2\n2\n1, 1\n0, 2\n", ""};
  if (name == "words.dat") return {"/words.dat", "nothing but words", ""};
  if (name == "empty.dat") return {"/empty.dat", "", ""};
  if (name == "unreadable.dat") return {"", "", "data file cannot be read"};
  return {};
}

// Changes of objects without regard to what makes sense.
class Vandal {
 public:
  explicit Vandal(std::uint64_t seed) : engine_(seed) {}

  template <class Object>
  void damage(Object& object) {
    const auto& fields = table_of<Object>().fields();
    for (std::uint64_t i = below(4); i > 0; --i) {
      const auto& field = fields[below(fields.size())];
      if (field.function != nullptr) {
        damage(field.function(object));
      } else {
        FieldValue value = field.get(object);
        damage(field.spec, value);
        field.put(object, value);
      }
    }
  }

 private:
  std::uint64_t below(std::uint64_t limit) { return engine_() % limit; }
  template <class Value, std::size_t N>
  Value one_of(const std::array<Value, N>& values) {
    return values[below(N)];
  }

  double number() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double denormal = std::numeric_limits<double>::denorm_min();
    static const std::array<double, 24> numbers{
        0.0,      -0.0,   1.0,   -1.0,  infinity, -infinity, std::nan(""), denormal, -denormal,
        1e-310,   1e-300, 1e-20, 1e18,  -1e18,    1e17,      1e27,         1e300,    std::nextafter(1e18, 2e18),
        1.79e308, 0.1,    300.0, 300.5, 360.0,    1e-5};
    if (below(3) > 0) return one_of(numbers);
    return std::bit_cast<double>(engine_());
  }
  int integer() {
    return one_of(
        std::array<int, 9>{0, -1, 1, 6, 7, 64, 1001, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()});
  }
  std::string name() {
    static const std::array<std::string, 20> names{"",     " ",    "a\nb",      "\r", "\x01",  "tab\tbed",    "\"",
                                                   "a\"b", "\"\"", "$TARGET x", "!",  "a!b",   "\x1a",        "\x7f",
                                                   ",",    "ISO",  "1E5",       "\n", "OTHER", "\xEF\xBB\xBF"};
    return one_of(names);
  }

  // What only format 2 can say is none of the script's business.
  void damage(const FieldSpec& spec, FieldValue& value) {
    if (spec.since_2) return;
    std::vector<Choice> choices = spec.choices;
    std::erase_if(choices, [](const Choice& choice) { return choice.since_2(); });
    const bool whole = spec.quantity == Quantity::count || spec.type != FieldType::number;
    if (!spec.choices.empty() && (spec.type != FieldType::choice || has_words(spec)))
      choose(value, spec.type == FieldType::check ? static_cast<int>(below(2)) : choices[below(choices.size())].value);
    else if (auto* const number_held = std::get_if<double>(&value))
      *number_held = whole ? integer() : number();
    else if (auto* const vector = std::get_if<core::Vec3>(&value))
      (below(3) == 0 ? vector->x : below(2) == 0 ? vector->y : vector->z) = number();
    else if (auto* const text = std::get_if<std::string>(&value))
      *text = name();
    else if (auto* const seed = std::get_if<std::uint64_t>(&value))
      *seed = below(2) == 0 ? engine_() : 0;
  }

  void damage(const FunctionRef& function) {
    static const std::array<std::string, 9> files{
        "three.dat", "one.dat", "down.dat", "words.dat", "empty.dat", "missing", "unreadable.dat", "three.dat\n", ""};
    core::SampledFunction& part = function.parts[below(function.parts.size())];
    switch (below(6)) {
      case 0: *function.file = one_of(files); break;
      case 1: part.knots.clear(); break;
      case 2: part.knots.push_back({number(), number()}); break;
      case 3: part.knots.assign({{0.0, 1.0}, {0.0, 2.0}}); break;
      case 4: part.knots.assign({{-0.0, 5.0}, {1e-310, number()}, {7.0, -0.0}}); break;
      default: part.method = static_cast<core::Interpolation>(below(8) == 0 ? 9 : below(3));
    }
  }

  std::mt19937_64 engine_;
};

template <class Object>
void expect_as_written(const Object& object, const DataFileLoader& loader) {
  const AnyObject held = object;
  const AnyObject said = as_script_says(held, loader);
  ASSERT_EQ(bits_of(said), bits_of(written_and_read(held, loader))) << command_text(held);
}

void expect_as_written(const RunOptions& options) {
  ASSERT_EQ(Bits::of(as_script_says(options)), Bits::of(written_and_read(options))) << command_text(options);
}

TEST(AsScriptSays, IsWhatTheWriterWritesAndTheReaderReads) {
  constexpr std::uint64_t seed = 20;
  constexpr int scenes = 1500;
  test::RandomScenes random(seed);
  Vandal vandal(seed);
  std::size_t objects = 0;
  std::size_t changed = 0;
  for (int i = 0; i < scenes && !testing::Test::HasFatalFailure(); ++i) {
    Scene scene = random.scene();
    const DataFileLoader loader = i % 10 == 0 ? DataFileLoader{} : data_file;
    for_each_kind([&](const auto& kind) {
      for (auto& object : scene.*kind.list) {
        expect_as_written(object, loader);
        vandal.damage(object);
        expect_as_written(object, loader);
        ++objects;
        if (bits_of(as_script_says(object, loader)) != bits_of(object)) ++changed;
      }
    });
    expect_as_written(scene.options);
    vandal.damage(scene.options);
    expect_as_written(scene.options);
  }
  EXPECT_GT(objects, 10'000U);
  EXPECT_GT(changed, 1'000U);
}

}  // namespace script_values_test
}  // namespace sarsim::scene
