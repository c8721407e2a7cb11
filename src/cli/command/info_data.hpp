#pragma once

#include <string>

#include "cli/shell/context.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::cli {

/// What `info` is asked about a file of samples.
struct DataInfoArguments {
  std::string path;
  workflow::SampleArguments sample;
  bool statistics = false;
  bool json = false;
};

/// Prints shape, format, axes and attributes of a file of samples; with statistics also what its samples are like: one
/// pass, bounded memory.
ExitStatus print_data_info(const DataInfoArguments& arguments, Streams& streams);

}  // namespace sarsim::cli
