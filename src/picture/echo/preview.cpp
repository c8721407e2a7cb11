#include "picture/echo/preview.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "scene/check/check.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::picture {

namespace {

using Clock = std::chrono::steady_clock;

// A coarse picture is shown with so many rows, or after a while with the fewest that give an idea.
constexpr std::size_t coarse_rows = 16;
constexpr std::size_t coarsest_rows = 4;
constexpr auto coarse_wait = std::chrono::milliseconds(20);
constexpr auto between_events = std::chrono::milliseconds(30);
// Longer rows of raw data are long (LongRows).
constexpr double longest_row = 0x1p20;

core::Problem failure(std::string message) { return core::error(std::move(message)); }

// Errors that stop a recording of one radar.
core::Problems errors_for(core::Problems problems, std::size_t radar) {
  std::erase_if(problems, [&](const core::Problem& p) {
    const std::string& kind = p.subject.kind;
    return p.severity != core::Severity::error || kind == "simulation" || kind == "geometry" ||
           (kind == "radar" && p.subject.index != radar);
  });
  return problems;
}

// What a plan needs of a scene besides its resolved targets, with the simulation in question alone.
scene::Scene scene_for(const scene::Scene& scene, const scene::Simulation& simulation) {
  scene::Scene small;
  small.platforms = scene.platforms;
  small.radars = scene.radars;
  small.options = scene.options;
  small.simulations.push_back(simulation);
  return small;
}

core::Problems simulation_errors(const scene::Scene& scene) {
  core::Problems problems = scene::check(scene);
  std::erase_if(problems, [](const core::Problem& p) {
    return p.severity != core::Severity::error || p.subject.kind != "simulation";
  });
  return problems;
}

}  // namespace

ShownPlan plan_shown(const scene::Scene& scene, std::shared_ptr<const simulate::ResolvedScene> resolved,
                     const EchoWindow& window, const PlotSize& size, simulate::Engine engine, LongRows long_rows,
                     const core::StopFlag* stop) {
  ShownPlan shown;
  const std::size_t radar = scene::find_radar(scene, window.recording.radar);
  if (radar == scene::not_found) {
    shown.problems.push_back(failure("radar '" + window.recording.radar + "' is not defined"));
    return shown;
  }
  const double bandwidth = radar::bandwidth_hz(simulate::resolve_radar(scene, *resolved, radar).pulse);
  const simulate::Conventions& conventions = resolved->conventions;
  scene::Simulation simulation = shown_simulation(window, bandwidth, size.width_px, conventions);
  if (long_rows == LongRows::by_screen && simulation.processing == scene::Processing::raw &&
      simulate::sample_count(simulation, conventions.light_speed_mps) > longest_row) {
    EchoWindow screen = window;
    screen.sampling.kind = Sampling::Kind::screen;
    simulation = shown_simulation(screen, bandwidth, size.width_px, conventions);
  }
  const scene::Scene small = scene_for(scene, simulation);
  shown.problems = simulation_errors(small);
  if (!shown.problems.empty()) return shown;
  simulate::Plan plan = simulate::make_plan(small, 0, std::move(resolved), engine, stop);
  if (plan.acquisition.timing.rows == 0) {
    shown.problems.push_back(failure("no complete burst is sent within the azimuth window"));
    return shown;
  }
  shown.plan = std::make_shared<const simulate::Plan>(std::move(plan));
  return shown;
}

// What a scene needs before any window of it can be planned.
struct Preview::Prepared {
  std::shared_ptr<const scene::Scene> scene;
  core::Problems problems;                                  // of all kinds
  std::shared_ptr<const simulate::ResolvedScene> resolved;  // where there are no errors for the radar asked for
};

Preview::Preview(Listener listener, unsigned threads)
    : listener_(std::move(listener)),
      threads_(core::thread_count(threads)),
      requests_([this](const PreviewRequest& request, std::uint64_t number, const core::StopFlag& stop) {
        work(request, number, stop);
      }) {}

Preview::~Preview() = default;

void Preview::work(const PreviewRequest& request, std::uint64_t number, const core::StopFlag& stop) {
  try {
    compute(request, number, stop);
  } catch (const core::Interrupted&) {
    return;
  } catch (const simulate::ImpossibleEcho& e) {
    tell({PreviewEvent::Kind::failed, number, nullptr, {e.problem}}, stop);
  } catch (const std::exception& e) {
    tell({PreviewEvent::Kind::failed, number, nullptr, {failure(e.what())}}, stop);
  }
}

void Preview::tell(const PreviewEvent& event, const core::StopFlag& stop) {
  requests_.tell(stop, [&] {
    if (listener_) listener_(event);
  });
}

std::shared_ptr<const Preview::Prepared> Preview::prepared(const PreviewRequest& request, const core::StopFlag& stop) {
  if (prepared_ && prepared_->scene == request.scene) return prepared_;
  auto fresh = std::make_shared<Prepared>();
  fresh->scene = request.scene;
  const core::WorkControl control{threads_, &stop};
  fresh->problems = scene::check(*request.scene, control);
  prepared_ = fresh;
  return fresh;
}

void Preview::compute(const PreviewRequest& request, std::uint64_t number, const core::StopFlag& stop) {
  const auto scene = prepared(request, stop);
  const std::size_t radar = scene::find_radar(*request.scene, request.window.recording.radar);
  core::Problems errors = errors_for(scene->problems, radar);
  if (errors.empty() && radar != scene::not_found && !scene->resolved) {
    auto with_resolved = std::make_shared<Prepared>(*scene);
    with_resolved->resolved =
        std::make_shared<const simulate::ResolvedScene>(simulate::resolve(*request.scene, {threads_, &stop}));
    prepared_ = with_resolved;
  }
  EchoWindow window = request.window;
  ShownPlan shown;
  if (errors.empty() && prepared_->resolved) {
    if (request.show_all_targets) {
      const simulate::Link seen_by = simulate::resolve_radar(*request.scene, *prepared_->resolved, radar);
      const scene::Simulation& s = window.recording;
      const simulate::RangeExtent extent = simulate::target_ranges(
          *prepared_->resolved, seen_by, seen_by.repetition.pulses_in(s.time_start_s, s.time_end_s), &stop);
      set_view(window, showing_targets(view_of(window), extent.nearest_m, extent.farthest_m, seen_by.pulse.width_s,
                                       prepared_->resolved->conventions.light_speed_mps));
    }
    shown =
        plan_shown(*request.scene, prepared_->resolved, window, request.size, request.engine, request.long_rows, &stop);
    errors = std::move(shown.problems);
  } else if (errors.empty()) {
    errors.push_back(failure("radar '" + window.recording.radar + "' is not defined"));
  }
  if (!errors.empty()) {
    tell({PreviewEvent::Kind::failed, number, nullptr, std::move(errors)}, stop);
    return;
  }
  const auto matrix = std::make_shared<EchoMatrix>(shown.plan, window, request.size, room_);
  tell({PreviewEvent::Kind::started, number, matrix, {}}, stop);
  compute_rows(*matrix, matrix, number, stop);
  tell({PreviewEvent::Kind::finished, number, matrix, {}}, stop);
}

void Preview::compute_rows(EchoMatrix& matrix, const std::shared_ptr<const EchoMatrix>& shared, std::uint64_t number,
                           const core::StopFlag& stop) {
  std::mutex pace;
  bool coarse_shown = false;
  const Clock::time_point begin = Clock::now();
  Clock::time_point last;
  const std::vector<std::size_t> order = simulate::refinement_order(matrix.rows());
  simulate::compute_sampled_rows(matrix.plan(), matrix.places().selection, order, {threads_, &stop}, matrix.samples(),
                                 [&](std::size_t row) {
                                   matrix.set_ready(row);
                                   {
                                     const std::scoped_lock hold(pace);
                                     const Clock::time_point now = Clock::now();
                                     const std::size_t enough = now - begin < coarse_wait ? coarse_rows : coarsest_rows;
                                     if (matrix.ready_rows() < enough || (coarse_shown && now - last < between_events))
                                       return;
                                     coarse_shown = true;
                                     last = now;
                                   }
                                   tell({PreviewEvent::Kind::rows, number, shared, {}}, stop);
                                 });
}

PreviewEvent shown(const PreviewRequest& request, const core::StopFlag* stop) {
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
  std::unique_lock hold(lock);
  while (!end) {
    changed.wait_for(hold, std::chrono::milliseconds(50));
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
  }
  return *end;
}

}  // namespace sarsim::picture
