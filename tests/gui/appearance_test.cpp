#include <QAccessible>
#include <QAction>

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QGroupBox>
#include <QIcon>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

#include <algorithm>
#include <cmath>

#include "gui/common/appearance.hpp"
#include "gui/common/icons.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/tool_bar.hpp"
#include "gui/gui_test.hpp"

// Colours, icons and the tool bar: whether they can be seen and read.

namespace sarsim::appearance_test {

namespace {

// Relative luminance and contrast as WCAG 2.1 defines them.
double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

constexpr double of_text = 4.5;
constexpr double of_controls = 3.0;

// How much of a square picture is not its ground.
double inked(const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) count += qAlpha(picture.pixel(x, y)) > 64 ? 1 : 0;
  return static_cast<double>(count) / (picture.width() * picture.height());
}

}  // namespace

class AppearanceTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setStyle(gui::make_style()); }
  void cleanup() { gui::set_appearance(*qApp, gui::Appearance::light); }

  void the_measure_of_contrast_is_that_of_the_standard() {
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-9);
    QVERIFY(std::abs(contrast(QColor(0x77, 0x77, 0x77), Qt::white) - 4.48) < 0.005);
  }

  void text_can_be_read_in_light_and_dark_data() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }

  void text_can_be_read_in_light_and_dark() {
    QFETCH(bool, dark);
    const QPalette palette = gui::palette_of(dark);
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
        {QPalette::WindowText, QPalette::Window},
        {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},
        {QPalette::ButtonText, QPalette::Button},
        {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::Link, QPalette::Base},
        {QPalette::Link, QPalette::Window},
        {QPalette::PlaceholderText, QPalette::Base},
        {QPalette::PlaceholderText, QPalette::Window},
        {QPalette::PlaceholderText, QPalette::AlternateBase},
        {QPalette::ToolTipText, QPalette::ToolTipBase}};
    for (const auto& [text, ground] : pairs) {
      const double found = contrast(palette.color(text), palette.color(ground));
      QVERIFY2(found >= of_text, qPrintable(QString("roles %1 on %2: %3").arg(text).arg(ground).arg(found)));
    }
    for (const QPalette::ColorRole ground : {QPalette::Base, QPalette::Window}) {
      QVERIFY(contrast(gui::rim_of(palette, true), palette.color(ground)) >= of_controls);
      QVERIFY(contrast(palette.color(QPalette::Disabled, QPalette::Text), palette.color(ground)) >= of_controls);
    }
    QVERIFY(contrast(palette.color(QPalette::Highlight), palette.color(QPalette::Window)) >= of_controls || dark);
  }

  // The desktop says light or dark; the colours are ours then, too.
  void the_colours_of_the_desktop_are_as_readable() {
    const QPalette palette = qApp->style()->standardPalette();
    QVERIFY(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >= of_text);
    QVERIFY(contrast(palette.color(QPalette::Link), palette.color(QPalette::Window)) >= of_text);
  }

  void the_rim_of_a_field_is_drawn() {
    for (const bool dark : {false, true}) {
      gui::set_appearance(*qApp, dark ? gui::Appearance::dark : gui::Appearance::light);
      QLineEdit field;
      field.resize(120, 28);
      const QImage picture = field.grab().toImage();
      QVERIFY(contrast(picture.pixelColor(60, 0), field.palette().color(QPalette::Base)) >= 2.5);
    }
  }

  void a_group_of_fields_has_a_title_and_a_line_and_no_frame() {
    QWidget window;
    QVBoxLayout layout(&window);
    QGroupBox box("Pulse");
    layout.addWidget(&box);
    window.resize(300, 120);
    const QImage picture = window.grab().toImage();
    const QRect rect = box.geometry();
    const QColor ground = window.palette().color(QPalette::Window);
    const int line = rect.top() + box.fontMetrics().height() / 2;
    const auto differs = [&](int x, int y) { return picture.pixelColor(x, y) != ground; };
    bool found = false;
    for (int y = line - 2; y <= line + 2; ++y) found |= differs(rect.right() - 5, y);
    QVERIFY(found);
    for (int x = rect.left(); x < rect.right(); ++x) QVERIFY(!differs(x, rect.bottom()));
    for (int y = line + 10; y < rect.bottom(); ++y) QVERIFY(!differs(rect.left(), y));
  }

  // What Enter presses is the one that stands out.
  void the_default_button_is_in_the_colour_of_what_is_selected() {
    QDialog dialog;
    QPushButton first("First", &dialog);
    first.setDefault(true);
    first.resize(100, 30);
    const QColor ground = first.grab().toImage().pixelColor(8, 15);
    QCOMPARE(ground, dialog.palette().color(QPalette::Highlight));
  }

  void every_icon_has_lines_of_one_width_in_the_colour_of_the_text() {
    const QStringList names = gui::icon_names();
    QVERIFY(names.size() >= 20);
    for (const QString& name : names) {
      QFile file(":/icons/" + name + ".svg");
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray lines = file.readAll();
      QVERIFY2(lines.contains("stroke-width=\"1.75\"") && lines.count("stroke-width") == 1, qPrintable(name));
      QVERIFY2(lines.contains("viewBox=\"0 0 24 24\"") && lines.contains("currentColor"), qPrintable(name));
      const double ink = inked(gui::icon_of(name).pixmap(48).toImage());
      QVERIFY2(ink > 0.04 && ink < 0.5, qPrintable(QString("%1: %2").arg(name).arg(ink)));
    }
    QVERIFY(gui::icon_of("no_such_icon").isNull());
    QVERIFY(!gui::program_icon().pixmap(64).isNull());
  }

  void icons_follow_light_and_dark() {
    const QIcon icon = gui::icon_of("run");
    const auto brightest = [&] {
      const QImage picture = icon.pixmap(32).toImage();
      int best = 0;
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          if (qAlpha(picture.pixel(x, y)) > 200) best = std::max(best, qGray(picture.pixel(x, y)));
      return best;
    };
    gui::set_appearance(*qApp, gui::Appearance::light);
    QVERIFY(brightest() < 80);
    gui::set_appearance(*qApp, gui::Appearance::dark);
    QVERIFY(brightest() > 180);
  }

  void every_tool_has_icon_words_tip_and_spoken_name() {
    gui::MainWindow window;
    const auto* bar = window.findChild<gui::ToolBar*>("tool_bar");
    QVERIFY(bar != nullptr);
    int tools = 0;
    for (QAction* action : bar->actions()) {
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
      if (button == nullptr) continue;
      ++tools;
      QVERIFY2(!action->icon().isNull(), qPrintable(action->objectName()));
      QVERIFY2(!action->iconText().isEmpty() && !button->toolTip().isEmpty(), qPrintable(action->objectName()));
      QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(button);
      QVERIFY2(spoken != nullptr && !spoken->text(QAccessible::Name).isEmpty(), qPrintable(action->objectName()));
    }
    QVERIFY(tools >= 14);
    int primary = 0;
    for (const auto* button : bar->findChildren<QToolButton*>())
      primary += button->property(gui::primary_property).toBool() ? 1 : 0;
    QCOMPARE(primary, 1);
  }

  // Words go before tools do.
  void a_narrow_tool_bar_keeps_all_its_tools() {
    gui::MainWindow window;
    window.show();
    auto* bar = window.findChild<gui::ToolBar*>("tool_bar");
    bar->setParent(nullptr);
    bar->resize(4000, 40);
    bar->show();
    QCoreApplication::processEvents();
    QCOMPARE(bar->words(), gui::ToolBar::Words::all);
    QList<gui::ToolBar::Words> seen;
    for (int width = 3000; width > 300; width -= 20) {
      bar->resize(width, 40);
      QCoreApplication::processEvents();
      if (seen.isEmpty() || seen.last() != bar->words()) seen += bar->words();
      if (bar->words() == gui::ToolBar::Words::none) break;
      for (QAction* action : bar->actions())
        if (const auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
          QVERIFY2(button->geometry().right() <= bar->width(), qPrintable(action->objectName()));
    }
    QCOMPARE(seen, (QList{gui::ToolBar::Words::all, gui::ToolBar::Words::some, gui::ToolBar::Words::none}));
    delete bar;
  }
};

const test::AddTest added("appearance_test", test::run_test<AppearanceTest>);

}  // namespace sarsim::appearance_test

#include "appearance_test.moc"
