#include <algorithm>
#include <cstdint>
#include <span>

#include "scene/edit/edit.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

// Cells of the table of distances that are worth computing; beyond, objects are compared place by place.
constexpr std::size_t max_cells = 1'000'000;

// How one list becomes another, by positions in each.
struct ListDifference {
  std::vector<std::pair<std::size_t, std::size_t>> replaced;  // from, to; ascending
  std::vector<std::size_t> removed;                           // ascending
  std::vector<std::size_t> inserted;                          // positions in the new list, ascending
};

template <class Object>
ListDifference place_by_place(std::span<const Object> from, std::span<const Object> to) {
  ListDifference difference;
  const std::size_t shared = std::min(from.size(), to.size());
  for (std::size_t i = 0; i < shared; ++i)
    if (!(from[i] == to[i])) difference.replaced.emplace_back(i, i);
  for (std::size_t i = shared; i < from.size(); ++i) difference.removed.push_back(i);
  for (std::size_t i = shared; i < to.size(); ++i) difference.inserted.push_back(i);
  return difference;
}

std::size_t cost(const ListDifference& difference) {
  return difference.replaced.size() + difference.removed.size() + difference.inserted.size();
}

enum class Way : std::uint8_t { keep, replace, remove, insert };

// The table of distances between the first i objects of one list and the first j of another, as far as it is within a
// band around its diagonals. Only the last row of prices and the best last step to each cell are kept.
template <class Object>
class BandedTable {
 public:
  BandedTable(std::span<const Object> from, std::span<const Object> to, std::size_t band)
      : from_(from),
        to_(to),
        below_(band + (from.size() > to.size() ? from.size() - to.size() : 0)),
        width_(below_ + band + (to.size() > from.size() ? to.size() - from.size() : 0) + 1),
        row_(width_, far),
        ways_((from.size() + 1) * width_, Way::keep) {
    std::vector<std::uint32_t> above(width_, far);
    for (std::size_t i = 0; i <= from_.size(); ++i) {
      std::swap(row_, above);
      for (std::size_t slot = 0; slot < width_; ++slot) fill(i, slot, above);
    }
  }

  // The price of the cheapest path within the band.
  [[nodiscard]] std::size_t price() const { return row_[slot_of(from_.size(), to_.size())]; }

  [[nodiscard]] ListDifference path() const {
    ListDifference difference;
    for (std::size_t i = from_.size(), j = to_.size(); i > 0 || j > 0;) {
      switch (ways_[i * width_ + slot_of(i, j)]) {
        case Way::keep: --i, --j; break;
        case Way::replace: difference.replaced.emplace_back(--i, --j); break;
        case Way::remove: difference.removed.push_back(--i); break;
        case Way::insert: difference.inserted.push_back(--j); break;
      }
    }
    std::ranges::reverse(difference.replaced);
    std::ranges::reverse(difference.removed);
    std::ranges::reverse(difference.inserted);
    return difference;
  }

 private:
  static constexpr auto far = static_cast<std::uint32_t>(-2);

  [[nodiscard]] std::size_t slot_of(std::size_t i, std::size_t j) const { return j + below_ - i; }

  void fill(std::size_t i, std::size_t slot, const std::vector<std::uint32_t>& above) {
    row_[slot] = far;
    if (i + slot < below_ || i + slot - below_ > to_.size()) return;
    const std::size_t j = i + slot - below_;
    std::uint32_t best = i == 0 && j == 0 ? 0 : far;
    Way way = Way::keep;
    const auto try_way = [&](std::uint32_t before, std::uint32_t price, Way by) {
      if (before != far && before + price < best) best = before + price, way = by;
    };
    if (i > 0 && j > 0) {
      const bool equal = from_[i - 1] == to_[j - 1];
      try_way(above[slot], equal ? 0 : 1, equal ? Way::keep : Way::replace);
    }
    if (i > 0 && slot + 1 < width_) try_way(above[slot + 1], 1, Way::remove);
    if (j > 0 && slot > 0) try_way(row_[slot - 1], 1, Way::insert);
    row_[slot] = best;
    ways_[i * width_ + slot] = way;
  }

  std::span<const Object> from_;
  std::span<const Object> to_;
  std::size_t below_;  // how far below the diagonal the band goes
  std::size_t width_;
  std::vector<std::uint32_t> row_;
  std::vector<Way> ways_;
};

template <class Object>
ListDifference list_difference(std::span<const Object> from, std::span<const Object> to) {
  ListDifference plain = place_by_place(from, to);
  const std::size_t length_difference = from.size() > to.size() ? from.size() - to.size() : to.size() - from.size();
  if (cost(plain) <= std::max<std::size_t>(length_difference, 1)) return plain;
  for (std::size_t band = 2;; band *= 2) {
    const std::size_t widest = std::min(band, cost(plain));
    if ((from.size() + 1) * (2 * widest + length_difference + 1) > max_cells) return plain;
    const BandedTable table(from, to, widest);
    // A path that leaves the band removes or inserts more than `widest` objects beyond what the lengths ask for.
    if (table.price() <= widest) return table.path();
    if (widest < band) return plain;
  }
}

template <class Object>
void append_difference(Edit& edit, ObjectKind kind, const std::vector<Object>& from, const std::vector<Object>& to) {
  const auto [from_stop, to_stop] = std::ranges::mismatch(from, to);
  const auto head = static_cast<std::size_t>(from_stop - from.begin());
  const std::size_t max_tail = std::min(from.size(), to.size()) - head;
  std::size_t tail = 0;
  while (tail < max_tail && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
  const ListDifference difference = list_difference(std::span(from).subspan(head, from.size() - head - tail),
                                                    std::span(to).subspan(head, to.size() - head - tail));
  for (const auto& [out, in] : difference.replaced)
    edit.changes.push_back({{kind, head + out}, from[head + out], to[head + in]});
  for (auto out = difference.removed.rbegin(); out != difference.removed.rend(); ++out)
    edit.changes.push_back({{kind, head + *out}, from[head + *out], std::nullopt});
  for (const std::size_t in : difference.inserted)
    edit.changes.push_back({{kind, head + in}, std::nullopt, to[head + in]});
}

}  // namespace

Edit difference(const Scene& from, const Scene& to, std::string label) {
  Edit edit;
  edit.label = std::move(label);
  for (const ObjectKind kind : all_object_kinds)
    visit_list(from, kind, [&](const auto& list) {
      using List = std::remove_cvref_t<decltype(list)>;
      visit_list(to, kind, [&](const auto& other) {
        if constexpr (std::is_same_v<List, std::remove_cvref_t<decltype(other)>>)
          append_difference(edit, kind, list, other);
      });
    });
  if (!(from.options == to.options)) {
    edit.options_before = from.options;
    edit.options_after = to.options;
  }
  if (!(from.world == to.world)) {
    edit.world_before = from.world;
    edit.world_after = to.world;
  }
  if (!(from.atmosphere == to.atmosphere)) {
    edit.air_before = from.atmosphere;
    edit.air_after = to.atmosphere;
  }
  return edit;
}

}  // namespace sarsim::scene
