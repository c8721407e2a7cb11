#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "core/maths/sampled_function.hpp"

namespace sarsim::scene {

/// N functions of one variable that are defined together, in the script or in a data file.
template <std::size_t N>
struct UserFunction {
  std::array<core::SampledFunction, N> part;
  std::string file;  ///< Name of the data file as the script gives it; empty: INLINE.

  friend bool operator==(const UserFunction&, const UserFunction&) = default;
};

/// What a file says, made ready; null until it is read. It is no part of what a scene says: any are equal.
template <class Contents>
struct FileContents : std::shared_ptr<const Contents> {
  using std::shared_ptr<const Contents>::shared_ptr;
  FileContents() = default;
  FileContents(std::shared_ptr<const Contents> contents) : std::shared_ptr<const Contents>(std::move(contents)) {}

  friend bool operator==(const FileContents&, const FileContents&) { return true; }
};

}  // namespace sarsim::scene
