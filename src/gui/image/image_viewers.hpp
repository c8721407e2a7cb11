#pragma once

#include <QObject>

#include <filesystem>
#include <vector>

#include "gui/common/session.hpp"
#include "raster/format/open_raster.hpp"

class QWidget;

namespace sarsim::gui {

class ImageViewer;
class OpenImageDialog;

/// Whether a file is one of samples or a picture rather than a script: by its extension, otherwise because it begins
/// with bytes that no text has.
[[nodiscard]] bool is_data_file(const std::filesystem::path& path);

/// The image viewers of a workbench: opens them, lets linked ones follow each other.
class ImageViewers : public QObject {
  Q_OBJECT

 public:
  /// @param owner  of the windows; they stay above it and end with it
  ImageViewers(Session& session, QWidget* owner);

  /// A viewer of a file; shape and bits of Sarsim's own formats come from the scene where it writes such a file.
  ImageViewer* open_file(const std::filesystem::path& path);
  /// Shows such a file in a viewer that is there.
  void show_file(ImageViewer& viewer, const std::filesystem::path& path);
  /// A viewer of a file that is stored so.
  ImageViewer* open_file(const std::filesystem::path& path, const raster::RasterHints& hints);
  /// A viewer without a file.
  ImageViewer* open_empty();
  /// Asks which file, and how it is stored.
  OpenImageDialog* ask_file();
  /// Those that are open.
  [[nodiscard]] std::vector<ImageViewer*> viewers() const;

 private:
  OpenImageDialog* ask(const QString& path, const raster::RasterHints& hints, ImageViewer* viewer);

  Session& session_;
  QWidget* owner_;
};

}  // namespace sarsim::gui
