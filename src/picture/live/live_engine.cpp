#include "picture/live/live_engine.hpp"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "picture/live/incremental_echoes.hpp"
#include "picture/live/live_workflows.hpp"
#include "simulate/resolve/resolved.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/image/placed_image.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t coarse_targets = 128;
// Back projection of more samples times pulses has one by omega-k before it.
constexpr double quick_projections = 2e8;

// How one request is worked on.
struct Making {
  const LiveRequest& request;
  core::WorkControl control;
  const LiveEngine::Coarse& coarse;
};

LiveImage pixels_of(const workflow::FocusReport& report, std::size_t pulses, const Making& making) {
  const signal::FocusedImage& image = report.image.image;
  const bool slant = image.frame.plane == signal::ImagePlane::slant_range;
  const raster::FocusedPlaces places{
      {"Azimuth", "m", image.azimuth.first_m, image.azimuth.step_m},
      {slant ? "Slant range" : "Ground range", "m", image.range.first_m, image.range.step_m}};
  LiveImage pixels = live_image(report.image, places, making.request.size, making.control);
  pixels.product = LiveProduct::focused;
  pixels.made = fmt::format("{}, {} pulses", workflow::word_of(report.algorithm), pulses);
  if (report.motion != workflow::MotionOrder::none) pixels.made += ", motion compensated";
  if (report.autofocus) pixels.made += report.autofocus->applied ? ", autofocused" : ", autofocus found nothing";
  pixels.problems = report.problems;  // Of autofocus.
  return pixels;
}

// An image, and what it came of.
struct FocusedPixels {
  LiveImage image;
  workflow::FocusPipeline begun;
  workflow::FocusPipeline ended;
  signal::FocusedImage axes;
};

// The image of what was begun, without remarks.
FocusedPixels focused(workflow::FocusPipeline begun, const Making& making) {
  const std::size_t pulses = begun.input.echoes.rows;
  core::Observer observer;
  observer.stop = making.control.stop;
  FocusedPixels pixels;
  pixels.begun = std::move(begun);
  pixels.ended = pixels.begun;
  const workflow::FocusReport report = workflow::end_focus(pixels.ended, observer, workflow::FocusRemarks::later);
  pixels.image = pixels_of(report, pulses, making);
  pixels.axes = report.image.image;
  return pixels;
}

// Where the targets of the scene should be, or why that is not said.
void add_targets(FocusedPixels& pixels, const Making& making) {
  const std::size_t count = making.request.scene->targets.size();
  if (count > max_ringed_targets) {
    pixels.image.problems.push_back(core::note("there are too many targets to mark")
                                        .found(std::to_string(count))
                                        .expected(fmt::format("at most {}", max_ringed_targets)));
    return;
  }
  for (const workflow::TargetTheory& target : workflow::targets_on_image(pixels.begun, pixels.axes, making.control))
    pixels.image.targets.push_back({target.place.range_m, target.place.azimuth_m});
}

workflow::FocusPipeline begun(workflow::FocusInput input, const LiveOptions& options, const Making& making) {
  workflow::FocusPipeline work =
      workflow::begin_focus(std::move(input), focus_request_of(options, making.control.threads), making.control);
  work.place.reset();  // Of files alone.
  return work;
}

void tell_coarse(LiveImage image, std::string why, const Making& making) {
  image.coarse = true;
  image.coarsely = std::move(why);
  making.coarse(std::move(image));
}

// A look at some of many targets, where all of them have to be computed.
void tell_some_targets(const Making& making) {
  const scene::Scene& scene = *making.request.scene;
  IncrementalEchoes some;
  some.follow(std::make_shared<const scene::Scene>(thinned_targets(scene, making.request.simulation, coarse_targets)),
              0, making.control);
  LiveImage image = focused(begun(some.input(), making.request.options, making), making).image;
  image.cost.echoes = some.take_echoes();
  tell_coarse(std::move(image), fmt::format("{} of {} targets", coarse_targets, scene.targets.size()), making);
}

// Whether the image takes long by back projection, which the request asks for.
bool takes_long(const workflow::FocusInput& input, const LiveOptions& options) {
  const double samples = static_cast<double>(input.echoes.rows) * static_cast<double>(input.echoes.columns);
  return options.algorithm == workflow::FocusAlgorithm::back_projection &&
         samples * static_cast<double>(input.echoes.rows) > quick_projections;
}

LiveImage pixels_of(const workflow::InMemoryImage& kept, const core::Problems& problems, std::string made,
                    const Making& making) {
  LiveImage image =
      live_image(kept.rows, workflow::places_of(kept.content.header, "the image"), making.request.size, making.control);
  image.made = std::move(made);
  image.problems = problems;
  return image;
}

LiveImage make_profiles(const Making& making, const core::Observer& observer) {
  workflow::ProfilesRequest request = profiles_request_of(making.request);
  request.keep = true;
  request.threads = making.control.threads;
  const workflow::ProfilesReport report = workflow::profiles(request, observer);
  if (!report.kept) throw core::InvalidRequest("no profile was made");
  return pixels_of(*report.kept, report.problems, fmt::format("{} bursts", report.bursts), making);
}

LiveImage make_isar(const Making& making, const core::Observer& observer) {
  workflow::IsarRequest request = isar_request_of(making.request);
  request.keep = true;
  request.threads = making.control.threads;
  const auto made = [&] {
    const workflow::IsarReport report = workflow::isar(request, observer);
    if (report.images.empty() || !report.images.front().kept) throw core::InvalidRequest("no image was made");
    LiveImage image = pixels_of(*report.images.front().kept, report.problems,
                                fmt::format("{} bursts", report.images.front().bursts), making);
    image.product = LiveProduct::isar;
    return image;
  };
  // A quarter of the pixels takes a quarter of the time.
  const std::size_t usual = request.options.oversampling;
  request.options.oversampling = 1;
  tell_coarse(made(), "a pixel for each resolution cell", making);
  request.options.oversampling = usual;
  return made();
}

LiveImage make_doppler(const Making& making, const core::Observer& observer) {
  workflow::DopplerRequest request = doppler_request_of(making.request);
  request.keep = true;
  request.threads = making.control.threads;
  const workflow::DopplerReport report = workflow::doppler(request, observer);
  if (!report.kept) throw core::InvalidRequest("no map was made");
  return pixels_of(*report.kept, report.problems, fmt::format("{} pulses", report.options.pulses), making);
}

LiveImage make_ppi(const Making& making, const core::Observer& observer) {
  workflow::SearchRequest request = search_request_of(making.request);
  request.keep = true;
  request.threads = making.control.threads;
  const workflow::SearchReport report = workflow::search(request, observer);
  if (!report.kept) throw core::InvalidRequest("no picture was made");
  return pixels_of(*report.kept, report.problems, fmt::format("{} intervals", report.intervals), making);
}

}  // namespace

// What is kept from one focused image to the next.
struct LiveEngine::Focusing {
  IncrementalEchoes held;
  std::optional<workflow::FocusPipeline> last;  // as it was begun, for
  LiveOptions options;

  // The grid of the image and the Doppler centroid before a small change serve for a first look behind it.
  void tell_quickly(const Making& making) {
    if (!held.plan_is_old() || !last || options != making.request.options || takes_long(last->input, options)) return;
    workflow::FocusPipeline work = *last;
    work.input.echoes.copy = held.input().echoes.copy;
    tell_coarse(focused(std::move(work), making).image, "grid as before the change", making);
  }

  LiveImage make(const Making& making) {
    const LiveRequest& request = making.request;
    const bool many = request.scene->targets.size() > many_targets;
    if (many && !held.follows_cheaply(*request.scene, request.simulation)) tell_some_targets(making);
    held.follow(request.scene, request.simulation, making.control);
    tell_quickly(making);
    held.renew_plan(making.control);
    const workflow::FocusInput input = held.input();
    if (takes_long(input, request.options)) {
      LiveOptions quick = request.options;
      quick.algorithm = workflow::FocusAlgorithm::omega_k;
      tell_coarse(focused(begun(input, quick, making), making).image, "omega-k first", making);
    }
    last = begun(input, request.options, making);
    options = request.options;
    FocusedPixels pixels = focused(*last, making);
    pixels.image.cost.echoes = held.take_echoes();
    making.coarse(pixels.image);
    if (request.options.targets) add_targets(pixels, making);
    core::append(pixels.image.problems, workflow::diagnose_image(std::move(pixels.begun), std::move(pixels.ended),
                                                                 pixels.axes, making.control));
    return std::move(pixels.image);
  }
};

LiveEngine::LiveEngine(unsigned threads) : threads_(threads), focusing_(std::make_unique<Focusing>()) {}

LiveEngine::~LiveEngine() = default;

LiveImage LiveEngine::make(const LiveRequest& request, const core::StopFlag& stop, const Coarse& coarse) {
  const double begin_s = core::now_s();
  if (!request.scene || request.simulation >= request.scene->simulations.size())
    throw core::InvalidRequest("the scene has no recording", "create one under Recordings, with New");
  const Coarse timed = [&](LiveImage image) {
    image.cost.seconds = core::now_s() - begin_s;
    if (coarse) coarse(std::move(image));
  };
  const Making making{request, {threads_, &stop}, timed};
  core::Observer observer;
  observer.stop = &stop;
  LiveProduct product = request.options.product;
  if (product == LiveProduct::automatic) product = suitable_product(*request.scene, request.simulation);
  LiveImage image = product == LiveProduct::profiles  ? make_profiles(making, observer)
                    : product == LiveProduct::isar    ? make_isar(making, observer)
                    : product == LiveProduct::doppler ? make_doppler(making, observer)
                    : product == LiveProduct::ppi     ? make_ppi(making, observer)
                                                      : focusing_->make(making);
  image.product = product;
  image.cost.seconds = core::now_s() - begin_s;
  return image;
}

}  // namespace sarsim::picture
