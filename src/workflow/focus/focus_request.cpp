#include "workflow/focus/focus_request.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

void expect_options_that_agree(const FocusRequest& request) {
  const bool back_projection = request.algorithm == FocusAlgorithm::back_projection;
  const bool on_ground = request.grid == FocusGrid::ground;
  if (!back_projection && on_ground)
    throw core::InvalidRequest("--grid ground needs an algorithm that takes any points",
                               "add --algorithm back-projection");
  if (!back_projection && request.start_stop)
    throw core::InvalidRequest("--start-stop is for back-projection", "add --algorithm back-projection");
  if (back_projection && request.motion.value_or(MotionOrder::none) != MotionOrder::none)
    throw core::InvalidRequest("back-projection takes the track as it is, and needs no motion compensation",
                               "leave out --motion-compensation");
  if (on_ground && request.autofocus)
    throw core::InvalidRequest("--autofocus needs an image of slant range", "leave out --grid ground");
  if (!request.autofocus && (request.autofocus_piece_m || !request.autofocus_phase.empty()))
    throw core::InvalidRequest("--autofocus-piece and --autofocus-phase are options of --autofocus", "add --autofocus");
  if (request.anchor && !request.output.empty() && !is_sicd(request.output))
    throw core::InvalidRequest("--anchor places a SICD file on the Earth", "name the output .nitf, or leave it out");
  if (request.autofocus_piece_m && !(*request.autofocus_piece_m > 0.0))
    throw core::InvalidRequest("--autofocus-piece must be above 0", "give metres along the track");
}

// A folder, or else the nearest one above it.
fs::path first_that_exists(fs::path folder) {
  std::error_code ignored;
  while (!folder.empty() && folder != folder.root_path() && !fs::exists(folder, ignored)) folder = folder.parent_path();
  return folder;
}

void expect_outputs_to_be_free(const FocusRequest& request) {
  if (request.magnitude && (request.output.empty() || !is_envi(request.output)))
    throw core::InvalidRequest("--magnitude makes ENVI images", "name the output .img");
  const std::vector<fs::path> paths = outputs_of(request);
  for (const fs::path& path : paths) expect_no_picture(path, "--out");
  std::vector<fs::path> named = named_sources(request.input);
  if (!request.navigation.empty()) named.emplace_back(request.navigation);
  expect_free_outputs(paths, {InputList::named(std::move(named)), request.force, "--out"});
  for (const fs::path& path : paths) {
    expect_image_ending(path, "--out");
    const fs::path folder = first_that_exists(path.parent_path());
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored))
      throw core::InvalidRequest(
          fmt::format("'{}' cannot be made: '{}' is not a folder", path.string(), folder.string()),
          "give the output another name");
  }
}

}  // namespace

const char* word_of(FocusAlgorithm algorithm) {
  switch (algorithm) {
    case FocusAlgorithm::range_doppler: return "range-doppler";
    case FocusAlgorithm::chirp_scaling: return "chirp-scaling";
    case FocusAlgorithm::back_projection: return "back-projection";
    case FocusAlgorithm::automatic: return "auto";
    case FocusAlgorithm::omega_k: break;
  }
  return "omega-k";
}

void validate(const FocusRequest& request) {
  expect_options_that_agree(request);
  expect_outputs_to_be_free(request);
}

std::vector<fs::path> outputs_of(const FocusRequest& request) {
  std::vector<fs::path> paths;
  if (!request.output.empty()) paths = files_of_image(request.output);
  if (request.magnitude) std::ranges::copy(files_of_image(magnitude_path(request.output)), std::back_inserter(paths));
  if (!request.autofocus_phase.empty()) paths.push_back(request.autofocus_phase);
  return paths;
}

}  // namespace sarsim::workflow
