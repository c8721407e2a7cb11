// sarsim-gui: the workbench.

#include <QApplication>
#include <QPixmap>
#include <QSettings>
#include <QTimer>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/version.hpp"
#include "gui/document_keeper.hpp"
#include "gui/draw_figure.hpp"
#include "gui/main_window.hpp"
#include "gui/scene_panel.hpp"
#include "gui/scene_widget.hpp"

namespace {

struct Options {
  std::string script;
  std::string screenshot;
  std::string window = "main";
  bool dark = false;
  bool light = false;
  double scale = 1.0;
  double time_s = 0.0;
};

// Options are read before Qt starts: the scale of a picture has to be known by then.
void read_options(CLI::App& app, Options& options) {
  app.description("Workbench of sarsim: builds a scene on screen. The same scripts as the command sarsim.");
  app.set_version_flag("--version", std::string("sarsim-gui ") + sarsim::program_version);
  app.add_option("script,--script", options.script, "script to open");
  app.add_option("--screenshot", options.screenshot, "write a picture of a window to this PNG file and end");
  std::string names;
  for (const QString& name : sarsim::MainWindow::window_names()) names += " " + name.toStdString();
  app.add_option("--window", options.window, "which window --screenshot shows:" + names);
  app.add_flag("--dark", options.dark, "dark colours");
  app.add_flag("--light", options.light, "light colours");
  app.add_option("--scale", options.scale, "device pixels per pixel, 1 or 2 for instance")->check(CLI::Range(0.5, 8.0));
  app.add_option("--time", options.time_s, "time of the scene, s");
}

int take_screenshot(sarsim::MainWindow& main, const Options& options) {
  main.show();
  QWidget* window = main.window_named(QString::fromStdString(options.window));
  if (window == nullptr) {
    std::fprintf(stderr, "sarsim-gui: no window '%s' for this script\n", options.window.c_str());
    return EXIT_FAILURE;
  }
  window->show();
  main.scene().scene().fit();
  // Work in the background, and layouts, have a moment to end.
  QTimer::singleShot(700, &main, [&] {
    const bool good = window->grab().save(QString::fromStdString(options.screenshot));
    if (!good) std::fprintf(stderr, "sarsim-gui: '%s' could not be written\n", options.screenshot.c_str());
    QCoreApplication::exit(good ? EXIT_SUCCESS : EXIT_FAILURE);
  });
  return QCoreApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--draw-figure") return sarsim::draw_figure(argc, argv);
  Options options;
  CLI::App command;
  read_options(command, options);
  CLI11_PARSE(command, argc, argv);
  if (options.scale != 1.0) qputenv("QT_SCALE_FACTOR", QByteArray::number(options.scale));
  if (!options.screenshot.empty() && qEnvironmentVariableIsEmpty("DISPLAY") &&
      qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  QCoreApplication::setOrganizationName("Sarsim");
  QCoreApplication::setApplicationName("sarsim-gui");
  using sarsim::Appearance;
  Appearance appearance = static_cast<Appearance>(QSettings().value("appearance").toInt());
  if (options.light || (!options.screenshot.empty() && !options.dark)) appearance = Appearance::light;
  if (options.dark) appearance = Appearance::dark;
  sarsim::set_appearance(application, appearance);
  sarsim::MainWindow window;
  if (!options.script.empty() && !window.documents().open_file(QString::fromStdString(options.script)) &&
      !options.screenshot.empty())
    return EXIT_FAILURE;
  window.session().set_time(options.time_s);
  if (!options.screenshot.empty()) return take_screenshot(window, options);
  window.show();
  window.documents().offer_recovery();
  return QApplication::exec();
}
