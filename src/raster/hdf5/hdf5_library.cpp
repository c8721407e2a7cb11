#include "raster/hdf5/hdf5_library.hpp"

#include <vector>

#include <fmt/format.h>

#include "core/task/stop_points.hpp"

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

core::IsolatedReport hdf5_trial(const std::function<std::string()>& work, const core::StopFlag* stop) {
  core::end_if_asked(stop);
  core::IsolatedReport trial =
      core::run_isolated(work, hdf5_trial_s, &hdf5_lock(), [stop] { return stop != nullptr && stop->requested(); });
  if (trial.result == core::IsolatedResult::stopped) throw core::Interrupted();
  return trial;
}

core::Problem too_much_hdf5_work() {
  return core::error("opening the file is too much work for the HDF5 library")
      .found(fmt::format("more than {} s of processor time", hdf5_trial_s))
      .hint("copy the dataset alone into a new file: h5copy -i OLD -o NEW -s /samples -d /samples");
}

}  // namespace sarsim::raster
