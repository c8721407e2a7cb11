#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture/figure/figure.hpp"

namespace sarsim::workflow {
struct DopplerReport;
struct FocusReport;
struct IsarReport;
struct ProfilesReport;
struct SearchReport;
}  // namespace sarsim::workflow

namespace sarsim::picture {

/// A table of a report, as it is shown and copied.
struct ReportTable {
  std::string title;                           ///< "Targets".
  std::vector<std::string> columns;            ///< With their units: "Range (m)".
  std::vector<std::vector<std::string>> rows;  ///< As many cells each as there are columns.
  bool facts = false;                          ///< Each row is a name, its value and the unit of that.

  friend bool operator==(const ReportTable&, const ReportTable&) = default;
};

/// What came of a request, as tables and figures.
struct ReportPages {
  /// The first, "Result", has facts, with the prefix that suits each value; the others have columns of one unit each.
  std::vector<ReportTable> tables;
  std::vector<Figure> figures;  ///< Each with a title.
};

/// An image: algorithm, axes, Doppler, motion; the phase that autofocus found.
[[nodiscard]] ReportPages pages_of(const workflow::FocusReport& report);

/// Profiles: band, ranges, limits; scans, peaks of the profile that is held against the scene, the scene's targets in
/// it; that profile.
[[nodiscard]] ReportPages pages_of(const workflow::ProfilesReport& report);

/// Images of a turning target: sizes and resolutions, of several images as a table; the scene's targets in them.
[[nodiscard]] ReportPages pages_of(const workflow::IsarReport& report);

/// Range-Doppler maps: axes, detector; the scene's targets and the first detections.
[[nodiscard]] ReportPages pages_of(const workflow::DopplerReport& report);

/// A search picture: grid, detector; the scene's targets and the first detections.
[[nodiscard]] ReportPages pages_of(const workflow::SearchReport& report);

}  // namespace sarsim::picture
