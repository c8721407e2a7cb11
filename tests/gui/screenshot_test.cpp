#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <csignal>
#include <functional>

#include <sys/resource.h>

#include "gui/gui_test.hpp"
#include "gui/small_scene.hpp"

// The workbench called for a picture, as scripts and tools call it: nobody is there to close a dialog.

namespace sarsim::screenshot_test {

namespace {

constexpr int patience_ms = 60'000;

struct Ended {
  int status = -1;  ///< -1: killed, because it did not end, or crashed.
  QString told;     ///< Standard error.
};

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

// How many pixels two pictures have in common.
int alike(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y)
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) count += a.pixel(x, y) == b.pixel(x, y) ? 1 : 0;
  return count;
}

}  // namespace

class ScreenshotTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString script_;

  using Preparing = std::function<void(QProcess& process, QProcessEnvironment& environment)>;

  [[nodiscard]] Ended run(const QStringList& arguments, const Preparing& prepare = {}) const {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) environment.insert(place, folder_.path());
    if (prepare) prepare(process, environment);
    process.setProcessEnvironment(environment);
    process.start(SARSIM_GUI_PROGRAM, arguments);
    if (!process.waitForFinished(patience_ms)) {
      process.kill();
      process.waitForFinished();
      return {};
    }
    const bool crashed = process.exitStatus() == QProcess::CrashExit;
    return {crashed ? -1 : process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
  }

 private slots:
  void init() {
    script_ = folder_.filePath("scene.scr");
    write(script_, QByteArray::fromStdString(scene::write_script(test::small_scene())));
  }

  void a_picture_is_a_png_file() {
    const QString picture = folder_.filePath("scene.png");
    const Ended ended = run({script_, "--screenshot", picture, "--size", "1400", "800"});
    QVERIFY2(ended.status == 0, qPrintable(ended.told));
    QCOMPARE(QImage(picture, "PNG").size(), QSize(1400, 800));
  }

  // A file of samples is shown as opening it in the menu or dropping it does.
  void a_picture_of_a_file_of_samples_is_that_of_its_viewer() {
    const QString image = folder_.filePath("stripes.img");
    write(image, QByteArray("\x00\x00\x80\x3f", 4).repeated(32).append(QByteArray("\x00\x00\x10\x41", 4).repeated(32)));
    write(folder_.filePath("stripes.hdr"),
          "ENVI\nsamples = 64\nlines = 1\nbands = 1\nheader offset = 0\ndata type = 4\ninterleave = bsq\nbyte order = "
          "0\n");
    const QString by_itself = folder_.filePath("by_itself.png");
    const QString viewer = folder_.filePath("viewer.png");
    const QString workbench = folder_.filePath("main.png");
    const auto take = [&](const QString& picture, const QStringList& more) {
      const Ended ended = run(QStringList{image, "--screenshot", picture, "--size", "1000", "700"} + more);
      QVERIFY2(ended.status == 0, qPrintable(ended.told));
    };
    take(by_itself, {});
    take(viewer, {"--window", "viewer"});
    take(workbench, {"--window", "main"});
    // A busy machine may not have painted all of the samples in one of them.
    QVERIFY(alike(QImage(by_itself), QImage(viewer)) > alike(QImage(by_itself), QImage(workbench)));
  }

  void the_script_that_is_shown_is_never_replaced() {
    const QByteArray before = bytes_of(script_);
    const QString other_name = folder_.filePath("link.png");
    QVERIFY(QFile::link(script_, other_name));
    for (const QString& name : {script_, other_name}) {
      const Ended ended = run({script_, "--screenshot", name});
      QCOMPARE(ended.status, 2);
      QVERIFY2(ended.told.contains("is the file that is shown"), qPrintable(ended.told));
      QCOMPARE(bytes_of(script_), before);
    }
  }

  void no_file_of_another_kind_is_replaced_by_a_picture() {
    for (const char* name : {"picture.jpg", "notes.txt", "other.scr", "png"}) {
      const QString path = folder_.filePath(name);
      write(path, "precious");
      const Ended ended = run({script_, "--screenshot", path});
      QCOMPARE(ended.status, 2);
      QVERIFY2(ended.told.contains("pictures of windows are written as .png"), qPrintable(ended.told));
      QCOMPARE(bytes_of(path), QByteArray("precious"));
    }
  }

  void what_cannot_be_opened_is_told_and_nothing_waits() {
    const QString no_script = folder_.filePath("no_script.scr");
    write(no_script, QByteArray("\x89HDF\r\n\x1a\n\0\0\0\0", 12));
    for (const QString& name : {folder_.filePath("none.scr"), folder_.filePath("none.h5"), folder_.path(), no_script}) {
      const Ended ended = run({name, "--screenshot", folder_.filePath("p.png")});
      QVERIFY2(ended.status == 1, qPrintable(name));
      QVERIFY2(ended.told.contains("could not be opened"), qPrintable(ended.told));
      QVERIFY(!QFile::exists(folder_.filePath("p.png")));
    }
  }

  void a_picture_that_finds_no_room_leaves_nothing_and_no_half_file() {
    const QString picture = folder_.filePath("room.png");
    const auto with_little_room = [](QProcess& process, QProcessEnvironment&) {
      process.setChildProcessModifier([] {
        const rlimit little{4096, 4096};
        setrlimit(RLIMIT_FSIZE, &little);
        std::signal(SIGXFSZ, SIG_IGN);
      });
    };
    for (const bool replaces : {false, true}) {
      if (replaces) write(picture, "as it was");
      const Ended ended = run({script_, "--screenshot", picture, "--size", "1400", "800"}, with_little_room);
      QCOMPARE(ended.status, 1);
      QVERIFY2(ended.told.contains("room.png' could not be written: "), qPrintable(ended.told));
      QCOMPARE(bytes_of(picture), QByteArray(replaces ? "as it was" : ""));
      QCOMPARE(QDir(folder_.path()).entryList({"room*"}).size(), replaces ? 1 : 0);
    }
  }

  void without_a_display_it_says_so_and_ends() {
    const auto without_display = [](QProcess&, QProcessEnvironment& environment) {
      for (const char* name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"}) environment.remove(name);
      environment.insert("DISPLAY", ":987");
    };
    const Ended ended = run({script_}, without_display);
    QCOMPARE(ended.status, 1);
    QVERIFY2(ended.told.startsWith("sarsim-gui: no window can be shown: the display ':987' cannot"),
             qPrintable(ended.told));
    QCOMPARE(ended.told.count('\n'), 1);
  }

  void mistakes_in_the_arguments_end_as_those_of_sarsim() {
    QCOMPARE(run({"--no-such-option"}).status, 2);
    QCOMPARE(run({script_, "--screenshot", folder_.filePath("p.png"), "--scale", "0"}).status, 2);
    QCOMPARE(run({"--dark", "--window", "main"}).status, 2);
    QCOMPARE(run({"--help"}).status, 0);
  }
};

const test::AddTest added("screenshot_test", test::run_test<ScreenshotTest>);

}  // namespace sarsim::screenshot_test

#include "screenshot_test.moc"
