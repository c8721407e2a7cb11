#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <ostream>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output_names.hpp"
#include "cli/picture_program.hpp"
#include "cli/sample_input.hpp"
#include "cli/scene_input.hpp"
#include "data/image_source.hpp"
#include "data/output_file.hpp"
#include "view/echo_figure.hpp"
#include "view/image_figure.hpp"
#include "view/preview.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

enum class Kind { picture, pulse, cell };

struct PlotArguments {
  std::string input;
  std::string out;
  std::string csv;
  std::string title;
  std::string radar;
  std::optional<std::int64_t> simulation;
  std::optional<Kind> kind;
  std::optional<DisplayQuantity> quantity;
  std::optional<Processing> processing;
  std::optional<DrawAs> draw_as;
  std::optional<ColourMap> map;
  std::optional<double> span_db;
  std::optional<double> percentile;
  std::optional<double> at_m;
  std::optional<double> at_s;
  std::vector<double> range_m;
  std::vector<double> time_s;
  std::vector<double> limits;
  std::vector<std::int64_t> size{1000, 700};
  std::optional<double> scale;
  bool inverted = false;
  bool peak = false;
  bool screen = false;
  bool dark = false;
  bool force = false;
  SceneOverrides overrides;
  SampleArguments samples;
};

// What the axes, colour bar and titles leave of a picture of this size, about.
PlotSize plot_pixels(const PlotArguments& a) {
  const double scale = a.scale.value_or(1.0);
  const auto left = [scale](std::int64_t all, double taken) {
    return static_cast<std::size_t>(std::max(16.0, (static_cast<double>(all) - taken) * scale));
  };
  return {left(a.size[0], 170.0), left(a.size[1], 150.0)};
}

void take_look(const PlotArguments& a, DisplayQuantity usual, EchoWindow& window) {
  window.quantity = a.quantity.value_or(usual);
  const ColourMapKind kind = kind_for(window.quantity);
  window.map = a.map.value_or(kind == ColourMapKind::diverging ? ColourMap::balance
                              : kind == ColourMapKind::cyclic  ? ColourMap::cycle
                                                               : ColourMap::ocean);
  window.inverted = a.inverted;
  window.draw_as = a.draw_as.value_or(DrawAs::automatic);
  if (a.peak) window.pixel_rule = PixelRule::peak;
  if (a.span_db) window.decibels.range_db = *a.span_db;
  if (a.percentile) window.limits.percentile = *a.percentile;
  if (a.limits.size() == 2) window.limits = {LimitRule::Kind::manual, 100.0, a.limits[0], a.limits[1]};
}

Simulation chosen_simulation(const PlotArguments& a, const Scene& scene) {
  if (a.simulation) {
    const auto number = static_cast<std::size_t>(*a.simulation);
    if (number > scene.simulations.size())
      throw BadInput(fmt::format("the script has no simulation {}", number),
                     scene.simulations.empty()
                         ? "it has none: choose with --radar"
                         : fmt::format("simulations have the numbers 1 to {}", scene.simulations.size()));
    return scene.simulations[number - 1];
  }
  if (a.radar.empty() && !scene.simulations.empty()) return scene.simulations[0];
  if (scene.radars.empty()) throw BadInput(a.input + ": the script has no radar", "add a $RADAR");
  Simulation simulation;
  simulation.radar = scene.radars[a.radar.empty() ? 0 : radar_named(scene, a.radar)].name;
  return simulation;
}

EchoWindow chosen_window(const PlotArguments& a, const Scene& scene, bool& show_all) {
  const Simulation simulation = chosen_simulation(a, scene);
  EchoWindow window = window_of(simulation);
  const bool stored = simulation.sample_rate_hz > 0.0;
  show_all = !stored && a.range_m.empty();
  if (!stored) window = new_echo_window(simulation.radar, a.processing.value_or(Processing::raw));
  if (a.processing) window.recording.processing = *a.processing;
  if (a.screen) window.sampling.kind = Sampling::Kind::screen;
  EchoView view = view_of(window);
  if (!a.range_m.empty()) std::tie(view.range_start_m, view.range_end_m) = std::pair(a.range_m[0], a.range_m[1]);
  if (!a.time_s.empty()) std::tie(view.time_start_s, view.time_end_s) = std::pair(a.time_s[0], a.time_s[1]);
  set_view(window, mended(view));
  take_look(a, DisplayQuantity::real, window);
  return window;
}

// The echo matrix of a window, as a simulation window computes it.
std::shared_ptr<const EchoMatrix> computed(const PreviewRequest& request, const StopFlag* stop) {
  std::mutex lock;
  std::condition_variable changed;
  std::optional<PreviewEvent> end;
  Preview preview([&](const PreviewEvent& event) {
    if (event.kind != PreviewEvent::Kind::finished && event.kind != PreviewEvent::Kind::failed) return;
    const std::scoped_lock hold(lock);
    end = event;
    changed.notify_all();
  });
  preview.show(request);
  {
    std::unique_lock hold(lock);
    while (!end) {
      changed.wait_for(hold, std::chrono::milliseconds(50));
      if (stop != nullptr && stop->requested()) throw Interrupted();
    }
  }
  if (end->kind == PreviewEvent::Kind::failed) throw BadInput(std::move(end->problems));
  return end->matrix;
}

template <class Place>
std::size_t nearest(std::size_t count, double wanted, const Place& place) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i)
    if (std::abs(place(i) - wanted) < std::abs(place(best) - wanted)) best = i;
  return best;
}

struct Plotted {
  Figure figure;
  std::string table;
};

std::string range_table(const EchoMatrix& matrix, std::size_t column) {
  std::string text = "time [s],I [V],Q [V],magnitude [V]\n";
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    const std::complex<double> v = matrix.row(row)[column];
    text += fmt::format("{},{},{},{}\n", format_number(matrix.time_s(row)), format_number(v.real()),
                        format_number(v.imag()), format_number(std::abs(v)));
  }
  return text;
}

Plotted plot_scene(const PlotArguments& a, Streams& streams) {
  const SceneInput input = read_scene(a.input, a.overrides, Scrutiny::values);
  expect_usable(input);
  bool show_all = false;
  const EchoWindow window = chosen_window(a, input.scene, show_all);
  const auto matrix = computed(
      {std::make_shared<Scene>(input.scene), window, plot_pixels(a), Engine::automatic, show_all}, streams.stop);
  const double range = a.at_m.value_or(matrix->range_m(matrix->columns() / 2));
  const double time = a.at_s.value_or(matrix->time_s(matrix->rows() / 2));
  const std::size_t row = nearest(matrix->rows(), time, [&](std::size_t i) { return matrix->time_s(i); });
  const std::size_t column = nearest(matrix->columns(), range, [&](std::size_t k) { return matrix->range_m(k); });
  Plotted plotted;
  const Kind kind = a.kind.value_or(Kind::picture);
  if (kind == Kind::picture) {
    plotted.figure = echo_figure(*matrix, window);
    plotted.table = pulse_table(*matrix, row, ',');
    return plotted;
  }
  plotted.figure = cut_figure(*matrix, colours_for(*matrix, window), row, column);
  plotted.figure.panels.erase(plotted.figure.panels.begin() + (kind == Kind::pulse ? 1 : 0));
  plotted.figure.note = highest_magnitude_text(colours_for(*matrix, window).statistics);
  plotted.table = kind == Kind::pulse ? pulse_table(*matrix, row, ',') : range_table(*matrix, column);
  return plotted;
}

Plotted plot_file(const PlotArguments& a, Streams& streams) {
  if (a.kind.value_or(Kind::picture) != Kind::picture || !a.csv.empty())
    throw BadInput("cuts and tables are made from scripts", "of a file, sarsim convert gives the values");
  OpenedImage opened = ImageSource::open(a.input, {hints_for(a.input, a.samples), std::nullopt});
  if (!opened.source) throw BadInput(ranked(std::move(opened.problems)));
  print_problems(streams, ranked(std::move(opened.problems)));
  opened.source->wait_until_indexed(streams.stop);
  if (opened.source->rows() == 0 || opened.source->columns() == 0) throw BadInput(a.input + " holds no samples");
  EchoWindow look;
  take_look(a, DisplayQuantity::magnitude, look);
  ImageLook wanted;
  wanted.quantity = look.quantity;
  wanted.map = look.map;
  wanted.inverted = look.inverted;
  wanted.limits = look.limits;
  wanted.decibels = look.decibels;
  return {image_figure(*opened.source, wanted, plot_pixels(a), {0, streams.stop}), {}};
}

void write_table(const PlotArguments& a, const std::string& table) {
  if (a.csv.empty()) return;
  OutputFile file(a.csv, a.force);
  file.write(std::as_bytes(std::span(table)));
  file.commit();
}

void expect_names(const PlotArguments& a) {
  const std::string ending = fs::path(a.out).extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw BadInput("'" + a.out + "' does not say which kind of picture", "end it with .png, .svg or .pdf");
  Problems problems;
  for (const std::string& path : {a.out, a.csv})
    if (!path.empty()) std::ranges::move(problems_of_output(path, a.input, a.force), std::back_inserter(problems));
  if (!problems.empty()) throw BadInput(std::move(problems));
}

ExitStatus plot(const PlotArguments& a, Streams& streams) {
  expect_names(a);
  std::string ending = fs::path(a.input).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Plotted plotted = ending == ".scr" ? plot_scene(a, streams) : plot_file(a, streams);
  plotted.figure.title = a.title.empty() ? fs::path(a.input).filename().string() : a.title;
  draw_picture(plotted.figure, a.out,
               {static_cast<int>(a.size[0]), static_cast<int>(a.size[1]), a.scale.value_or(1.0), a.dark});
  write_table(a, plotted.table);
  return exit_done;
}

void add_look(CLI::App& app, PlotArguments& a) {
  add_choice<DisplayQuantity>(app, "--show", a.quantity,
                              {{"real", DisplayQuantity::real},
                               {"imaginary", DisplayQuantity::imaginary},
                               {"magnitude", DisplayQuantity::magnitude},
                               {"phase", DisplayQuantity::phase},
                               {"db", DisplayQuantity::decibels}},
                              "what of the samples (default: real of a script, magnitude of a file)");
  add_choice<DrawAs>(app, "--draw", a.draw_as,
                     {{"auto", DrawAs::automatic},
                      {"pixels", DrawAs::pixels},
                      {"pulses", DrawAs::curves_per_pulse},
                      {"ranges", DrawAs::curves_per_range}},
                     "colours, or a curve for each pulse or range (default: curves where pulses are far apart)");
  std::vector<std::pair<std::string, ColourMap>> maps;
  for (const ColourMapInfo& info : colour_maps()) maps.emplace_back(info.name, info.map);
  add_choice<ColourMap>(app, "--colours", a.map, maps, "map of colours (default: one that suits what is shown)");
  app.add_flag("--invert", a.inverted, "colours in the opposite order");
  app.add_flag("--peak", a.peak, "the largest sample of each pixel instead of one of them");
  add_real(app, "--span", a.span_db, "DB", "decibels from the strongest to the weakest colour (default: 60)");
  add_real(app, "--percentile", a.percentile, "P", "share of the samples within the colours, percent (default: 100)");
  app.add_option("--limits", a.limits, "values of the first and the last colour")->expected(2)->type_name("LOW HIGH");
  app.add_option("--size", a.size, "pixels (default: 1000 700)")
      ->expected(2)
      ->check(CLI::Range(64, 20000))
      ->type_name("WIDTH HEIGHT");
  add_real(app, "--scale", a.scale, "S", "dots for each pixel of a PNG, 0.25 to 16 (default: 1)")
      ->check(CLI::Range(0.25, 16.0));
  app.add_flag("--dark", a.dark, "light words on a dark ground");
  add_text(app, "--title", a.title, "TEXT", "above the picture (default: the name of the input)");
}

}  // namespace

Action add_plot(CLI::App& app) {
  auto a = std::make_shared<PlotArguments>();
  add_text(app, "input", a->input, "SCENE|FILE", "script (.scr) or file of samples")->required();
  add_text(app, "-o,--output", a->out, "PICTURE", "picture to write: .png, .svg or .pdf")->required();
  add_integer(app, "--simulation", a->simulation, 1, 1'000'000, "which simulation of the script (default: the first)");
  add_text(app, "--radar", a->radar, "NAME", "any window of this radar instead of a simulation");
  add_choice<Processing>(
      app, "--data", a->processing,
      {{"raw", Processing::raw}, {"compressed", Processing::matched_filter}, {"srp", Processing::srp}},
      "raw return or range compressed");
  add_choice<Kind>(app, "--kind", a->kind, {{"picture", Kind::picture}, {"pulse", Kind::pulse}, {"range", Kind::cell}},
                   "the matrix, one pulse against range, or one range against time");
  app.add_option("--range", a->range_m, "slant ranges that are seen, m")->expected(2)->type_name("FROM TO");
  app.add_option("--time", a->time_s, "azimuth times that are seen, s")->expected(2)->type_name("FROM TO");
  add_real(app, "--at-range", a->at_m, "M", "range of --kind range (default: the middle)");
  add_real(app, "--at-time", a->at_s, "S", "time of --kind pulse (default: the middle)");
  app.add_flag("--screen", a->screen, "one sample for each pixel, as the windows have it");
  add_look(app, *a);
  add_text(app, "--csv", a->csv, "FILE", "the values of the cut as well");
  app.add_flag("--force", a->force, "replace files that exist");
  add_sample_arguments(app, a->samples);
  add_scene_overrides(app, a->overrides);
  add_examples(
      app, {{"sarsim plot sar_r.scr -o echoes.png", "what its first simulation records"},
            {"sarsim plot sar_r.scr --radar Radar1 --data compressed --show db -o a.svg", "any window, in decibels"},
            {"sarsim plot scene.scr --kind pulse --show magnitude -o pulse.pdf", "magnitude against slant range"},
            {"sarsim plot recording.h5 --show db --dark -o b.png", "a file of samples"}});
  return [a](Streams& streams) { return plot(*a, streams); };
}

}  // namespace sarsim::cli
