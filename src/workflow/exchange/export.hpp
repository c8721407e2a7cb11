#pragma once

#include <filesystem>
#include <optional>

#include "core/task/observer.hpp"
#include "workflow/exchange/collection.hpp"

namespace sarsim::workflow {

/// Which recording becomes which file of the standards CPHD and CRSD.
struct ExportRequest {
  RecordingArguments input;
  std::filesystem::path output;                    ///< Its extension says which: .cphd or .crsd.
  std::optional<raster::SignalEncoding> encoding;  ///< Floats where nothing is said.
  std::optional<ReferencePoint> reference;         ///< The middle of the scene where nothing is said.
  std::optional<radar::Anchor> anchor;
  unsigned threads = 0;  ///< 0: one per core.
  bool force = false;    ///< Replace the output where it exists.
};

/// What was made.
struct ExportReport {
  std::size_t vectors = 0;
  std::size_t samples = 0;  ///< Of a vector.
};

/// Whether a name is that of a file that `export_recording` writes.
[[nodiscard]] bool is_exchange_file(const std::filesystem::path& path);

/// Writes a scene or a recording as CPHD (docs/formats/cphd.md) or CRSD (docs/formats/crsd.md). Vectors are computed on
/// all threads and written in order: the bytes do not depend on their number, and memory does not grow with the
/// recording.
/// @throws core::InvalidRequest with all problems; core::Interrupted when stopped, and nothing is left behind
ExportReport export_recording(const ExportRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
