#pragma once

#include <string>
#include <vector>

#include "workflow/options/option.hpp"

namespace sarsim::workflow {

/// The words of a line, parted by white space; what stands in single or double quotes belongs together. Throws
/// core::InvalidRequest where a quote is not closed.
[[nodiscard]] std::vector<std::string> words_of_line(const std::string& line);

/// Words as they are typed ("--window hann --pfa=1e-4 --force") by option. Throws core::InvalidRequest with everything
/// that is wrong: unknown options with the nearest one, words that are missing, belong to no option, come twice or are
/// none that their option takes.
[[nodiscard]] GivenWords given_words(const std::vector<Option>& options, const std::vector<std::string>& words);

}  // namespace sarsim::workflow
