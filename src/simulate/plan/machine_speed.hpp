#pragma once

namespace sarsim::simulate {

/// What a machine takes for the parts of a recording, over what the constants of `estimated_cost` say.
struct MachineSpeed {
  double samples = 1.0;      ///< Rows, conversion and statistics.
  double noise = 1.0;        ///< Random numbers of the receiver.
  double compression = 1.0;  ///< Matched filters.
  double direct = 1.0;       ///< Echoes, by engine, ...
  double spectral = 1.0;
  double reference = 1.0;

  friend bool operator==(const MachineSpeed&, const MachineSpeed&) = default;
};

}  // namespace sarsim::simulate
