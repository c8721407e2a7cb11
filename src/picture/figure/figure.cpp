#include "picture/figure/figure.hpp"

#include <concepts>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace sarsim::picture {

namespace {

// Names the layout that follows; a program of another version refuses it instead of drawing nonsense.
constexpr std::string_view signature = "sarsim figure 1\n";

template <class S, class T>
concept maybe_const = std::same_as<std::remove_const_t<S>, T>;

// What each part consists of, for writing and for reading.
template <class V>
void visit(maybe_const<FigureAxis::Twin> auto& twin, V& visitor) {
  visitor(twin.label), visitor(twin.unit), visitor(twin.factor);
}
template <class V>
void visit(maybe_const<FigureAxis> auto& axis, V& visitor) {
  visitor(axis.label), visitor(axis.unit), visitor(axis.first), visitor(axis.last), visitor(axis.twin);
}
template <class V>
void visit(maybe_const<FigureCurve> auto& curve, V& visitor) {
  visitor(curve.name), visitor(curve.role), visitor(curve.bars), visitor(curve.x), visitor(curve.y);
}
template <class V>
void visit(maybe_const<FigureImage> auto& image, V& visitor) {
  visitor(image.width), visitor(image.height), visitor(image.x_first), visitor(image.x_last);
  visitor(image.y_first), visitor(image.y_last), visitor(image.cells);
}
template <class V>
void visit(maybe_const<FigureColourBar> auto& bar, V& visitor) {
  visitor(bar.label), visitor(bar.unit), visitor(bar.first), visitor(bar.last), visitor(bar.colours);
}
template <class V>
void visit(maybe_const<FigureMark> auto& mark, V& visitor) {
  visitor(mark.x), visitor(mark.y), visitor(mark.text);
}
template <class V>
void visit(maybe_const<FigurePanel> auto& panel, V& visitor) {
  visitor(panel.title), visitor(panel.x), visitor(panel.y), visitor(panel.image), visitor(panel.colour_bar);
  visitor(panel.curves), visitor(panel.marks);
}
template <class V>
void visit(maybe_const<Figure> auto& figure, V& visitor) {
  visitor(figure.title), visitor(figure.note), visitor(figure.panels);
}

template <class T>
constexpr bool plain = std::is_arithmetic_v<T> || std::is_same_v<T, raster::Rgb>;

class Writer {
 public:
  explicit Writer(std::string& bytes) : bytes_(&bytes) {}

  template <class T>
  void operator()(const T& value) {
    if constexpr (plain<T>)
      append(&value, sizeof value);
    else if constexpr (std::is_enum_v<T>)
      (*this)(static_cast<std::uint8_t>(value));
    else
      visit(value, *this);
  }
  void operator()(const std::string& text) { list(text); }
  template <class T>
  void operator()(const std::vector<T>& items) {
    if constexpr (plain<T>) {
      list(items);
    } else {
      (*this)(std::uint64_t{items.size()});
      for (const T& item : items) (*this)(item);
    }
  }
  template <class T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) (*this)(*value);
  }

 private:
  void list(const auto& items) {
    (*this)(std::uint64_t{items.size()});
    append(items.data(), items.size() * sizeof(items[0]));
  }
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_->append(static_cast<const char*>(data), size);
  }

  std::string* bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  template <class T>
  void operator()(T& value) {
    if constexpr (plain<T>)
      take(&value, sizeof value);
    else
      visit(value, *this);
  }
  void operator()(bool& value) {
    const std::uint8_t number = byte();
    if (number > 1) throw std::runtime_error("the figure has a switch that is neither on nor off");
    value = number == 1;
  }
  void operator()(Role& role) {
    const std::uint8_t number = byte();
    if (number >= static_cast<std::uint8_t>(Role::count)) throw std::runtime_error("the figure has an unknown colour");
    role = static_cast<Role>(number);
  }
  void operator()(std::string& text) { list(text); }
  template <class T>
  void operator()(std::vector<T>& items) {
    if constexpr (plain<T>) {
      list(items);
    } else {
      // One by one: a length that only claims ends with the bytes, not with the memory.
      for (std::uint64_t left = length(1); left > 0; --left) (*this)(items.emplace_back());
    }
  }
  template <class T>
  void operator()(std::optional<T>& value) {
    bool there = false;
    (*this)(there);
    if (there) (*this)(value.emplace());
  }

 private:
  std::uint8_t byte() {
    std::uint8_t number = 0;
    take(&number, sizeof number);
    return number;
  }
  void list(auto& items) {
    items.resize(length(sizeof(items[0])));
    take(items.data(), items.size() * sizeof(items[0]));
  }
  // No longer than what is left can hold.
  std::size_t length(std::size_t item_bytes) {
    std::uint64_t number = 0;
    take(&number, sizeof number);
    if (number > rest_.size() / item_bytes) throw std::runtime_error("the figure is cut short");
    return static_cast<std::size_t>(number);
  }
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("the figure is cut short");
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
};

void expect_sound(const Figure& figure) {
  for (const FigurePanel& panel : figure.panels) {
    if (panel.image) {
      const FigureImage& image = *panel.image;
      const bool fits = image.height == 0 ? image.cells.empty()
                                          : image.cells.size() % image.height == 0 &&
                                                image.cells.size() / image.height == image.width;
      if (!fits) throw std::runtime_error("the figure has an image whose cells do not fill it");
    }
    if (panel.colour_bar && panel.colour_bar->colours.size() < 2)
      throw std::runtime_error("the figure has a colour bar without colours");
    for (const FigureCurve& curve : panel.curves)
      if (curve.x.size() != curve.y.size()) throw std::runtime_error("the figure has a curve of unequal lists");
  }
}

}  // namespace

std::string figure_bytes(const Figure& figure) {
  std::string bytes(signature);
  Writer writer(bytes);
  visit(figure, writer);
  return bytes;
}

Figure figure_from(std::string_view bytes) {
  if (!bytes.starts_with(signature)) throw std::runtime_error("these are not the bytes of a figure of this program");
  Reader reader(bytes.substr(signature.size()));
  Figure figure;
  visit(figure, reader);
  if (!reader.at_end()) throw std::runtime_error("the figure has bytes behind its end");
  expect_sound(figure);
  return figure;
}

}  // namespace sarsim::picture
