#pragma once

#include <QIcon>
#include <QPalette>

#include "core/report/problem.hpp"
#include "scene/model/object_id.hpp"

namespace sarsim::gui {

/// A small drawing of a kind of object, as the scene shows it: a disc for a target, a beam for a radar, axes for a
/// platform, a triangle for a surface. Sharp at any size.
[[nodiscard]] QIcon object_icon(scene::ObjectKind kind, const QPalette& palette);

/// The same with a mark at the lower right: a cross for an error, an exclamation mark for a warning.
[[nodiscard]] QIcon object_icon(scene::ObjectKind kind, const QPalette& palette, core::Severity mark);

}  // namespace sarsim::gui
