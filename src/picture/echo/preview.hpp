#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "core/report/problem.hpp"
#include "core/task/latest_only_worker.hpp"
#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/echo_window.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/engine.hpp"
#include "simulate/plan/target_ranges.hpp"

namespace sarsim::picture {

/// What becomes of rows of raw data that are longer than 2^20 samples.
enum class LongRows {
  by_screen,  ///< They take the screen's sampling: one of them would hold up a cancel.
  computed,   ///< They are computed as they are, up to the length that recordings may have.
};

/// What a simulation window wants to see.
struct PreviewRequest {
  std::shared_ptr<const scene::Scene> scene;  ///< Its own simulations and geometry tables do not matter.
  EchoWindow window;
  PlotSize size;
  simulate::Engine engine = simulate::Engine::automatic;
  bool show_all_targets = false;  ///< Choose the ranges so that all targets are seen; `EchoMatrix::window` has them.
  LongRows long_rows = LongRows::by_screen;
};

/// What became of a request.
struct PreviewEvent {
  enum class Kind {
    started,   ///< Planned; no row is ready.
    rows,      ///< More rows are ready: first a coarse picture, then now and then.
    finished,  ///< All rows are ready.
    failed,    ///< `problems` say why.
  };
  Kind kind = Kind::started;
  std::uint64_t request = 0;                 ///< What `show` returned.
  std::shared_ptr<const EchoMatrix> matrix;  ///< Not where planning failed.
  core::Problems problems;                   ///< Errors where it failed.
};

/// Computes the echo matrix of one simulation window in the background, on all cores, coarse rows first. The samples
/// are those of the recording that the window stands for: the same plan, engine and noise as a run to a file has. Every
/// new request ends the one before. What was prepared for a scene serves the next request for the same scene.
class Preview {
 public:
  /// Called on the threads that compute, from one at a time, by the rules of core::LatestOnlyWorker::tell.
  using Listener = std::function<void(const PreviewEvent&)>;

  /// @param threads  0: one for each core
  explicit Preview(Listener listener, unsigned threads = 0);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Begins; returns at once.
  std::uint64_t show(PreviewRequest request) { return requests_.show(std::move(request)); }
  /// Ends what is being computed, within the time of a row of the recording.
  void cancel() { requests_.cancel(); }
  /// Waits until nothing is being computed.
  void wait() { requests_.wait(); }

 private:
  struct Prepared;
  void work(const PreviewRequest& request, std::uint64_t number, const core::StopFlag& stop);
  void compute(const PreviewRequest& request, std::uint64_t number, const core::StopFlag& stop);
  void compute_rows(EchoMatrix& matrix, const std::shared_ptr<const EchoMatrix>& shared, std::uint64_t number,
                    const core::StopFlag& stop);
  std::shared_ptr<const Prepared> prepared(const PreviewRequest& request, const core::StopFlag& stop);
  void tell(const PreviewEvent& event, const core::StopFlag& stop);

  Listener listener_;
  unsigned threads_;
  std::shared_ptr<const Prepared> prepared_;  // used by the thread of the requests alone
  std::shared_ptr<SampleRoom> room_ = std::make_shared<SampleRoom>();
  core::LatestOnlyWorker<PreviewRequest> requests_;  // last: its thread uses everything above
};

/// What `Preview` does before its first row, for those who want the plan: the scene's problems that stop it, or the
/// plan of what is shown.
struct ShownPlan {
  core::Problems problems;  ///< Errors only.
  std::shared_ptr<const simulate::Plan> plan;
};
/// @param resolved  of the scene
[[nodiscard]] ShownPlan plan_shown(const scene::Scene& scene, std::shared_ptr<const simulate::ResolvedScene> resolved,
                                   const EchoWindow& window, const PlotSize& size, simulate::Engine engine,
                                   LongRows long_rows, const core::StopFlag* stop = nullptr);

/// Computes a request to its end: the event that it finished or failed with.
/// @throws core::Interrupted when stopped
[[nodiscard]] PreviewEvent shown(const PreviewRequest& request, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::picture
