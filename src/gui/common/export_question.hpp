#pragma once

#include <QString>

#include <optional>

#include "scene/model/scene.hpp"

class QWidget;

namespace sarsim::gui {

/// Where samples are to be written, and how.
struct ExportChoice {
  QString path;
  scene::FileFormat format = {};
};

/// Asks for a file to write samples into, and whether one that exists may be replaced; nothing where the user says no.
/// A name without an ending gets that of the chosen format before it is asked about; a typed ending that means a format
/// counts for more than the chosen one.
[[nodiscard]] std::optional<ExportChoice> ask_export(QWidget* parent);

}  // namespace sarsim::gui
