#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/os/output_file.hpp"
#include "core/text/facts.hpp"
#include "workflow/search/search_intervals.hpp"

namespace sarsim::workflow {

/// A point on the ground.
struct GroundPlace {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// An azimuth as people say it, 0 to 360 degrees.
[[nodiscard]] double bearing_deg(double azimuth_rad);

/// A detection, for the table of them.
/// @param target   position in the script of the target that it is of
/// @param doppler  intervals have Doppler frequencies
/// @param place    on the ground, where detections have one
[[nodiscard]] core::Facts facts_of(const SearchDetection& detection, std::optional<std::size_t> target, bool doppler,
                                   const std::optional<GroundPlace>& place);

/// The table of detections, written as they come (docs/theory/search-and-doppler.md): a line of names, then one for
/// each. What does not apply is left empty: Doppler of single pulses, ratios without noise, targets that are none of
/// the script's. The file appears with `finish`.
class DetectionTable {
 public:
  /// @param path     empty: it stays in memory
  /// @param doppler  intervals have Doppler frequencies
  /// @param places   detections have places on the ground
  DetectionTable(const std::filesystem::path& path, bool replace, bool doppler, bool places);

  /// Adds a line.
  /// @param target  position in the script of the target that it is of
  void append(const SearchDetection& detection, std::optional<std::size_t> target, const GroundPlace& place = {});
  /// Gives the file its name.
  void finish();
  [[nodiscard]] std::size_t count() const { return count_; }
  /// All of a table that stays in memory.
  [[nodiscard]] const std::string& text() const { return pending_; }

 private:
  void write_pending();

  std::optional<core::OutputFile> file_;
  std::string pending_;
  bool doppler_;
  bool places_;
  std::size_t count_ = 0;
};

}  // namespace sarsim::workflow
