#include "gui/frame/draw_figure.hpp"

#include <QApplication>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "gui/common/appearance.hpp"
#include "gui/common/figure_plot.hpp"
#include "picture/figure/figure.hpp"

namespace sarsim::gui {

namespace {

struct Options {
  std::string figure;
  std::string out;
  int width = 1000;
  int height = 600;
  double scale = 1.0;
  bool dark = false;
};

void read_options(CLI::App& app, Options& options) {
  constexpr int most_pixels = 20'000;
  app.add_option("--draw-figure", options.figure, "figure to draw")->required();
  app.add_option("--out", options.out, "picture: .png, .svg or .pdf")->required();
  app.add_option("--width", options.width)->check(CLI::Range(64, most_pixels));
  app.add_option("--height", options.height)->check(CLI::Range(64, most_pixels));
  app.add_option("--scale", options.scale)->check(CLI::Range(0.25, 16.0));
  app.add_flag("--dark", options.dark);
}

picture::Figure read_figure(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("'" + path + "' could not be read");
  return picture::figure_from(bytes);
}

}  // namespace

int draw_figure(int argc, char** argv) {
  Options options;
  CLI::App command;
  read_options(command, options);
  try {
    command.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    constexpr int exit_bad_input = 2;
    return command.exit(error) == 0 ? EXIT_SUCCESS : exit_bad_input;
  }
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setStyle("Fusion");
  set_appearance(application, options.dark ? Appearance::dark : Appearance::light);
  QString failure;
  try {
    FigurePlot plot;
    plot.set_figure(read_figure(options.figure));
    const QSize size(options.width, options.height);
    if (plot.save(QString::fromStdString(options.out), size, options.scale, failure)) return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    failure = error.what();
  }
  std::fprintf(stderr, "%s\n", qPrintable(failure));
  return EXIT_FAILURE;
}

}  // namespace sarsim::gui
