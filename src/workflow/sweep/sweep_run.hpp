#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/task/stop.hpp"
#include "simulate/plan/engine.hpp"
#include "workflow/record/products.hpp"
#include "workflow/sweep/sweep_axes.hpp"
#include "workflow/sweep/sweep_request.hpp"
#include "workflow/sweep/sweep_row.hpp"

namespace sarsim::workflow {

/// How the products of variations are made.
struct VariationRules {
  std::filesystem::path folder = ".";
  simulate::Engine engine = simulate::Engine::automatic;
  bool counts = false;                             ///< As in SinkOptions.
  bool header = false;                             ///< As in SinkOptions.
  bool replace = false;                            ///< Replace existing files.
  bool discard = false;                            ///< Compute and encode everything, write nothing.
  unsigned threads = 1;                            ///< Of each variation.
  PostProcessing post_processing{};                ///< What is made of each recording besides.
  std::filesystem::path post_processing_folder{};  ///< Of its files.
  std::size_t jobs = 1;                            ///< Variations beside each other.
  /// Called with each row before its file is begun, if one is written; empty: not called.
  std::function<void(const SweepRow&)> begin{};
};

/// A variation's scene, and how a follow-up finds it.
struct SweptScene {
  const scene::Scene& scene;
  RecordingArguments source;  ///< The script, with the values of the variation.
};

/// Those of a request, with one thread for each variation.
[[nodiscard]] VariationRules variation_rules(const SweepRequest& request);

/// The names of products, and what they depend on.
class VariationNames {
 public:
  /// @param products  with their files in the script as `path`
  VariationNames(const scene::Scene& base, const Sweep& sweep, const std::vector<workflow::ProductJob>& products,
                 const VariationRules& rules);

  /// The row of a product that has not been made yet: its numbers, file and stamp.
  [[nodiscard]] SweepRow row(std::size_t variation, std::size_t product) const;

 private:
  const Sweep& sweep_;
  const std::vector<workflow::ProductJob>& products_;
  std::vector<std::string> stems_;                    // Of each product; no two are alike.
  std::vector<std::size_t> format_axes_;              // Axis that sets the format of a product, or none.
  std::vector<std::vector<std::string>> extensions_;  // Of each product, for each value of that axis.
  std::uint64_t stamp_ = 0;                           // Of scene and rules.
};

/// Makes the products of a variation, those of `rows`, and completes these. An echo that cannot be computed, which the
/// check of some pulses did not see, is the row's `failure`; so are samples that are too large. Failures of the disk
/// are exceptions. A requested stop throws Interrupted and leaves nothing unfinished behind.
///
/// May be called on several threads at once.
///
/// @param done   told each row as soon as its product is complete, and of what is followed up before that, too
/// @return what follow-ups remarked on
core::Problems run_variation(const SweptScene& swept, const std::vector<workflow::ProductJob>& products,
                             std::vector<SweepRow*>& rows, const VariationRules& rules, const core::StopFlag* stop,
                             const std::function<void(const SweepRow&)>& done);

}  // namespace sarsim::workflow
