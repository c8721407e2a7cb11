#pragma once

#include <cstddef>
#include <string>

#include "core/report/problem.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/range_ambiguities.hpp"
#include "simulate/survey/survey_echoes.hpp"

namespace sarsim::simulate {

/// What pulses other than a row's own do to it: echoes that arrive after the next pulse has left, echoes of other
/// pulses that rows hold or leave out, echoes that arrive while the radar sends. Notes, and warnings where the options
/// have not asked for what is found.
/// @param all    pulses that are heard (`find_range_ambiguities`)
/// @param index  of the simulation
/// @param scope  how much of the recording the survey has seen, for messages; may be empty
void check_range_ambiguities(const Acquisition& acquisition, const RangeAmbiguities& all, const EchoSurvey& survey,
                             std::size_t index, const std::string& scope, core::Problems& problems);

}  // namespace sarsim::simulate
