#include "scene/language/keys.hpp"

#include <algorithm>

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

}  // namespace sarsim::scene::language
