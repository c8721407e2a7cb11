#include "cli/command/plot_overlay.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "picture/echo/radar_figures.hpp"
#include "picture/figure/overlay.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

// What one curve is of, and its name in the legend.
struct Layer {
  std::string name;
  PlotArguments arguments;
};

void expect_few(std::size_t layers) {
  if (layers > picture::max_overlaid_curves)
    throw core::InvalidRequest(fmt::format("{} curves in one picture cannot be told apart", layers),
                               fmt::format("{} are possible: make several pictures", picture::max_overlaid_curves));
}

void add_variations(std::vector<Layer>& layers, const PlotArguments& a, const core::StopFlag* stop) {
  const workflow::SceneInput input =
      workflow::read_scene(a.input, a.overrides, workflow::CheckLevel::reading, {core::thread_count(0), stop});
  workflow::SweepValues values;
  values.settings = a.variations;
  values.folder = fs::path(a.input).parent_path();
  const workflow::Sweep sweep(input.scene, values, {a.input, a.overrides, input.names, input.sources});
  expect_few(sweep.size());
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    Layer layer{sweep.label(i), a};
    sweep.add_to(layer.arguments.overrides, i);
    layers.push_back(std::move(layer));
  }
}

std::vector<Layer> layers_of(const PlotArguments& a, const core::StopFlag* stop) {
  std::vector<Layer> layers;
  if (a.variations.empty())
    layers.push_back({fs::path(a.input).filename().string(), a});
  else
    add_variations(layers, a, stop);
  for (const std::string& path : a.others) {
    Layer layer{fs::path(path).filename().string(), a};
    layer.arguments.input = path;
    layers.push_back(std::move(layer));
  }
  expect_few(layers.size());
  return layers;
}

}  // namespace

bool is_overlaid(const PlotArguments& a) { return !a.others.empty() || !a.variations.empty(); }

Plotted plot_overlaid(const PlotArguments& a, const std::function<Plotted(const PlotArguments&)>& plot_one,
                      const core::StopFlag* stop) {
  std::vector<picture::OverlaidFigure> figures;
  for (const Layer& layer : layers_of(a, stop)) figures.push_back({layer.name, plot_one(layer.arguments).figure});
  std::optional<picture::Figure> together = picture::overlaid(figures);
  if (!together)
    throw core::InvalidRequest(
        "these curves do not fit into one pair of axes",
        fmt::format("their axes must show the same quantities in the same units, and at most {} curves "
                    "can be told apart",
                    picture::max_overlaid_curves));
  Plotted plotted{std::move(*together), {}};
  if (!a.csv.empty()) plotted.table = picture::curves_table(plotted.figure, ',');
  return plotted;
}

}  // namespace sarsim::cli
