#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/model/scene.hpp"
#include "workflow/convert/convert.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// Every format of sample files with the word that names it in options.
[[nodiscard]] std::vector<std::pair<std::string, scene::FileFormat>> format_choices();

/// What is said of a file of samples that does not describe itself: --from, --columns, --bits, --lsb, --dataset
/// and --script.
[[nodiscard]] OptionTable<SampleArguments> sample_option_table();

/// How samples are written: --to, --counts, --header and --force.
[[nodiscard]] OptionTable<ConvertRequest> convert_option_table();

}  // namespace sarsim::workflow
