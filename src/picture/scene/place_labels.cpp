#include "picture/scene/place_labels.hpp"

#include <algorithm>
#include <array>

namespace sarsim::picture {

namespace {

// Of the usual font at 13 px: words that are a little longer than estimated touch, and no more.
constexpr float name_letter_px = 7.0F;
constexpr float name_line_px = 13.0F;
constexpr float above_px = 10.0F;  // of a letter above its base line
constexpr float below_px = 2.0F;
constexpr float rim_px = 5.0F;           // that stays free: words that are longer than estimated would be cut there
constexpr std::size_t max_placed = 500;  // beyond it nobody reads them, and each is compared with all
constexpr std::array<float, 7> lines{0.0F, 1.0F, -1.0F, 2.0F, -2.0F, 3.0F, -3.0F};

struct LabelBox {
  float left, right, top, bottom;

  [[nodiscard]] bool meets(const LabelBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  [[nodiscard]] bool holds(const LabelBox& other) const {
    return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
  }
};

// Bytes that go on with a letter are none of their own.
float letters_of(const std::string& text) {
  return static_cast<float>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

LabelBox box_of(const Drawing::Text& text, float scale) {
  const float width = letters_of(text.text) * name_letter_px * scale;
  const float left = text.x - (text.centred ? 0.5F * width : 0.0F);
  return {left, left + width, text.y - above_px * scale, text.y + below_px * scale};
}

bool is_free(const LabelBox& box, const std::vector<LabelBox>& taken) {
  return std::ranges::none_of(taken, [&](const LabelBox& other) { return box.meets(other); });
}

// Up or down to where it is free.
void move_to_room(Drawing::Text& text, const std::vector<LabelBox>& taken, float scale) {
  const float y = text.y;
  for (const float line : lines) {
    text.y = y + line * name_line_px * scale;
    if (is_free(box_of(text, scale), taken)) return;
  }
  text.y = y;
}

}  // namespace

void place_labels(std::vector<Drawing::Text>& texts, const Camera& camera, double pixel_scale) {
  if (texts.size() > max_placed) return;
  const auto scale = static_cast<float>(pixel_scale);
  const float rim = rim_px * scale;
  const LabelBox picture{rim, static_cast<float>(camera.width_px) - rim, 0.0F, static_cast<float>(camera.height_px)};
  std::vector<LabelBox> taken;
  for (const Drawing::Text& text : texts)
    if (text.hold == Drawing::Hold::fixed) taken.push_back(box_of(text, scale));
  for (Drawing::Text& text : texts) {
    if (text.hold != Drawing::Hold::movable) continue;
    move_to_room(text, taken, scale);
    taken.push_back(box_of(text, scale));
  }
  std::erase_if(texts, [&](const Drawing::Text& text) {
    if (text.hold != Drawing::Hold::spare) return false;
    const LabelBox box = box_of(text, scale);
    if (!is_free(box, taken) || !picture.holds(box)) return true;
    taken.push_back(box);
    return false;
  });
}

}  // namespace sarsim::picture
