#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/schema/field_table.hpp"
#include "scene/script/reader.hpp"

namespace sarsim::scene::test {

/// Scenes of random content for tests: every alternative of every field, numbers of all sizes and precisions, names
/// that need quotes. Fields that mean nothing keep their initial values. What fields there are, and what they may hold,
/// is in their tables.
class RandomScenes {
 public:
  /// @param language  what it can say; the script language has fewer fields
  explicit RandomScenes(std::uint64_t seed, Language language = Language::script)
      : engine_(seed), format_2_(language == Language::format_2) {}

  Scene scene() {
    Scene scene;
    for_each_kind([&](const auto& kind) {
      auto& objects = scene.*kind.list;
      for (std::uint64_t i = below(4); i > 0; --i)
        objects.push_back(object<typename std::remove_cvref_t<decltype(objects)>::value_type>());
    });
    for (const FieldOf<RunOptions>& field : table_of<RunOptions>().fields())
      if (coin()) draw(field, scene.options);
    if (format_2_ && coin()) {
      scene.world = object<World>();
      scene.world.geoid.clear();  // names a file that is read
    }
    return scene;
  }

  /// A number that a scene may hold: zero, a typed-looking decimal, a whole number, or all 64 bits at random.
  double number() {
    switch (below(5)) {
      case 0: return 0.0;
      case 1: return static_cast<double>(below(20001)) - 10000.0;
      case 2: return (static_cast<double>(below(2000001)) - 1e6) / 1000.0;
      case 3: return std::ldexp(uniform() - 0.5, static_cast<int>(below(110)) - 60);
      default: return any_bits();
    }
  }

 private:
  std::uint64_t below(std::uint64_t limit) { return engine_() % limit; }
  bool coin() { return below(2) == 0; }
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Finite, of a magnitude that survives the change of units (GHz to Hz and back).
  double any_bits() {
    const double mantissa = 1.0 + uniform();
    const double value = std::ldexp(mantissa, static_cast<int>(below(1000)) - 950);
    return coin() ? value : -value;
  }

  double number_in(const Range& range) {
    if (!std::isfinite(range.low)) return std::min(number(), range.high);
    if (std::isfinite(range.high)) return coin() ? range.low : range.low + (range.high - range.low) * uniform();
    const double above = std::abs(number());
    return range.low_excluded && above == 0.0 ? range.low + 1e-3 : range.low + above;
  }
  double whole_number_in(const Range& range) {
    return range.low + static_cast<double>(below(static_cast<std::uint64_t>(range.high - range.low) + 1));
  }

  std::string name() {
    static constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.:;/\\$!\"' ,\t#%()\xC3\xB6\xB0";
    std::string text;
    const std::uint64_t usual = below(4) > 0 ? 52 : letters.size();
    for (std::uint64_t i = 1 + below(20); i > 0; --i) text += letters[below(usual)];
    return text;
  }

  core::SampledFunction sampled(const FunctionBlock& block) {
    core::SampledFunction function;
    function.method = static_cast<core::Interpolation>(below(3));
    double x = std::ldexp(uniform() - 0.5, 10);
    for (std::uint64_t i = below(6); i > 0; --i) {
      function.knots.push_back({block.x_ignored ? number() : x, number_in(range_of_y(block))});
      x += std::ldexp(1.0 + uniform(), static_cast<int>(below(20)) - 10);
    }
    return function;
  }

  void draw(const FieldSpec& spec, FieldValue& value) {
    switch (spec.type) {
      case FieldType::choice: return draw_choice(spec, value);
      case FieldType::check: value = coin(); return;
      case FieldType::flags: value = whole_number_in(spec.range); return;
      case FieldType::number:
        value = spec.quantity == Quantity::count ? whole_number_in(spec.range) : number_in(spec.range);
        return;
      case FieldType::seed: value = std::uint64_t{engine_()}; return;
      case FieldType::vector:
        value = core::Vec3{number_in(spec.range), number_in(spec.range), number_in(spec.range)};
        return;
      case FieldType::text:
      case FieldType::name: value = name(); return;
      case FieldType::function:
      case FieldType::list: return;
    }
  }

  void draw_choice(const FieldSpec& spec, FieldValue& value) {
    std::vector<Choice> choices = spec.choices;
    if (!format_2_) std::erase_if(choices, [](const Choice& choice) { return choice.since_2(); });
    choose(value, choices[below(choices.size())].value);
  }

  template <class Object>
  void draw(const FieldOf<Object>& field, Object& object) {
    if (field.function != nullptr) {
      for (core::SampledFunction& part : field.function(object).parts) part = sampled(*field.spec.block);
      return;
    }
    if (field.list != nullptr)
      return visit_elements(field.spec.list, field.list(object), [&]<class Element>(std::vector<Element>& list) {
        for (std::uint64_t i = below(4); i > 0; --i) list.push_back(this->object<Element>());
      });
    FieldValue value = field.get(object);
    draw(field.spec, value);
    field.put(object, value);
  }

  // A choice stands before what depends on it.
  template <class Object>
  Object object() {
    Object object;
    for (const FieldOf<Object>& field : table_of<Object>().fields())
      if (table_of<Object>().applies(object, field) && (format_2_ || !field.spec.since_2)) draw(field, object);
    return object;
  }

  std::mt19937_64 engine_;
  bool format_2_;
};

}  // namespace sarsim::scene::test
