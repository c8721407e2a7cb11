#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QStyleOptionComboBox>
#include <QToolButton>
#include <QtTest>

#include "gui/common/appearance.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/gui_test.hpp"
#include "gui/image/image_viewers.hpp"
#include "harbour.hpp"
#include "image_viewer_bench.hpp"
#include "scene/model/object.hpp"

// Words that do not fit into what shows them, in all windows at their first size. Run at scales of 100, 150 and 200 %.

namespace sarsim::cut_text_test {

namespace {

double scale() { return qEnvironmentVariable("QT_SCALE_FACTOR", "1").toDouble(); }

QString plain(QString text) {
  text.remove(QRegularExpression("<[^>]*>"));
  return text.remove('&');
}

// How many pixels of a label's text are missing.
int missing(const QLabel& label) {
  if (label.text().isEmpty() || label.textFormat() == Qt::RichText || label.text().startsWith('<')) return 0;
  const QRect room = label.contentsRect();
  if (label.wordWrap()) return label.heightForWidth(label.width()) - label.height();
  int width = 0;
  for (const QString& line : plain(label.text()).split('\n'))
    width = std::max(width, label.fontMetrics().horizontalAdvance(line));
  return width - room.width();
}

int missing(const QComboBox& box) {
  if (box.isEditable() || box.currentText().isEmpty()) return 0;
  QStyleOptionComboBox option;
  option.initFrom(&box);
  const QRect room = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
  return box.fontMetrics().horizontalAdvance(box.currentText()) - room.width();
}

int missing(const QAbstractButton& button) {
  if (button.text().isEmpty()) return 0;
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) return 0;
  int needed = button.fontMetrics().horizontalAdvance(plain(button.text()));
  if (!button.icon().isNull()) needed += button.iconSize().width() + 4;
  if (qobject_cast<const QCheckBox*>(&button) != nullptr)
    needed += button.style()->pixelMetric(QStyle::PM_IndicatorWidth) +
              button.style()->pixelMetric(QStyle::PM_CheckBoxLabelSpacing);
  return needed - button.width();
}

QString path_to(const QWidget& widget) {
  QString path = widget.objectName().isEmpty() ? widget.metaObject()->className() : widget.objectName();
  for (const QWidget* at = widget.parentWidget(); at != nullptr; at = at->parentWidget())
    if (!at->objectName().isEmpty() && !at->objectName().startsWith("qt_")) return at->objectName() + "/" + path;
  return path;
}

QStringList cut_headers(const QHeaderView& header) {
  QStringList found;
  if (header.model() == nullptr || header.orientation() != Qt::Horizontal) return found;
  for (int i = 0; i < header.count(); ++i) {
    const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
    const int missing_px = header.fontMetrics().horizontalAdvance(text.section('\n', 0, 0)) - header.sectionSize(i);
    if (!header.isSectionHidden(i) && missing_px > 0)
      found += QString("%1 column '%2': %3 px").arg(path_to(header), text).arg(missing_px);
  }
  return found;
}

// Buttons of functions elide their summary themselves, and say all of it in their tip, as lists of names do that users
// gave.
bool elides_itself(const QWidget& widget) {
  if (const auto* list = qobject_cast<const QComboBox*>(&widget); list != nullptr && !list->currentText().isEmpty())
    return list->toolTip().endsWith(": " + list->currentText());
  return widget.objectName().startsWith("field_") && qobject_cast<const QPushButton*>(&widget) != nullptr &&
         !widget.toolTip().isEmpty();
}

// The cut texts of a window; those of hidden pages of tabs do not count.
QStringList cut_texts(const QWidget& window) {
  QStringList found;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&window) || widget->window() != window.window() || elides_itself(*widget)) continue;
    int missing_px = 0;
    QString text;
    if (const auto* label = qobject_cast<const QLabel*>(widget))
      missing_px = missing(*label), text = label->text();
    else if (const auto* box = qobject_cast<const QComboBox*>(widget))
      missing_px = missing(*box), text = box->currentText();
    else if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
      missing_px = missing(*button), text = button->text();
    else if (const auto* header = qobject_cast<const QHeaderView*>(widget))
      found += cut_headers(*header);
    if (missing_px > 0) found += QString("%1 '%2': %3 px").arg(path_to(*widget), text).arg(missing_px);
  }
  return found;
}

// What is still cut when the layout has settled, which takes some events, and longer on a machine with other work.
QStringList cut_for_good(const QWidget& window, const QString& name) {
  QTest::qWait(20);
  static_cast<void>(QTest::qWaitFor([&] { return cut_texts(window).isEmpty(); }, 2000));
  QStringList found;
  for (const QString& text : cut_texts(window)) found += name + ": " + text;
  return found;
}

}  // namespace

class CutTextTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QApplication::setStyle(gui::make_style());
    QCOMPARE(QApplication::primaryScreen()->devicePixelRatio(), scale());
  }

  void the_walk_finds_what_is_cut() {
    QWidget window;
    auto* label = new QLabel("The largest magnitude", &window);
    label->resize(20, 20);
    auto* box = new QComboBox(&window);
    box->addItem("Simple sin(x)/x");
    box->resize(40, 24);
    auto* button = new QPushButton("Compressed", &window);
    button->resize(30, 24);
    QCOMPARE(cut_texts(window).size(), 3);
    label->adjustSize();
    box->adjustSize();
    button->adjustSize();
    QVERIFY2(cut_texts(window).isEmpty(), qPrintable(cut_texts(window).join('\n')));
  }

  void no_window_cuts_its_words_data() {
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QSize>("size");
    const QString harbour = test::small_harbour(folder_.path());
    QTest::newRow("harbour") << harbour << QSize();
    if (scale() != 1.0) return;  // What differs between scenes does so at any scale.
    QTest::newRow("letter R") << SARSIM_SOURCE_DIR "/examples/sar_r.toml" << QSize();
    QTest::newRow("harbour, small screen") << harbour << QSize(1366, 768);
  }

  void no_window_cuts_its_words() {
    QFETCH(QString, scene);
    QFETCH(QSize, size);
    gui::MainWindow main;
    if (!size.isEmpty()) main.resize(size);
    QVERIFY(main.documents().open_file(scene));
    main.show();
    QVERIFY(QTest::qWaitForWindowExposed(&main));
    QStringList found;
    const auto look = [&](const QString& name) {
      QWidget* window = main.window_named(name);
      if (window == nullptr) return;
      window->show();
      found += cut_for_good(*window, name);
      if (window->isWindow() && window != &main) window->hide();
    };
    for (const QString& name : gui::MainWindow::window_names()) look(name);
    QWidget* const image = main.window_named("image");
    image->findChild<QToolButton*>("live_more")->click();
    found += cut_for_good(*image, "image with its options");
    for (const scene::ObjectKind kind :
         {scene::ObjectKind::platform, scene::ObjectKind::target, scene::ObjectKind::surface, scene::ObjectKind::radar,
          scene::ObjectKind::simulation, scene::ObjectKind::geometry})
      for (std::size_t i = 0; i < std::min<std::size_t>(2, scene::count_of(main.session().scene(), kind)); ++i) {
        main.session().select_only({kind, i});
        look("properties");
      }
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
  }

  void no_viewer_cuts_its_words() {
    QTemporaryDir folder;
    const QString file = folder.filePath("r.img");
    QProcess::execute(SARSIM_PROGRAM, {"focus", SARSIM_SOURCE_DIR "/examples/sar_r.toml", "--out", file, "--quiet"});
    gui::MainWindow main;
    QVERIFY(main.open_any(file));
    gui::ImageViewer& viewer = *main.image_viewers().viewers()[0];
    viewer.show();
    QVERIFY(test::wait_until_open(viewer) && test::wait_for_picture(viewer));
    QStringList found = cut_for_good(viewer, "viewer");
    for (const char* tool : {"image_show_cuts", "image_show_statistics", "image_reading_tool", "image_show_targets"}) {
      viewer.findChild<QToolButton*>(tool)->click();
      found += cut_for_good(viewer, QString("viewer with ") + tool);
    }
    auto* const draw_as = viewer.findChild<QComboBox*>("image_draw_as");
    for (int i = draw_as->count() - 1; i >= 0; --i) {
      draw_as->setCurrentIndex(i);
      emit draw_as->activated(i);
      found += cut_for_good(viewer, "viewer with " + draw_as->currentText());
    }
    const QPointF middle = viewer.plot().rect().center();
    QTest::mouseClick(&viewer.plot(), Qt::LeftButton, {}, middle.toPoint());
    found += cut_for_good(viewer, "viewer with a point");
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
  }

 private:
  QTemporaryDir folder_;
};

const test::AddTest added("cut_text_test", test::run_test<CutTextTest>);

}  // namespace sarsim::cut_text_test

#include "cut_text_test.moc"
