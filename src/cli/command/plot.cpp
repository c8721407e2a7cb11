#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/plot_arguments.hpp"
#include "cli/command/plot_overlay.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/os/output_file.hpp"
#include "core/text/number_text.hpp"
#include "picture/colour/colour_map.hpp"
#include "picture/figure/picture_file.hpp"
#include "workflow/convert/convert_options.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

const std::vector<std::pair<std::string, PlotKind>>& kind_words() {
  static const std::vector<std::pair<std::string, PlotKind>> words{
      {"picture", PlotKind::picture},       {"pulse", PlotKind::pulse},
      {"range", PlotKind::range},           {"profile", PlotKind::profile},
      {"doppler", PlotKind::range_doppler}, {"doppler-time", PlotKind::doppler_time},
      {"spectrum", PlotKind::spectrum},     {"phase", PlotKind::phase},
      {"antenna", PlotKind::antenna},       {"sent", PlotKind::sent},
      {"function", PlotKind::function},     {"track", PlotKind::track},
      {"footprint", PlotKind::footprint},   {"scene", PlotKind::scene}};
  return words;
}

std::string word_of(PlotKind kind) {
  return std::ranges::find(kind_words(), kind, [](const auto& pair) { return pair.second; })->first;
}

void write_table(const PlotArguments& a, const std::string& table) {
  if (a.csv.empty()) return;
  core::OutputFile file(a.csv, a.force);
  file.write(std::as_bytes(std::span(table)));
  file.commit();
}

bool is_script(const PlotArguments& a) { return workflow::language_of_name(a.input).has_value(); }

workflow::InputList files_read(const PlotArguments& a) {
  std::vector<fs::path> files{a.input, a.samples.script};
  files.insert(files.end(), a.others.begin(), a.others.end());
  workflow::SceneOverrides overrides = a.overrides;
  overrides.settings.insert(overrides.settings.end(), a.variations.begin(), a.variations.end());
  std::ranges::move(workflow::files_of(overrides, fs::path(a.input).parent_path()), std::back_inserter(files));
  return workflow::InputList::named(std::move(files));
}

void expect_names(const PlotArguments& a) {
  if (a.out.empty() && a.csv.empty())
    throw core::InvalidRequest("no output is given", "name a picture with -o, or a table with --csv");
  if (!a.out.empty() && !picture::picture_kind_of(a.out))
    throw core::InvalidRequest("'" + a.out + "' does not say which kind of picture",
                               fmt::format("end it with {}", picture::picture_endings));
  std::vector<fs::path> paths;
  for (const std::string& path : {a.out, a.csv})
    if (!path.empty() && !(a.frames && path == a.out))
      paths.emplace_back(path);  // Pictures of a film have names of their own.
  workflow::expect_free_outputs(paths, {files_read(a), a.force, "-o or --csv"});
  for (const fs::path& path : paths)
    if (path.has_parent_path() && !fs::is_directory(path.parent_path()))
      throw core::InvalidRequest(fmt::format("there is no folder '{}'", path.parent_path().string()),
                                 "make it, or write into one that is there");
}

// The drawing library draws no larger pictures.
void expect_size(const PlotArguments& a) {
  constexpr double max_dots_a_side = 32767.0;
  constexpr double max_dots = 0x1p29;
  const double scale = a.scale.value_or(1.0);
  const double width = std::round(static_cast<double>(a.size[0]) * scale);
  const double height = std::round(static_cast<double>(a.size[1]) * scale);
  if (std::max(width, height) <= max_dots_a_side && width * height <= max_dots) return;
  throw core::InvalidRequest(
      fmt::format("--size and --scale: a picture of {} x {} dots is too large", width, height),
      fmt::format("at most {} dots to a side and {} million in all", max_dots_a_side, std::floor(max_dots * 1e-6)));
}

void expect_limits(const PlotArguments& a) {
  if (a.limits.size() == 2 && a.limits[0] == a.limits[1])
    throw core::InvalidRequest("--limits: the two values are the same", "give those of the first and the last colour");
}

// An option that was given, and the kinds that it means something for.
struct Use {
  const char* option;
  bool given;
  std::vector<PlotKind> kinds;
};

// Options that would be ignored are mistakes, all of them at once.
void expect_used(const PlotArguments& a) {
  using K = PlotKind;
  const std::vector<K> cuts{K::pulse, K::range};
  const std::vector<K> of_samples{K::pulse,        K::range,    K::profile, K::range_doppler,
                                  K::doppler_time, K::spectrum, K::phase};
  std::vector<K> echoes = of_samples;
  echoes.insert(echoes.begin(), K::picture);
  std::vector<K> of_radars = echoes;
  of_radars.insert(of_radars.end(), {K::antenna, K::sent});
  std::vector<K> quantities = echoes;
  quantities.push_back(K::antenna);
  const std::vector<K> levels{K::picture,      K::pulse,    K::range,   K::profile, K::range_doppler,
                              K::doppler_time, K::spectrum, K::antenna, K::sent};
  const std::vector<K> colours{K::picture};
  std::vector<K> timed = echoes;
  timed.insert(timed.end(), {K::track, K::footprint, K::scene});
  std::vector<K> of_scenes = of_radars;
  of_scenes.insert(of_scenes.end(), {K::track, K::footprint, K::scene});
  std::vector<K> of_one_radar = of_radars;
  of_one_radar.insert(of_one_radar.end(), {K::footprint, K::scene});
  std::vector<K> of_one_time = of_samples;
  of_one_time.push_back(K::scene);
  const std::vector<K> views{K::scene};
  of_radars.push_back(K::footprint);
  const std::vector<K> of_curves{K::pulse, K::range, K::profile, K::spectrum, K::phase, K::antenna, K::sent};
  const std::vector<Use> uses{
      {"--simulation", a.simulation.has_value(), of_radars},
      {"--radar", !a.radar.empty(), of_one_radar},
      {"--data", a.processing.has_value(), echoes},
      {"--range", !a.range_m.empty(), echoes},
      {"--time", !a.time_s.empty(), timed},
      {"--azimuth", !a.azimuth_m.empty(), echoes},
      {"--rate", a.rate_hz.has_value(), echoes},
      {"--screen", a.screen, echoes},
      {"--tolerance", a.overrides.tolerance.has_value(), echoes},
      {"--seed", a.overrides.seed.has_value(), timed},
      {"--set", !a.overrides.settings.empty(), of_scenes},
      {"--targets", !a.overrides.targets.empty(), of_scenes},
      {"--at-range", a.at_m.has_value(), {K::range, K::range_doppler, K::doppler_time, K::phase}},
      {"--at-time", a.at_s.has_value(), of_one_time},
      {"--at-azimuth", a.at_azimuth_m.has_value(), cuts},
      {"--pulses", a.pulses.has_value(), {K::range, K::profile, K::range_doppler, K::doppler_time, K::phase}},
      {"--interval", a.interval.has_value(), {K::doppler_time}},
      {"--recorded", a.recorded, of_samples},
      {"--show", a.quantity.has_value(), quantities},
      {"--span", a.span_db.has_value(), levels},
      {"--mean", a.mean.has_value(), {K::profile}},
      {"--window", a.window.has_value(), {K::range_doppler, K::doppler_time, K::spectrum}},
      {"--padding", a.padding.has_value(), {K::range_doppler, K::doppler_time}},
      {"--wrapped", a.wrapped, {K::phase}},
      {"--mark-peaks", a.peaks.has_value(), cuts},
      {"--function", !a.function.empty(), {K::function}},
      {"--compare", a.compare, {K::function}},
      {"--angles", !a.angles_deg.empty(), {K::antenna}},
      {"--view", a.view.has_value(), views},
      {"--look", !a.look_deg.empty(), views},
      {"--follow", !a.followed.empty(), views},
      {"--perspective", a.perspective, views},
      {"--illuminated", a.illuminated, views},
      {"--trails", a.tracks.has_value(), views},
      {"--frames", a.frames.has_value(), views},
      {"--with", !a.others.empty(), of_curves},
      {"--vary", !a.variations.empty(), of_curves},
      {"--draw", a.draw_as.has_value(), colours},
      {"--colours", a.map.has_value(), colours},
      {"--invert", a.inverted, colours},
      {"--limits", !a.limits.empty(), colours},
      {"--percentile", a.percentile.has_value(), colours},
      {"--peak", a.peak, colours}};
  core::Problems problems;
  for (const Use& use : uses) {
    if (!use.given || std::ranges::find(use.kinds, a.kind) != use.kinds.end()) continue;
    core::Problem problem = core::error(fmt::format("{} means nothing for --kind {}", use.option, word_of(a.kind)));
    for (const PlotKind kind : use.kinds) problem.hint += (problem.hint.empty() ? "it is for " : ", ") + word_of(kind);
    problems.push_back(std::move(problem));
  }
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
}

// What --show says by itself.
picture::DisplayQuantity shown_quantity(const PlotArguments& a) {
  const bool in_decibels = a.kind == PlotKind::profile || a.kind == PlotKind::range_doppler ||
                           a.kind == PlotKind::doppler_time || a.kind == PlotKind::spectrum || a.kind == PlotKind::sent;
  return a.quantity.value_or(in_decibels ? picture::DisplayQuantity::decibels : picture::DisplayQuantity::magnitude);
}

// Of two options that contradict each other, one would be ignored.
void expect_no_contradiction(const PlotArguments& a) {
  if (a.screen && (a.recorded || a.rate_hz))
    throw core::InvalidRequest(
        fmt::format("--screen and {} request different samples", a.recorded ? "--recorded" : "--rate"),
        "leave one of them out");
  if (a.span_db && shown_quantity(a) != picture::DisplayQuantity::decibels)
    throw core::InvalidRequest("--span is a number of decibels, which are not shown", "add --show db, or leave it out");
}

// An option that was given, and whether it is for scripts or for files.
struct InputUse {
  const char* option;
  bool given;
  bool of_script;
};

void expect_used_by_input(const PlotArguments& a) {
  const bool script = is_script(a);
  const workflow::SceneOverrides& overrides = a.overrides;
  const workflow::SampleArguments& samples = a.samples;
  const std::vector<InputUse> uses{{"--radar", !a.radar.empty(), true},
                                   {"--data", a.processing.has_value(), true},
                                   {"--rate", a.rate_hz.has_value(), true},
                                   {"--screen", a.screen, true},
                                   {"--profile", overrides.profile.has_value(), true},
                                   {"--pulse", overrides.pulse.has_value(), true},
                                   {"--tolerance", overrides.tolerance.has_value(), true},
                                   {"--seed", overrides.seed.has_value(), true},
                                   {"--set", !overrides.settings.empty(), true},
                                   {"--targets", !overrides.targets.empty(), true},
                                   {"--vary", !a.variations.empty(), true},
                                   {"--from", samples.format.has_value(), false},
                                   {"--columns", samples.columns.has_value(), false},
                                   {"--bits", samples.bits.has_value(), false},
                                   {"--lsb", samples.lsb_v.has_value(), false},
                                   {"--dataset", !samples.dataset.empty(), false},
                                   {"--script", !samples.script.empty(), false}};
  core::Problems problems;
  for (const InputUse& use : uses) {
    if (!use.given || use.of_script == script) continue;
    problems.push_back({});
    problems.back().message = fmt::format("{} means nothing for {}", use.option, script ? "a script" : "a file");
    problems.back().hint = use.of_script ? "it is for scripts, whose echoes are computed" : "it is for files";
  }
  if (!script && a.simulation && samples.script.empty())
    problems.push_back(
        core::InvalidRequest("--simulation is a number in a script", "name it with --script").problems.front());
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
}

// The name of the input, and what is seen of it where that is not the whole.
std::string title_for(const PlotArguments& a, const picture::Figure& figure) {
  if (a.title) return *a.title;
  const std::string name = fs::path(a.input).filename().string();
  return figure.title.empty() ? name : name + ": " + figure.title;
}

ExitStatus plot(PlotArguments& a, Streams& streams) {
  a.kind = a.wanted_kind.value_or(PlotKind::picture);
  expect_names(a);
  expect_used(a);
  expect_no_contradiction(a);
  expect_used_by_input(a);
  expect_size(a);
  expect_limits(a);
  if (a.kind == PlotKind::scene) {
    plot_view(a, streams);
    return exit_done;
  }
  const auto plot_one = [&streams](const PlotArguments& one) {
    expect_used_by_input(one);
    return is_script(one) ? plot_scene(one, streams) : plot_file(one, streams);
  };
  Plotted plotted = is_overlaid(a) ? plot_overlaid(a, plot_one, streams.stop) : plot_one(a);
  plotted.figure.title = title_for(a, plotted.figure);
  if (!a.out.empty())
    picture::write_picture(plotted.figure, a.out,
                           {static_cast<int>(a.size[0]), static_cast<int>(a.size[1]), a.scale.value_or(1.0), a.dark},
                           streams.stop);
  write_table(a, plotted.table);
  return exit_done;
}

void add_kind(CLI::App& app, PlotArguments& a) {
  add_choice<PlotKind>(
      app, "--kind", a.wanted_kind, kind_words(),
      "the rows (default), one pulse against range, one range against time; profile, range-Doppler map "
      "or phase of several pulses; spectrum of one; antennas, the pulse sent, a user-defined function; the platforms' "
      "paths, an antenna's footprint; the scene in three dimensions");
}

bool is_positive(double number) { return number > 0.0; }

void add_choice_of_samples(CLI::App& app, PlotArguments& a) {
  CLI::Option* simulation =
      add_integer(app, "--simulation", a.simulation, 1, 1'000'000,
                  "which simulation of the script (default: the first, or the one that wrote the file)");
  add_text(app, "--radar", a.radar, "NAME", "any window of this radar instead of a simulation")->excludes(simulation);
  add_choice<scene::Processing>(app, "--data", a.processing,
                                {{"raw", scene::Processing::raw},
                                 {"compressed", scene::Processing::matched_filter},
                                 {"srp", scene::Processing::srp}},
                                "raw return or range compressed");
  add_two_reals(app, "--range", a.range_m, "FROM TO", "slant range limits, m");
  add_two_reals(app, "--time", a.time_s, "FROM TO", "azimuth time limits, s");
  add_two_reals(app, "--azimuth", a.azimuth_m, "FROM TO", "focused image: azimuth limits along the track, m");
  add_real(app, "--at-range", a.at_m, "M", "range of one range cell (default: the strongest)");
  add_real(app, "--at-time", a.at_s, "S", "time of one pulse, or of the middle of several (default: the middle)");
  add_real(app, "--at-azimuth", a.at_azimuth_m, "M",
           "focused image: azimuth position of one row (default: the strongest)");
  add_integer(app, "--pulses", a.pulses, 1, 1'000'000'000, "number of pulses around --at-time (default: all in view)");
  add_real(app, "--rate", a.rate_hz, "HZ", "sampling frequency instead of the simulation's", is_positive,
           "a number above 0");
  app.add_flag("--recorded", a.recorded, "cuts of the samples that a run saves, none in between");
  app.add_flag("--screen", a.screen, "one sample for each pixel, as the windows have it");
}

void add_choice_of_values(CLI::App& app, PlotArguments& a) {
  add_choice<picture::DisplayQuantity>(
      app, "--show", a.quantity,
      {{"real", picture::DisplayQuantity::real},
       {"imaginary", picture::DisplayQuantity::imaginary},
       {"magnitude", picture::DisplayQuantity::magnitude},
       {"phase", picture::DisplayQuantity::phase},
       {"db", picture::DisplayQuantity::decibels}},
      "quantity shown (default: real for scripts, magnitude for files and antennas, db for profiles and spectra)");
  add_choice<picture::ProfileMean>(
      app, "--mean", a.mean, {{"power", picture::ProfileMean::power}, {"coherent", picture::ProfileMean::coherent}},
      "how a profile is averaged (default: power)");
  add_choice<picture::SpectrumWindow>(app, "--window", a.window,
                                      {{"rectangular", picture::SpectrumWindow::rectangular},
                                       {"hann", picture::SpectrumWindow::hann},
                                       {"hanning", picture::SpectrumWindow::hann},
                                       {"none", picture::SpectrumWindow::rectangular},
                                       {"rect", picture::SpectrumWindow::rectangular},
                                       {"uniform", picture::SpectrumWindow::rectangular},
                                       {"hamming", picture::SpectrumWindow::hamming}},
                                      "weights of spectra and range-Doppler maps (default: hann)");
  add_integer(app, "--interval", a.interval, 1, 1 << 20, "doppler-time: pulses of each spectrum (default: 64)");
  add_integer(app, "--padding", a.padding, 1, 64, "Doppler bins for each pulse (default: 1)");
  app.add_flag("--wrapped", a.wrapped, "phases wrapped to +-180 deg, not unwrapped");
  add_integer(app, "--mark-peaks", a.peaks, 0, 100, "mark so many of the highest maxima of a cut");
  add_text(app, "--function", a.function, "OBJECT:FIELD", "which user-defined function, such as Plane:trajectory");
  app.add_flag("--compare", a.compare, "a function by all three interpolations");
  add_two_reals(app, "--angles", a.angles_deg, "FROM TO",
                "offsets of an antenna pattern, -360 to 360 deg (default: -90 90)");
}

void add_view(CLI::App& app, PlotArguments& a) {
  using From = picture::SceneLook::From;
  using Tracks = picture::DrawingOptions::Tracks;
  add_choice<From>(
      app, "--view", a.view,
      {{"start", From::start}, {"top", From::top}, {"front", From::front}, {"side", From::side}, {"beam", From::beam}},
      "scene: viewpoint; beam: along the beam of --radar (default: start)");
  add_two_reals(app, "--look", a.look_deg, "AZIMUTH ELEVATION",
                "scene: direction to the viewer, deg, instead of --view");
  add_text(app, "--follow", a.followed, "PLATFORM", "scene: platform kept in the centre");
  app.add_flag("--perspective", a.perspective, "scene: perspective view");
  app.add_flag("--illuminated", a.illuminated, "scene: the ground that was illuminated so far");
  add_choice<Tracks>(app, "--trails", a.tracks,
                     {{"plain", Tracks::plain}, {"time", Tracks::by_time}, {"speed", Tracks::by_speed}},
                     "scene: quantity coded by the colours of paths (default: plain)");
  add_integer(app, "--frames", a.frames, 1, 9999,
              "scene: so many pictures from --time FROM to TO, NAME-0001.png and so on");
}

void add_look(CLI::App& app, PlotArguments& a) {
  add_choice<picture::DrawAs>(
      app, "--draw", a.draw_as,
      {{"auto", picture::DrawAs::automatic},
       {"pixels", picture::DrawAs::pixels},
       {"pulses", picture::DrawAs::curves_per_pulse},
       {"ranges", picture::DrawAs::curves_per_range}},
      "colours, or a curve for each pulse or range (default: curves where pulses are far apart)");
  std::vector<std::pair<std::string, picture::ColourMap>> maps;
  for (const picture::ColourMapInfo& info : picture::colour_maps()) maps.emplace_back(info.name, info.map);
  add_choice<picture::ColourMap>(app, "--colours", a.map, maps,
                                 "map of colours (default: one that suits what is shown)");
  app.add_flag("--invert", a.inverted, "colours in the opposite order");
  app.add_flag("--peak", a.peak,
               "the largest sample in each pixel instead of a single one (always for focused images)");
  add_real(app, "--span", a.span_db, "DB", "dynamic range shown, dB (default: 60)", is_positive, "a number above 0");
  add_real(
      app, "--percentile", a.percentile, "P", "share of the samples within the colours, percent (default: 100)",
      [](double p) { return p > 0.0 && p <= 100.0; }, "a number above 0, at most 100");
  add_two_reals(app, "--limits", a.limits, "LOW HIGH", "values of the first and the last colour");
  app.add_option("--size", a.size, "pixels (default: 1000 700)")
      ->expected(2)
      ->check([](const std::string& text) {
        const auto pixels = core::parse_integer(text);
        return pixels && *pixels >= 64 && *pixels <= 20000
                   ? std::string()
                   : fmt::format("'{}' is not a whole number from 64 to 20000", text);
      })
      ->type_name("WIDTH HEIGHT");
  add_real(
      app, "--scale", a.scale, "S", "dots for each pixel of a PNG, 0.25 to 16 (default: 1)",
      [](double scale) { return scale >= 0.25 && scale <= 16.0; }, "a number from 0.25 to 16");
  app.add_flag("--dark", a.dark, "light text on a dark background");
  const auto take_title = [&a](const std::string& text) {
    if (text.starts_with("--")) throw CLI::ValidationError("--title", fmt::format("'{}' is not a title", text));
    a.title = text;
  };
  app.add_option_function<std::string>("--title", take_title, "above the picture (default: the name of the input)")
      ->type_name("TEXT");
}

}  // namespace

picture::PlotSize plot_pixels(const PlotArguments& a) {
  const double scale = a.scale.value_or(1.0);
  const auto left = [scale](std::int64_t all, double taken) {
    return static_cast<std::size_t>(std::max(16.0, (static_cast<double>(all) - taken) * scale));
  };
  return {left(a.size[0], 170.0), left(a.size[1], 150.0)};
}

void take_look(const PlotArguments& a, picture::DisplayQuantity usual, picture::EchoWindow& window) {
  window.quantity = a.quantity.value_or(usual);
  const picture::ColourMapKind kind = picture::kind_for(window.quantity);
  window.map = a.map.value_or(kind == picture::ColourMapKind::diverging
                                  ? (a.dark ? picture::ColourMap::balance_dark : picture::ColourMap::balance)
                              : kind == picture::ColourMapKind::cyclic ? picture::ColourMap::cycle
                                                                       : picture::ColourMap::ocean);
  window.inverted = a.inverted;
  window.draw_as = a.draw_as.value_or(picture::DrawAs::automatic);
  if (a.peak) window.pixel_rule = picture::PixelRule::peak;
  if (a.span_db) window.decibels.range_db = *a.span_db;
  if (a.percentile) window.limits.percentile = *a.percentile;
  if (a.limits.size() == 2) window.limits = {picture::LimitRule::Kind::manual, 100.0, a.limits[0], a.limits[1]};
}

Action add_plot(CLI::App& app) {
  auto a = std::make_shared<PlotArguments>();
  add_text(app, "input", a->input, "SCENE|FILE", "script (.scr), file of samples or focused image")->required();
  add_text(app, "-o,--out,--output", a->out, "PICTURE", "picture to write: .png, .svg or .pdf");
  add_kind(app, *a);
  add_choice_of_samples(app, *a);
  add_choice_of_values(app, *a);
  add_view(app, *a);
  add_look(app, *a);
  app.add_option("--with", a->others,
                 "lay the same curves of another script, recording or image over these; repeatable")
      ->type_name("SCENE|FILE")
      ->allow_extra_args(false);
  app.add_option("--vary", a->variations, "a curve for each value of a field of the script; repeatable")
      ->type_name("FIELD=VALUE,VALUE")
      ->allow_extra_args(false);
  add_text(app, "--csv", a->csv, "FILE", "the values as a table, beside the picture or instead of it");
  app.add_flag("--force", a->force, "replace files that exist");
  add_table_options(app, workflow::sample_option_table(), a->samples);
  add_scene_overrides(app, a->overrides);
  add_examples(
      app,
      {{"sarsim plot sar_r.toml -o echoes.png", "the echoes of its first recording"},
       {"sarsim plot sar_r.toml --radar Radar1 --data compressed --show db -o a.svg", "any range window, in decibels"},
       {"sarsim plot scene.toml --kind pulse --show magnitude -o pulse.pdf", "magnitude against slant range"},
       {"sarsim plot recording.h5 --kind doppler --at-range 3000 -o b.png", "the range-Doppler map of a file"},
       {"sarsim plot sar_r.img --show db -o image.png", "a focused image, with the peak of each pixel"},
       {"sarsim plot sar_r.toml --kind pulse --data compressed --show db --vary Radar1.window=rectangular,hamming "
        "-o c.png",
        "two curves in one picture"},
       {"sarsim plot sar_r.toml --kind track -o paths.svg", "a map of the platforms' paths, and their heights"},
       {"sarsim plot sar_r.toml --kind scene --illuminated -o view.png", "the scene, as the workbench shows it"},
       {"sarsim plot sar_r.toml --kind scene --frames 100 --follow Plane -o flight.png", "pictures for a film"},
       {"sarsim plot sar_r.toml --kind antenna --csv pattern.csv", "a table alone"}});
  return [a](Streams& streams) { return plot(*a, streams); };
}

}  // namespace sarsim::cli
