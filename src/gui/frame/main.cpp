// sarsim-gui: the workbench.

#include <QApplication>
#include <QFileInfo>
#include <QSettings>

#include <qcustomplot.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "core/build/build.hpp"
#include "core/os/standard_streams.hpp"
#include "gui/common/icons.hpp"
#include "gui/frame/document_keeper.hpp"
#include "gui/frame/main_window.hpp"
#include "gui/frame/pictures.hpp"
#include "picture/facts/version_text.hpp"

namespace {

struct Options {
  std::vector<std::string> files;
  std::string screenshot;
  std::string window;
  std::string layout;
  std::vector<std::string> selected;
  std::vector<std::string> commands;
  std::vector<std::string> typed;
  std::vector<int> size;
  bool few_colours = false;
  bool dark = false;
  bool light = false;
  double scale = 1.0;
  double time_s = 0.0;
};

std::string about() {
  return sarsim::picture::version_text(
      "sarsim-gui", sarsim::core::this_build(),
      {{"CLI11", CLI11_VERSION}, {"Qt", qVersion()}, {"QCustomPlot", QCUSTOMPLOT_VERSION_STR}});
}

// Options are read before Qt starts: the scale of a picture has to be known by then.
void read_options(CLI::App& app, Options& options) {
  app.description("Workbench of sarsim: builds a scene on screen. The same scripts as the command sarsim.");
  app.set_version_flag("--version", about);
  app.add_option("file,--script", options.files, "scripts to open, or files of samples to look at");
  app.add_flag("--dark", options.dark, "dark colours");
  app.add_flag("--light", options.light, "light colours");
  app.add_option("--layout", options.layout,
                 "panels beside the scene: scene, echoes, views (echoes and image), script, or one that was saved");
  app.add_option("--time", options.time_s, "time of the scene, s");
  CLI::Option* picture =
      app.add_option("--screenshot", options.screenshot, "write a picture of a window to this PNG file and end")
          ->group("Pictures");
  std::string names;
  for (const QString& name : sarsim::gui::picture_names()) names += " " + name.toStdString();
  const auto add = [&](const char* flag, auto& value, const std::string& help) {
    return app.add_option(flag, value, help)->needs(picture)->group("Pictures");
  };
  add("--window", options.window, "which window is shown; without it main, or viewer of a file of samples:" + names);
  add("--scale", options.scale, "device pixels per pixel, 1 or 2 for instance")->check(CLI::Range(1.0, 8.0));
  add("--size", options.size, "width and height of the window, pixels")->expected(2)->check(CLI::Range(100, 10000));
  add("--select", options.selected, "select an object: kind and number, such as radar:1")->allow_extra_args(false);
  add("--do", options.commands, "trigger a command first, such as view_filled")->allow_extra_args(false);
  add("--type", options.typed, "type into a field of the properties, such as width=3us")->allow_extra_args(false);
  app.add_flag("--few-colours", options.few_colours, "at most 256 colours, for a small file")
      ->needs(picture)
      ->group("Pictures");
}

QStringList strings(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) list += QString::fromStdString(text);
  return list;
}

int take_screenshot(sarsim::gui::MainWindow& main, const Options& options) {
  sarsim::gui::PictureRequest wish;
  wish.window = QString::fromStdString(options.window);
  wish.file = QString::fromStdString(options.screenshot);
  wish.selected = strings(options.selected);
  wish.commands = strings(options.commands);
  wish.typed = strings(options.typed);
  if (options.size.size() == 2) wish.size = QSize(options.size[0], options.size[1]);
  wish.few_colours = options.few_colours;
  return sarsim::gui::make_picture(main, wish) ? EXIT_SUCCESS : EXIT_FAILURE;
}

// A mistake in the arguments, as for sarsim.
constexpr int exit_bad_input = 2;

void complain(const QString& text) { std::fprintf(stderr, "sarsim-gui: %s\n", qPrintable(text)); }

QString why_no_window() {
  const QString platform = qEnvironmentVariable("QT_QPA_PLATFORM");
  const QString display = qEnvironmentVariable("DISPLAY");
  if (!platform.isEmpty()) return QStringLiteral("Qt cannot use the platform '%1' of QT_QPA_PLATFORM").arg(platform);
  return display.isEmpty() ? QStringLiteral("there is no display")
                           : QStringLiteral("the display '%1' cannot be reached").arg(display);
}

// Without a display Qt would abort, with words about its plugins.
void end_without_display(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (type == QtFatalMsg) {
    complain(QStringLiteral("no window can be shown: %1. Start it from a desktop, or through 'ssh -X'; --screenshot "
                            "FILE.png needs no display")
                 .arg(why_no_window()));
    std::_Exit(EXIT_FAILURE);
  }
  if (!QByteArray(context.category).startsWith("qt.qpa")) std::fprintf(stderr, "%s\n", qPrintable(text));
}

// What is wrong with the name of the picture; nothing where none is wanted.
QString wrong_with_screenshot(const Options& options) {
  if (options.screenshot.empty()) return {};
  return sarsim::gui::wrong_with_picture_name(QString::fromStdString(options.screenshot), strings(options.files));
}

// Opens them in a row and turns to the first scene; false where one of them failed.
bool open_files(sarsim::gui::MainWindow& window, const std::vector<std::string>& files) {
  bool good = true;
  for (const std::string& file : files) good = window.open_any(QString::fromStdString(file)) && good;
  window.session().turn_to(0);
  return good;
}

// Shows the workbench, or makes the picture.
int run(QApplication& application, const Options& options) {
  using sarsim::gui::Appearance;
  const bool picture = !options.screenshot.empty();
  Appearance appearance = static_cast<Appearance>(QSettings().value("appearance").toInt());
  if (options.light || (picture && !options.dark)) appearance = Appearance::light;
  if (options.dark) appearance = Appearance::dark;
  sarsim::gui::set_appearance(application, appearance);
  for (const QString& file : strings(options.files))
    if (picture && !QFileInfo::exists(file)) {
      complain(QStringLiteral("'%1' could not be opened: there is no such file").arg(file));
      return EXIT_FAILURE;
    }
  sarsim::gui::MainWindow window;
  // Nobody would close a dialog.
  if (picture)
    window.documents().show_failure = [](const QString& what, const QString& why) { complain(what + " " + why); };
  if (!picture) window.set_first_layout("views");
  if (!options.layout.empty() && !window.layout_names().contains(QString::fromStdString(options.layout))) {
    complain(QStringLiteral("there is no layout '%1'; there are %2")
                 .arg(QString::fromStdString(options.layout), window.layout_names().join(", ")));
    return exit_bad_input;
  }
  if (!options.layout.empty()) window.use_layout(QString::fromStdString(options.layout));
  if (!picture) window.show();  // before a viewer of samples, which belongs in front
  if (!open_files(window, options.files) && picture) return EXIT_FAILURE;
  window.session().set_time(options.time_s);
  if (picture) return take_screenshot(window, options);
  window.documents().offer_recovery();
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  sarsim::core::reserve_standard_streams();
  Options options;
  CLI::App command;
  read_options(command, options);
  try {
    command.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return command.exit(error) == 0 ? EXIT_SUCCESS : exit_bad_input;
  }
  if (const QString wrong = wrong_with_screenshot(options); !wrong.isEmpty()) {
    complain(wrong);
    return exit_bad_input;
  }
  if (options.scale != 1.0) qputenv("QT_SCALE_FACTOR", QByteArray::number(options.scale));
  if (!options.screenshot.empty() && qEnvironmentVariableIsEmpty("DISPLAY") &&
      qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(end_without_display);
  QApplication application(argc, argv);
  qInstallMessageHandler(nullptr);
  QApplication::setStyle(sarsim::gui::make_style());
  QCoreApplication::setOrganizationName("Sarsim");
  QCoreApplication::setApplicationName("sarsim-gui");
  QApplication::setWindowIcon(sarsim::gui::program_icon());
  QApplication::setDesktopFileName("sarsim-gui");
  return run(application, options);
}
