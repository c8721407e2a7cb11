#include "gui/image/image_viewers.hpp"

#include <QPointer>
#include <QWidget>

#include <algorithm>
#include <string>

#include "core/os/input_file.hpp"
#include "gui/common/screen_size.hpp"
#include "gui/image/image_viewer.hpp"
#include "gui/image/open_image_dialog.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/recording_hints.hpp"

namespace sarsim::gui {

bool is_data_file(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".scr" || ending == ".toml" || ending == ".json" || ending == ".txt") return false;
  if (raster::row_from_path(path) != nullptr) return true;
  constexpr std::size_t enough = 4096;
  return core::beginning_of(path, enough).find('\0') != std::string::npos;
}

ImageViewers::ImageViewers(Session& session, QWidget* owner) : QObject(owner), session_(session), owner_(owner) {}

std::vector<ImageViewer*> ImageViewers::viewers() const {
  const auto found = owner_->findChildren<ImageViewer*>(QString(), Qt::FindDirectChildrenOnly);
  return {found.begin(), found.end()};
}

ImageViewer* ImageViewers::open_empty() {
  auto* const viewer = new ImageViewer(owner_);
  viewer->setWindowFlag(Qt::Window);
  viewer->setAttribute(Qt::WA_DeleteOnClose);
  viewer->resize(size_on_screen(*owner_, {1100, 760}));
  connect(viewer, &ImageViewer::view_changed, this, [this, viewer](const ImageView& view, picture::AxisLink link) {
    for (ImageViewer* other : viewers())
      if (other != viewer) other->follow(view, link);
  });
  connect(viewer, &ImageViewer::describe_wanted, this,
          [this, viewer] { ask(QString::fromStdString(viewer->path().string()), viewer->hints(), viewer); });
  viewer->show();
  viewer->raise();
  viewer->activateWindow();
  return viewer;
}

ImageViewer* ImageViewers::open_file(const std::filesystem::path& path) {
  ImageViewer* const viewer = open_empty();
  show_file(*viewer, path);
  return viewer;
}

void ImageViewers::show_file(ImageViewer& viewer, const std::filesystem::path& path) {
  raster::RasterHints hints;
  if (const auto known = workflow::hints_from_scene(session_.scene(), path)) hints = *known;
  hints.raw = raster::envi_layout(path);
  viewer.open(path, hints);
}

ImageViewer* ImageViewers::open_file(const std::filesystem::path& path, const raster::RasterHints& hints) {
  ImageViewer* const viewer = open_empty();
  viewer->open(path, hints);
  return viewer;
}

OpenImageDialog* ImageViewers::ask_file() { return ask({}, {}, nullptr); }

OpenImageDialog* ImageViewers::ask(const QString& path, const raster::RasterHints& hints, ImageViewer* viewer) {
  auto* const dialog = new OpenImageDialog(viewer != nullptr ? static_cast<QWidget*>(viewer) : owner_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->set_scene(session_.scene());
  if (!path.isEmpty()) dialog->show_file(path, hints);
  connect(dialog, &QDialog::accepted, this, [this, dialog, viewer = QPointer<ImageViewer>(viewer)] {
    const std::filesystem::path chosen = dialog->path().toStdString();
    if (viewer)
      viewer->open(chosen, dialog->hints());
    else
      open_file(chosen, dialog->hints());
  });
  dialog->open();
  return dialog;
}

}  // namespace sarsim::gui
