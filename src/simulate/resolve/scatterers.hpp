#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/task/parallel.hpp"
#include "radar/echo/view_geometry.hpp"
#include "radar/target/reflectivity.hpp"

namespace sarsim::simulate {

/// A point target.
struct Scatterer {
  std::uint32_t platform = 0;
  std::uint32_t gain_curve = 0;  ///< Index into ResolvedScene::gain_curves; ReflectivityLaw::user.
  radar::ReflectivityLaw law = radar::ReflectivityLaw::isotropic;
  bool jittered = false;  ///< Any standard deviation is not 0.
  core::Vec3 position_m;  ///< In the platform's frame.
  core::Vec3 position_stddev_m;
  double rcs_m2 = 1.0;
  double rcs_stddev_m2 = 0.0;
  double azimuth_rad = 0.0;  ///< Of the normal, in the platform's frame.
  double elevation_rad = 0.0;
  double azimuth_stddev_rad = 0.0;
  double elevation_stddev_rad = 0.0;

  friend bool operator==(const Scatterer&, const Scatterer&) = default;
};

/// The points of a cloud, which are alike but for their positions and cross-sections.
struct ScattererCloud {
  Scatterer common;  ///< All but position and cross-section.
  std::shared_ptr<const radar::PointArrays> points;
  core::Vec3 min_m;  ///< Box around the points, in the platform's frame.
  core::Vec3 max_m;
  std::size_t first = 0;  ///< Number of its first point in the list.
};

/// All point targets of a scene by number: targets first, then the points of the clouds. Takes 40 bytes for a target
/// that is isotropic and does not change, and none for the points of a cloud; a `Scatterer` is made when asked for.
class ScattererList {
 public:
  /// Goes through a list from its begin to its end.
  class Iterator {
   public:
    using value_type = Scatterer;
    using difference_type = std::ptrdiff_t;

    Iterator() = default;
    Iterator(const ScattererList* list, std::size_t at) : list_(list), at_(at) {}
    Scatterer operator*() const { return (*list_)[at_]; }
    /// Goes to the next.
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    /// Goes to the next and returns where it was.
    Iterator operator++(int) {
      Iterator before = *this;
      ++at_;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    const ScattererList* list_ = nullptr;
    std::size_t at_ = 0;
  };

  /// Makes room for so many targets, on all threads.
  void reserve(std::size_t targets, const core::WorkControl& control) {
    core::reserve_touched(single_, targets, control);
  }
  /// Adds a target. Comes before all clouds.
  void push_back(const Scatterer& scatterer);
  /// Adds the points of a cloud, which must be there; sets `first`.
  void add_cloud(ScattererCloud cloud);

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Number `index` of all, below `size()`.
  [[nodiscard]] Scatterer operator[](std::size_t index) const;
  [[nodiscard]] Scatterer front() const { return (*this)[0]; }
  [[nodiscard]] Iterator begin() const { return {this, 0}; }
  [[nodiscard]] Iterator end() const { return {this, count_}; }

  /// Number of those that are no points of clouds.
  [[nodiscard]] std::size_t targets() const { return single_.size(); }
  [[nodiscard]] const std::vector<ScattererCloud>& clouds() const { return clouds_; }
  /// The platforms that carry any, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& platforms() const { return platforms_; }
  /// The same list with at most so many points of each cloud, evenly chosen, its first and last among them.
  [[nodiscard]] ScattererList thinned(std::size_t max_points) const;

 private:
  void note_platform(std::uint32_t platform);

  struct Single {
    core::Vec3 position_m;
    double rcs_m2 = 1.0;
    std::uint32_t platform = 0;
    std::uint32_t rest = 0;  // of `rests_`
  };

  std::vector<Single> single_;
  std::vector<Scatterer> rests_{Scatterer{}};  // what targets have besides; each once in a row
  std::vector<ScattererCloud> clouds_;
  std::vector<std::uint32_t> platforms_;
  std::size_t count_ = 0;
};

}  // namespace sarsim::simulate
