#pragma once

#include <filesystem>
#include <string>

namespace sarsim::test {

/// The interpreter of Python for tests: the system's own first, because another one in the search path may lack NumPy
/// and h5py.
inline std::string python() { return std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3"; }

}  // namespace sarsim::test
