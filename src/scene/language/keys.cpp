#include "scene/language/keys.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene::language {

std::string_view header_of(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::simulation: return "recording";
    case ObjectKind::cloud: return "target";  // with `positions` in a file
    default: return name_of(kind);
  }
}

std::string part_key(const FunctionBlock& block, std::size_t part) {
  const std::string_view name = block.y[part].name;
  return core::lower_case(name.substr(name.rfind(' ') + 1));  // npos + 1 is 0.
}

std::string_view points_key(const FunctionBlock& block) {
  return block.list_key.empty() ? std::string_view("points") : block.list_key;
}

std::string_view interpolation_word(core::Interpolation method) {
  switch (method) {
    case core::Interpolation::linear: return "linear";
    case core::Interpolation::cubic: return "cubic";
    case core::Interpolation::low_pass: return "low-pass";
  }
  return {};
}

Quantity quantity_of(const FunctionAxis& axis) {
  static constexpr std::array<std::pair<std::string_view, Quantity>, 6> known{{{"s", Quantity::time},
                                                                               {"m", Quantity::length},
                                                                               {"deg", Quantity::angle},
                                                                               {"dB", Quantity::ratio_db},
                                                                               {"GHz", Quantity::frequency},
                                                                               {"V", Quantity::voltage}}};
  const auto found = std::ranges::find(known, axis.unit, &std::pair<std::string_view, Quantity>::first);
  return found == known.end() ? Quantity::number : found->second;
}

}  // namespace sarsim::scene::language
