#include <QtTest>

#include <QImage>

#include "gui/common/reserved_label.hpp"
#include "gui/gui_test.hpp"

namespace sarsim::reserved_label_test {

namespace {

// Whether the words end in an ellipsis: dots at the base line of the last corner, with nothing above them.
bool is_marked_as_cut(gui::ReservedLabel& label) {
  const QImage seen = label.grab().toImage();
  const int line = label.fontMetrics().height();
  const int left = seen.width() - label.fontMetrics().horizontalAdvance(QStringLiteral("…"));
  const QColor ground = label.palette().color(label.backgroundRole());
  const auto has_ink = [&](int top, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < seen.width(); ++x)
        if (std::abs(seen.pixelColor(x, y).lightness() - ground.lightness()) > 60) return true;
    return false;
  };
  return !has_ink(seen.height() - line, seen.height() - line / 2) && has_ink(seen.height() - line / 2, seen.height());
}

}  // namespace

class ReservedLabelTest : public QObject {
  Q_OBJECT

 private slots:
  void words_without_room_end_in_an_ellipsis() {
    gui::ReservedLabel label(2);
    label.resize(200, label.height());
    label.say(QString("WHW").repeated(5) + QString(" HWH WHW").repeated(20));
    label.show();
    QVERIFY(is_marked_as_cut(label));
    QCOMPARE(label.toolTip(), label.text());
    label.say("HWH");
    QVERIFY(!is_marked_as_cut(label));
    label.say(QString("HWH WHW ").repeated(6));
    QVERIFY(is_marked_as_cut(label));
    label.resize(800, label.height());
    QVERIFY(!is_marked_as_cut(label));
    QFont large = label.font();
    large.setPointSizeF(4.0 * large.pointSizeF());
    label.setFont(large);
    QVERIFY(is_marked_as_cut(label));
  }

  void the_room_is_that_of_its_lines_whatever_it_says() {
    gui::ReservedLabel label(3);
    const int room = label.height();
    QVERIFY(room >= 3 * label.fontMetrics().height());
    for (const QString& words : {QString(), QString("one"), QString("many words ").repeated(50)}) {
      label.say(words);
      QCOMPARE(label.sizeHint().boundedTo(label.maximumSize()).expandedTo(label.minimumSize()).height(), room);
    }
  }
};

namespace {
const test::AddTest added("reserved_label_test", test::run_test<ReservedLabelTest>);
}  // namespace

}  // namespace sarsim::reserved_label_test

#include "reserved_label_test.moc"
