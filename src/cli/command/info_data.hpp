#pragma once

#include <string>

#include "cli/shell/context.hpp"
#include "workflow/input/sample_input.hpp"

namespace sarsim::cli {

/// What `info` is asked about a file of samples.
struct DataInfoArguments {
  std::string path;
  workflow::SampleArguments sample;
  bool json = false;
};

/// Prints shape, format, axes, attributes and statistics of a file of samples; one pass, bounded memory.
ExitStatus print_data_info(const DataInfoArguments& arguments, Streams& streams);

}  // namespace sarsim::cli
