#pragma once

#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "radar/earth/civil_time.hpp"
#include "radar/orbit/mean_elements.hpp"

namespace sarsim::scene {

/// Mean elements of one satellite at one epoch, as TLE and OMM give them.
struct ElementSet {
  std::string object_name;  ///< Empty where the file has none.
  std::string object_id;    ///< International designator, "1998-067A"; empty where the file has none.
  int catalogue_number = 0;
  radar::CivilTime epoch;  ///< UTC; of TLE from 1957 on.
  radar::MeanElements elements;
  double mean_motion_dot_rev_per_day2 = 0.0;   ///< As the file prints it (a TLE prints half of it); SGP4 ignores it.
  double mean_motion_ddot_rev_per_day3 = 0.0;  ///< As the file prints it (a TLE prints a sixth); SGP4 ignores it.
  int element_set = 0;
  int revolution = 0;  ///< Number of the revolution at the epoch.
};

/// The elements of one satellite: as a rule one set, several where the file is a history.
struct MeanElementsFile {
  std::vector<ElementSet> sets;  ///< In the order of the file; at least one.
};

/// What was read, and what is wrong with it. Where `problems` holds an error, `file` is incomplete.
struct MeanElementsReading {
  MeanElementsFile file;
  core::Problems problems;
};

}  // namespace sarsim::scene
