#include "gui/common/icons.hpp"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

#include "gui/common/painted_icon.hpp"

// Files in a library are found once they are asked for by the name of their list, outside of any namespace.
static void load_workbench_files() { Q_INIT_RESOURCE(workbench); }

namespace sarsim::gui {

namespace {

QColor colour_of_icon(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
  return palette.color(mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText);
}

// Asks the palette anew whenever it draws.
class LineIconEngine : public PaintedIcon {
 public:
  explicit LineIconEngine(QByteArray lines) : lines_(std::move(lines)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QByteArray coloured = lines_;
    coloured.replace("currentColor", colour_of_icon(mode).name().toLatin1());
    QSvgRenderer(coloured).render(painter, QRectF(rect));
  }

  [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(*this); }

 private:
  QByteArray lines_;
};

}  // namespace

QIcon icon_of(const QString& name) {
  load_workbench_files();
  QFile file(":/icons/" + name + ".svg");
  return file.open(QIODevice::ReadOnly) ? QIcon(new LineIconEngine(file.readAll())) : QIcon();
}

QStringList icon_names() {
  load_workbench_files();
  QStringList names;
  for (const QString& file : QDir(":/icons").entryList())
    if (file != "sarsim.svg") names += file.chopped(4);
  return names;
}

QIcon program_icon() {
  load_workbench_files();
  return QIcon(":/icons/sarsim.svg");
}

QPixmap gallery_picture(const QString& name) {
  load_workbench_files();
  return QPixmap(":/gallery/" + name + ".png");
}

}  // namespace sarsim::gui
