#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

/// The motion of one platform that is to be written.
struct MotionRequest {
  std::string input;
  SceneOverrides overrides;
  std::string platform;           ///< Empty: the only one.
  std::string output;             ///< Its ending says the format; see `motion_format_of`.
  std::optional<double> start_s;  ///< Nothing: from the first recording on.
  std::optional<double> end_s;
  std::optional<double> spacing_s;  ///< Nothing: the widest that keeps the error.
  double error_m = 1e-6;            ///< Largest error of the interpolation.
  bool navigation = false;          ///< What the navigation believes, in place of the truth.
  bool force = false;               ///< Replace the output where it exists.
};

/// The formats of files of motion.
enum class MotionFormat {
  csv,        ///< t, x, y, z, vx, vy, vz.
  oem,        ///< CCSDS orbit ephemeris message.
  aem,        ///< CCSDS attitude ephemeris message.
  data_file,  ///< Of a script's trajectory.
};

/// The format that the ending of a file asks for: .csv, .oem, .aem, .txt or .dat; nothing for others.
[[nodiscard]] std::optional<MotionFormat> motion_format_of(const std::string& file);

/// What was written.
struct MotionReport {
  std::string platform;
  MotionFormat format = MotionFormat::csv;
  double first_s = 0.0;
  double last_s = 0.0;
  double spacing_s = 0.0;
  std::size_t samples = 0;
  /// What a reader of the file gets wrong between the samples; 0 for attitudes.
  double position_error_m = 0.0;
  double velocity_error_mps = 0.0;
  core::Problems remarks;
};

/// Writes how a platform moves, so that a reader of the file who interpolates as its format has it comes as near as
/// asked for. Jitter, which is drawn anew for each pulse, is no motion and left out. core::InvalidRequest where the
/// scene is not sound, the format cannot say it, or no spacing is close enough.
[[nodiscard]] MotionReport write_motion(const MotionRequest& request, const core::WorkControl& control = {});

/// A walking person as platforms of a scene.
struct WalkerRequest {
  double speed_mps = 1.0;
  double height_m = 1.8;
  double start_s = 0.0;
  double end_s = 5.0;
  std::string parent;  ///< Platform in whose frame the person walks along x; empty: the world.
  std::string output;  ///< A scene of format 2, to be included by others.
  bool force = false;
};

/// Writes 17 platforms, joints and ends of a skeleton, that move along given points, each with a target of 0.02 m2.
/// core::InvalidRequest where nobody walks so.
void write_walker(const WalkerRequest& request);

}  // namespace sarsim::workflow
