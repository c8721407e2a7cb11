#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "signal/sar/focusing.hpp"
#include "simulate/plan/acquisition.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// Compressed echoes, read or computed when they are asked for, and the acquisition that they are of.
struct FocusInput {
  std::shared_ptr<const simulate::Acquisition> acquisition;
  signal::EchoRows echoes;
  std::size_t simulation = 0;                         ///< Position in the script's list.
  core::Problems problems;                            ///< Warnings about script and file.
  scene::World world;                                 ///< Where and when the scene is.
  std::vector<std::filesystem::path> sources{};       ///< Files that the echoes are made from.
  core::Problems of_files{};                          ///< Of the problems those about the files that the script names.
  std::shared_ptr<const raster::Raster> recording{};  ///< That the echoes are read from; null: they are computed.
};

/// Simulation number `simulation` of a sound scene, which becomes what focusing wants recorded (`recorded_for_sar`).
/// Where `problems` holds an error, there is nothing else.
[[nodiscard]] FocusInput focus_input_of(scene::Scene& scene, std::size_t simulation,
                                        const std::shared_ptr<const simulate::ResolvedScene>& resolved);
/// The same of a simulation that is planned already.
/// @param window  its plan, of any engine
[[nodiscard]] FocusInput focus_input_of(scene::Scene& scene, std::size_t simulation,
                                        const simulate::Acquisition& window);

/// Opens what the arguments name; throws core::InvalidRequest with all problems where it cannot be focused.
/// @param navigation  file of the motion that is believed, in place of the true one; empty: the true one
[[nodiscard]] FocusInput open_focus_input(const RecordingArguments& arguments, const core::WorkControl& control,
                                          const std::string& navigation = "");

}  // namespace sarsim::workflow
