#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "scene/model/scene.hpp"
#include "scene/schema/expression.hpp"
#include "scene/schema/field_names.hpp"

namespace sarsim::workflow {

/// How a name of [let] is called where fields are named: "let.speed".
inline constexpr std::string_view let_prefix = "let.";

/// What has names in a scene.
struct NamedThings {
  const scene::Scene& scene;
  const scene::LetNames& names;  ///< Of [let], resolved.
};

/// A field that a name means, or a name of [let].
struct SweptField {
  scene::NamedField named;
  /// Where it is a name of [let]: what `named.field` points to. It has a quantity where one has its dimension; else it
  /// takes any text.
  std::shared_ptr<const scene::Field> let;
};

/// Finds what "Radar1.bandwidth", "seed" or "let.speed" means.
/// @param value  as of scene::find_named_field
[[nodiscard]] SweptField find_swept_field(const NamedThings& things, std::string_view name, std::string_view value);

}  // namespace sarsim::workflow
