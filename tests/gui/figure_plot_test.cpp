#include <QtTest>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "gui/common/appearance.hpp"
#include "gui/common/figure_plot.hpp"
#include "gui/common/plot_frame.hpp"
#include "gui/gui_test.hpp"

namespace sarsim::figure_plot_test {

namespace {

// A picture of four cells, red where y is low and x is low.
picture::Figure four_cells() {
  picture::Figure figure;
  picture::FigurePanel& panel = figure.panels.emplace_back();
  panel.x = {"Slant range", "m", 1000.0, 3000.0, picture::FigureAxis::Twin{"Delay", "s", 1.0 / 1.5e8}};
  panel.y = {"Time", "s", 0.0, 2.0, {}};
  panel.image =
      picture::FigureImage{2, 2, 1000.0, 3000.0, 0.0, 2.0, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}}};
  panel.colour_bar = picture::FigureColourBar{"Magnitude", "V", 0.0, 1e-9, {{0, 0, 0}, {255, 255, 255}}};
  return figure;
}

// The same as a map, in metres along both axes.
picture::Figure map_of_four_cells() {
  picture::Figure figure = four_cells();
  picture::FigurePanel& panel = figure.panels[0];
  panel.x = {"East", "m", -900.0, 900.0, {}};
  panel.y = {"North", "m", -700.0, 700.0, {}};
  panel.image = picture::FigureImage{2, 2, -900.0, 900.0, -700.0, 700.0, panel.image->cells};
  return figure;
}

QPoint pixel_of(const gui::FigurePlot& plot, double x, double y) {
  const QCPAxisRect* rect = plot.panel(0);
  return {static_cast<int>(rect->axis(QCPAxis::atBottom)->coordToPixel(x)),
          static_cast<int>(rect->axis(QCPAxis::atLeft)->coordToPixel(y))};
}

}  // namespace

class FigurePlotTest : public QObject {
  Q_OBJECT

 private slots:
  void another_figure_leaves_nothing_of_the_one_before() {
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    const qsizetype groups = plot.findChildren<QCPMarginGroup*>().size();
    for (int i = 0; i < 5; ++i) plot.set_figure(four_cells());
    QCOMPARE(plot.findChildren<QCPMarginGroup*>().size(), groups);
  }

  void cells_stand_where_the_axes_say() {
    gui::FigurePlot plot;
    plot.resize(600, 400);
    plot.set_figure(four_cells());
    const QImage picture = plot.toPixmap(600, 400).toImage();
    plot.grab();  // Lays out at this size.
    const QImage seen = plot.grab().toImage();
    QCOMPARE(seen.pixelColor(pixel_of(plot, 1500, 0.5)), QColor(255, 0, 0));
    QCOMPARE(seen.pixelColor(pixel_of(plot, 2500, 0.5)), QColor(0, 255, 0));
    QCOMPARE(seen.pixelColor(pixel_of(plot, 1500, 1.5)), QColor(0, 0, 255));
    QCOMPARE(seen.pixelColor(pixel_of(plot, 2500, 1.5)), QColor(255, 255, 0));
    QCOMPARE(picture.size(), QSize(600, 400));
  }

  void a_picture_that_moves_looks_as_if_it_was_drawn_anew() {
    picture::Figure figure = four_cells();
    gui::FigurePlot moved;
    moved.resize(600, 400);
    moved.set_figure(figure);
    moved.grab();
    QCPAxisRect* const frame = moved.panel(0);
    std::ranges::reverse(figure.panels[0].image->cells);
    moved.set_figure(figure);
    QCOMPARE(moved.panel(0), frame);
    moved.grab();
    gui::FigurePlot anew;
    anew.resize(600, 400);
    anew.set_figure(figure);
    anew.grab();
    QCOMPARE(moved.grab().toImage(), anew.grab().toImage());
    QVERIFY(moved.figure() == figure);
  }

  void an_axis_turned_round_turns_the_picture() {
    picture::Figure figure = four_cells();
    std::swap(figure.panels[0].y.first, figure.panels[0].y.last);
    gui::FigurePlot plot;
    plot.resize(600, 400);
    plot.set_figure(figure);
    plot.grab();
    const QImage seen = plot.grab().toImage();
    QVERIFY(pixel_of(plot, 1500, 0.5).y() < pixel_of(plot, 1500, 1.5).y());
    QCOMPARE(seen.pixelColor(pixel_of(plot, 1500, 0.5)), QColor(255, 0, 0));
    QCOMPARE(seen.pixelColor(pixel_of(plot, 1500, 1.5)), QColor(0, 0, 255));
  }

  void axes_name_their_units_with_a_prefix_that_suits() {
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    const QCPAxisRect* rect = plot.panel(0);
    QCOMPARE(rect->axis(QCPAxis::atBottom)->label(), QString("Slant range (km)"));
    QCOMPARE(rect->axis(QCPAxis::atTop)->label(), QString("Delay (µs)"));
    QCOMPARE(rect->axis(QCPAxis::atLeft)->label(), QString("Time (s)"));
  }

  void a_legend_has_the_curves_of_its_panel_alone() {
    picture::Figure figure = four_cells();
    figure.panels[0].curves.push_back({"I", picture::Role::curve, false, {1000, 3000}, {0, 2}});
    figure.panels.push_back(figure.panels[0]);
    figure.panels[1].curves.push_back({"", picture::Role::curve_2, false, {1000, 3000}, {2, 0}});
    gui::FigurePlot plot;
    plot.set_figure(figure);
    for (std::size_t panel = 0; panel < 2; ++panel) {
      const auto* names = qobject_cast<QCPLegend*>(plot.panel(panel)->insetLayout()->elementAt(0));
      QVERIFY(names != nullptr);
      QCOMPARE(names->itemCount(), 1);
    }
  }

  void curves_with_names_are_in_the_legend_and_others_are_not() {
    picture::Figure figure = four_cells();
    figure.panels[0].curves.push_back({"In phase", picture::Role::curve, false, {1000, 3000}, {0, 2}});
    figure.panels[0].curves.push_back({"", picture::Role::curve_2, false, {1000, 3000}, {2, 0}});
    gui::FigurePlot plot;
    plot.set_figure(figure);
    QCOMPARE(plot.plottableCount(), 2);
    const auto* legend = qobject_cast<QCPLegend*>(plot.panel(0)->insetLayout()->elementAt(0));
    QVERIFY(legend != nullptr);
    QCOMPARE(legend->itemCount(), 1);
  }

  void words_of_marks_stay_within_the_panel() {
    picture::Figure figure = four_cells();
    for (const double x : {1000.0, 2900.0}) figure.panels[0].marks.push_back({x, 1.0, "-53.98 dB"});
    gui::FigurePlot plot;
    plot.resize(500, 300);
    plot.set_figure(figure);
    plot.replot();
    int found = 0;
    for (int i = 0; i < plot.itemCount(); ++i) {
      const auto* const words = qobject_cast<QCPItemText*>(plot.item(i));
      if (words == nullptr) continue;
      ++found;
      const QRect area = plot.panel(0)->rect();
      QVERIFY(words->left->pixelPosition().x() >= area.left() - 1 &&
              words->right->pixelPosition().x() <= area.right() + 1);
    }
    QCOMPARE(found, 2);
  }

  void pictures_have_the_asked_size_times_the_scale() {
    const QTemporaryDir folder;
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    QString failure;
    QVERIFY2(plot.save(folder.filePath("a.png"), {500, 300}, 2.0, failure), qPrintable(failure));
    QCOMPARE(QImage(folder.filePath("a.png")).size(), QSize(1000, 600));
    QVERIFY(plot.save(folder.filePath("a.svg"), {500, 300}, 1.0, failure));
    QVERIFY(plot.save(folder.filePath("a.pdf"), {500, 300}, 1.0, failure));
    QFile svg(folder.filePath("a.svg"));
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QVERIFY(svg.readAll().contains("<svg"));
    QFile pdf(folder.filePath("a.pdf"));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    QVERIFY(pdf.readAll().startsWith("%PDF"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 3);
  }

  void a_file_that_cannot_be_written_is_told_and_nothing_is_left() {
    const QTemporaryDir folder;
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    QString failure;
    QVERIFY(!plot.save(folder.filePath("none/a.png"), {500, 300}, 1.0, failure));
    QVERIFY(failure.contains("could not be written"));
    QVERIFY(!plot.save(folder.filePath("a.gif"), {500, 300}, 1.0, failure));
    QVERIFY(failure.contains(".png, .svg or .pdf"));
    QVERIFY(QDir().mkdir(folder.filePath("taken.png")));
    QVERIFY(!plot.save(folder.filePath("taken.png"), {500, 300}, 1.0, failure));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 0);
  }

  // The libraries that draw say nothing of a full disk.
  void a_full_disk_is_told_for_every_kind_of_picture() {
    if (!QFile::exists("/dev/full")) QSKIP("there is no /dev/full");
    const QTemporaryDir folder;
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
      QVERIFY(QFile::link("/dev/full", folder.filePath(name)));
      QString failure;
      QVERIFY2(!plot.save(folder.filePath(name), {500, 300}, 1.0, failure), name);
      QVERIFY2(failure.contains("No space left"), qPrintable(failure));
    }
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::System | QDir::Hidden).size(), 3);
  }

  void pictures_that_are_saved_again_replace_the_ones_before() {
    const QTemporaryDir folder;
    gui::FigurePlot plot;
    plot.set_figure(four_cells());
    QString failure;
    for (const int width : {500, 600}) {
      QVERIFY2(plot.save(folder.filePath("a.png"), {width, 300}, 1.0, failure), qPrintable(failure));
      QCOMPARE(QImage(folder.filePath("a.png")).width(), width);
    }
    QFile::remove(folder.filePath("a.png"));
    QVERIFY2(plot.save(folder.filePath("a.pdf"), {500, 300}, 1.0, failure), qPrintable(failure));
    QFile pdf(folder.filePath("a.pdf"));
    QVERIFY(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    QVERIFY(bytes.trimmed().endsWith("%%EOF"));
    // A page of as many points as the window has pixels.
    QVERIFY2(bytes.contains("/MediaBox [ 0 0 500 300 ]"), bytes.mid(bytes.indexOf("/MediaBox"), 60).constData());
  }

  // The lowest row of letters is followed by rows of the ground alone, at every scale.
  void words_below_are_shown_to_their_lowest_letter() {
    const QTemporaryDir folder;
    picture::Figure figure = four_cells();
    figure.note = "gjpqy Range gjpqy";
    for (const double scale : {1.0, 2.0, 4.0}) {
      gui::FigurePlot plot;
      plot.set_figure(figure);
      QString failure;
      QVERIFY2(plot.save(folder.filePath("a.png"), {700, 500}, scale, failure), qPrintable(failure));
      const QImage picture(folder.filePath("a.png"));
      const QRgb ground = picture.pixel(0, 0);
      int clear = 0;
      for (int y = picture.height() - 1; y > 0; --y, ++clear) {
        bool empty = true;
        for (int x = 0; x < picture.width(); ++x) empty = empty && picture.pixel(x, y) == ground;
        if (!empty) break;
      }
      QVERIFY2(clear >= scale, qPrintable(QString("%1 rows at %2").arg(clear).arg(scale)));
    }
  }

  void long_titles_leave_the_picture_its_room() {
    picture::Figure figure = four_cells();
    const auto size_with = [&](int words) {
      figure.title.clear();
      for (int i = 0; i < words; ++i) figure.title += "word" + std::to_string(i) + " ";
      figure.note = figure.panels[0].title = figure.title;
      gui::FigurePlot plot;
      plot.resize(700, 500);
      plot.set_figure(figure);
      plot.grab();
      return plot.panel(0)->size();
    };
    const QSize usual = size_with(2);
    const QSize narrow = size_with(60);
    QCOMPARE(narrow.width(), usual.width());
    QVERIFY2(narrow.height() > usual.height() / 2, qPrintable(QString::number(narrow.height())));
    // Three lines and no more.
    QCOMPARE(size_with(600).height(), size_with(300).height());
  }

  // A circle on the ground is a circle in the picture.
  void metres_are_as_long_across_as_upwards() {
    picture::Figure figure = map_of_four_cells();
    gui::FigurePlot plot;
    plot.resize(1000, 500);
    plot.set_figure(figure);
    plot.grab();
    const QPoint corner = pixel_of(plot, 500.0, 500.0);
    const QPoint middle = pixel_of(plot, 0.0, 0.0);
    QVERIFY(std::abs((corner.x() - middle.x()) - (middle.y() - corner.y())) <= 2);
    const QCPAxisRect* rect = plot.panel(0);
    QVERIFY(rect->axis(QCPAxis::atBottom)->range().contains(-900.0));
    QVERIFY(rect->axis(QCPAxis::atLeft)->range().contains(700.0));
    // As is named what is seen: beyond a kilometre now.
    QCOMPARE(rect->axis(QCPAxis::atBottom)->label(), QString("East (km)"));
  }

  // Axes whose span passes a kilometre as the window grows: marks in metres under a title in kilometres mislead by
  // 1000.
  void titles_and_marks_of_axes_have_one_unit_at_every_size() {
    picture::Figure figure = map_of_four_cells();
    picture::FigurePanel& panel = figure.panels[0];
    panel.image = picture::FigureImage{2, 2, -950.0, 950.0, -950.0, 950.0, panel.image->cells};
    for (picture::FigureAxis* axis : {&panel.x, &panel.y}) {
      axis->first = -950.0;
      axis->last = 950.0;
    }
    gui::FigurePlot plot;
    plot.set_figure(figure);
    plot.show();
    std::set<QString> units;
    for (int step = 0; step < 240; ++step) {
      plot.resize(500 + step % 7, 380 + step);
      plot.grab();
      for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
        const QCPAxis* axis = plot.panel(0)->axis(side);
        const double scale = axis->label().endsWith("(km)") ? 1000.0 : 1.0;
        units.insert(axis->label());
        const QVector<double> marks = axis->tickVector();
        const QVector<QString> labels = axis->tickVectorLabels();
        QCOMPARE(marks.size(), labels.size());
        QVERIFY(!marks.isEmpty());
        for (int i = 0; i < marks.size(); ++i) {
          QVERIFY(axis->range().contains(marks[i]));
          const double read = QString(labels[i]).replace(QChar(0x2212), '-').toDouble() * scale;
          QVERIFY2(std::abs(read - marks[i]) < 1e-6, qPrintable(axis->label() + ' ' + labels[i]));
        }
      }
    }
    QVERIFY(units.size() >= 3);  // Metres and kilometres of at least one axis were met.
  }

  void metres_stay_as_long_when_the_plot_gets_another_size_or_palette() {
    picture::Figure figure = map_of_four_cells();
    gui::FigurePlot plot;
    plot.resize(1000, 500);
    plot.set_figure(figure);
    plot.show();
    for (const QSize size : {QSize(300, 700), QSize(800, 400)}) {
      plot.resize(size);
      QPalette other = plot.palette();
      other.setColor(QPalette::Window, size.width() == 300 ? Qt::black : Qt::white);
      plot.setPalette(other);
      std::ranges::reverse(figure.panels[0].image->cells);
      plot.set_figure(figure);
      QTRY_VERIFY(plot.panel(0)->width() > 50);  // drawn once more
      plot.grab();
      const QPoint corner = pixel_of(plot, 500.0, 500.0);
      const QPoint middle = pixel_of(plot, 0.0, 0.0);
      QVERIFY(std::abs((corner.x() - middle.x()) - (middle.y() - corner.y())) <= 2);
    }
  }

  // Whatever the size of the plot, and however it came to it.
  void no_point_of_one_cell_is_lost_where_there_are_more_cells_than_pixels() {
    constexpr std::size_t side = 1200;
    constexpr std::size_t points = 12;
    picture::Figure figure = map_of_four_cells();
    picture::FigurePanel& panel = figure.panels[0];
    panel.image = picture::FigureImage{side, side, -900.0, 900.0, -700.0, 700.0, {}};
    panel.colour_bar = picture::FigureColourBar{"Magnitude", "V", 0.0, 1e-9, {{0, 0, 255}, {255, 0, 0}}};
    gui::FigurePlot plot;
    plot.show();
    for (int step = 0; step < 25; ++step) {
      panel.image->cells.assign(side * side, {0, 0, 255});
      for (std::size_t k = 0; k < points; ++k)
        panel.image->cells[(100 * k + 3 * static_cast<std::size_t>(step)) * side + 50 * k + 7] = {255, 0, 0};
      plot.set_figure(figure);
      plot.resize(420 + 13 * step, 380 + 7 * step);
      const QImage drawn = plot.grab().toImage();
      std::size_t seen = 0;
      bool above = false;
      for (int y = 0; y < drawn.height(); ++y) {
        bool here = false;
        for (int x = 0; x < drawn.width() * 3 / 4; ++x) here = here || drawn.pixelColor(x, y) == QColor(255, 0, 0);
        if (here && !above) ++seen;
        above = here;
      }
      QCOMPARE(seen, points);
    }
  }

  // Marks go to the ends of an axis that has become longer than what it shows.
  void marks_are_those_of_the_axis_as_it_is_drawn() {
    gui::FigurePlot plot;
    plot.resize(900, 400);
    plot.set_figure(map_of_four_cells());
    plot.show();
    QTest::qWait(50);
    for (const QSize size : {QSize(300, 800), QSize(900, 400), QSize(320, 700)}) {
      plot.resize(size);
      QTest::qWait(50);
      // Another figure has its own at once.
      for (const picture::Figure& figure : {four_cells(), map_of_four_cells()}) plot.set_figure(figure);
      for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
        const QCPAxis* const axis = plot.panel(0)->axis(side);
        const QList<double> marks = axis->tickVector();
        QVERIFY(marks.size() > 1);
        const double step = marks[1] - marks[0];
        QVERIFY2(marks.first() - axis->range().lower < 2.0 * step && axis->range().upper - marks.last() < 2.0 * step,
                 qPrintable(QString("%1 to %2 on %3 to %4")
                                .arg(marks.first())
                                .arg(marks.last())
                                .arg(axis->range().lower)
                                .arg(axis->range().upper)));
      }
    }
  }

  void long_strips_fill_the_picture_all_the_same() {
    picture::Figure figure = four_cells();
    picture::FigurePanel& panel = figure.panels[0];
    panel.x = {"Slant range", "m", 0.0, 100.0, {}};
    panel.y = {"Azimuth", "m", 0.0, 1000.0, {}};
    panel.image = picture::FigureImage{2, 2, 0.0, 100.0, 0.0, 1000.0, panel.image->cells};
    gui::FigurePlot plot;
    plot.resize(600, 400);
    plot.set_figure(figure);
    plot.grab();
    QCOMPARE(plot.panel(0)->axis(QCPAxis::atBottom)->range().upper, 100.0);
    QCOMPARE(plot.panel(0)->axis(QCPAxis::atLeft)->range().upper, 1000.0);
  }

  void the_title_of_a_narrow_axis_is_whole() {
    QImage image(300, 120, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setPen(Qt::black);
    const QRect plot(130, 10, 40, 40);
    gui::draw_axis_across(painter, plot, {"Slant range (km)", {}}, 0.0, false);
    const int words = painter.fontMetrics().horizontalAdvance("Slant range (km)");
    painter.end();
    int first = image.width();
    int last = 0;
    for (int y = plot.bottom() + 1; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y).lightness() < 128) first = std::min(first, x), last = std::max(last, x);
    QVERIFY2(last - first > words - 8, qPrintable(QString("%1 of %2").arg(last - first).arg(words)));
  }

  void dark_figures_have_dark_grounds() {
    gui::FigurePlot plot;
    plot.resize(300, 200);
    plot.set_figure(four_cells());
    gui::set_appearance(*qApp, gui::Appearance::dark);
    QCoreApplication::processEvents();
    QVERIFY(plot.grab().toImage().pixelColor(2, 2).lightness() < 80);
    gui::set_appearance(*qApp, gui::Appearance::light);
    QCoreApplication::processEvents();
    QVERIFY(plot.grab().toImage().pixelColor(2, 2).lightness() > 180);
  }
};

const test::AddTest added("figure_plot_test", test::run_test<FigurePlotTest>);

}  // namespace sarsim::figure_plot_test

#include "figure_plot_test.moc"
