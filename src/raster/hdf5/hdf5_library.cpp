#include "raster/hdf5/hdf5_library.hpp"

#include <vector>

namespace sarsim::raster {

namespace {

herr_t collect(unsigned, const H5E_error2_t* error, void* data) {
  auto& descriptions = *static_cast<std::vector<std::string>*>(data);
  if (error->desc != nullptr && *error->desc != '\0') descriptions.emplace_back(error->desc);
  return 0;
}

herr_t find_lack(unsigned, const H5E_error2_t* error, void* data) {
  if (error->maj_num == H5E_RESOURCE) *static_cast<bool*>(data) = true;
  return 0;
}

}  // namespace

std::string hdf5_error_text() {
  std::vector<std::string> descriptions;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, collect, &descriptions);
  if (descriptions.empty()) return {};
  if (descriptions.size() == 1) return descriptions.front();
  return descriptions.front() + ": " + descriptions.back();
}

bool hdf5_lacked_memory() {
  bool lacked = false;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, find_lack, &lacked);
  return lacked;
}

}  // namespace sarsim::raster
