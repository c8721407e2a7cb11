#pragma once

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

/// Numbers out of the reports that commands write as JSON.
namespace sarsim::test {

/// Folder of the example scripts.
inline const std::string examples = SARSIM_SOURCE_DIR "/examples/";

/// All numbers that follow a name in JSON, in their order.
inline std::vector<double> numbers_of(const std::string& json, const std::string& name) {
  std::vector<double> numbers;
  const std::regex pattern("\"" + name + "\": (-?[0-9.eE+-]+)");
  for (std::sregex_iterator i(json.begin(), json.end(), pattern), end; i != end; ++i)
    numbers.push_back(std::stod((*i)[1]));
  return numbers;
}

/// The largest magnitude of some numbers; 0 where there are none.
inline double largest(const std::vector<double>& numbers) {
  double most = 0.0;
  for (const double number : numbers) most = std::max(most, std::abs(number));
  return most;
}

}  // namespace sarsim::test
