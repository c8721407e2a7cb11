#pragma once

#include "workflow/convert/convert.hpp"

namespace sarsim::workflow {

/// Writes a focused image, as ENVI, NPY or HDF5, as a SICD file (docs/formats/sicd.md). Its script says how it was
/// collected: it is found as `measure` finds it. Throws like `convert`; core::InvalidRequest where the file is no
/// focused image with phases, its script is not there, or nothing says where on the Earth it lies.
[[nodiscard]] ConvertReport convert_to_sicd(const ConvertRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
