#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raster/table/sink.hpp"
#include "workflow/sweep/post_processing.hpp"

namespace sarsim::workflow {

/// What a variation's product turned out to be: a line of the table of a sweep.
struct SweepRow {
  std::size_t variation = 0;
  std::size_t product = 0;  ///< Among the chosen products.
  bool table = false;       ///< A geometry table; then `run` says nothing.
  bool done = false;
  std::string failure;      ///< Why not, where it was tried.
  std::string file;         ///< In the folder of the sweep; the name that it would have where nothing is written.
  std::uint64_t stamp = 0;  ///< Of everything that its content depends on.
  double bytes = 0.0;       ///< Of its file; where it was discarded, of tables alone.
  std::optional<std::int64_t> written;  ///< When its file was, `modification_time`; none where it was discarded.
  double seconds = 0.0;
  std::string engine;
  bool lsb_estimated = false;
  raster::RunReport run;
  bool begun = false;                ///< An earlier process began its file: an existing file may be its result.
  bool recorded = false;             ///< Its file is there already; only the follow-up is left to do.
  std::string followed;              ///< Which follow-up gave the figures, `mark_of`; empty: none yet.
  std::vector<SweepFigure> figures;  ///< Of what was made of the recording.
};

}  // namespace sarsim::workflow
