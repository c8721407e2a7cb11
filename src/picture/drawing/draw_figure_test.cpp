#include <cairo.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/report/expect.hpp"
#include "picture/figure/picture_file.hpp"
#include "support/processor_time.hpp"

namespace sarsim::picture {
namespace draw_figure_test {

constexpr PictureStyle small{.width_px = 400, .height_px = 300};
constexpr raster::Rgb red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, grey{90, 90, 90};

// A PNG as dots.
class Dots {
 public:
  explicit Dots(const std::string& png) : rest_(png) {
    surface_.reset(cairo_image_surface_create_from_png_stream(read, &rest_));
    if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS) throw std::runtime_error("not a PNG");
  }
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }
  [[nodiscard]] raster::Rgb at(int x, int y) const {
    const unsigned char* const line =
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get());
    return {line[4 * x + 2], line[4 * x + 1], line[4 * x]};
  }
  // Columns and rows between the first and the last dot of a colour.
  struct Box {
    int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1, dots = 0;
  };
  [[nodiscard]] Box box_of(const raster::Rgb& colour) const {
    return box_of([&](const raster::Rgb& dot) { return dot == colour; });
  }
  // Of dots that are no grey, as ground, words and axes are.
  [[nodiscard]] Box box_of_colours() const {
    return box_of([](const raster::Rgb& dot) {
      constexpr int least = 60;
      return std::max({dot.red, dot.green, dot.blue}) - std::min({dot.red, dot.green, dot.blue}) > least;
    });
  }
  // Of dots that are more of a colour than of the ground, as those of thin lines are.
  [[nodiscard]] Box box_near(const raster::Rgb& colour) const {
    const auto apart = [](const raster::Rgb& a, const raster::Rgb& b) {
      return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
    };
    const int most = 2 * apart(at(0, 0), colour) / 5;
    return box_of([&](const raster::Rgb& dot) { return apart(dot, colour) < most; });
  }

 private:
  [[nodiscard]] Box box_of(const auto& fits) const {
    Box box;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x) {
        if (!fits(at(x, y))) continue;
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y),
               box.dots + 1};
      }
    return box;
  }

  struct Closer {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  static cairo_status_t read(void* from, unsigned char* data, unsigned int length) {
    auto& rest = *static_cast<std::string_view*>(from);
    if (length > rest.size()) return CAIRO_STATUS_READ_ERROR;
    std::copy_n(rest.data(), length, data);
    rest.remove_prefix(length);
    return CAIRO_STATUS_SUCCESS;
  }
  std::string_view rest_;
  std::unique_ptr<cairo_surface_t, Closer> surface_;
};

Dots drawn(const Figure& figure, const PictureStyle& style = small) {
  static std::string bytes;
  bytes = draw_picture(figure, PictureKind::png, style);
  return Dots(bytes);
}

// Two by two cells: red and green below, blue and grey above.
Figure four_cells() {
  FigurePanel panel;
  panel.x = {"Across", "m", 0.0, 100.0, {}};
  panel.y = {"Up", "m", 0.0, 50.0, {}};
  panel.image = FigureImage{2, 2, 0.0, 100.0, 0.0, 50.0, {red, green, blue, grey}};
  return {"A title", "a note", {panel}};
}

Figure one_curve(std::vector<double> x, std::vector<double> y) {
  FigurePanel panel;
  panel.x = {"Time", "s", 0.0, 1.0, {}};
  panel.y = {"Level", "V", 0.0, 1.0, {}};
  panel.curves.push_back({"", Role::curve, false, std::move(x), std::move(y)});
  return {"", "", {panel}};
}

TEST(DrawPicture, HasTheSizeScaleAndGroundThatAreAsked) {
  const Dots light = drawn(four_cells());
  EXPECT_EQ(light.width(), 400);
  EXPECT_EQ(light.height(), 300);
  EXPECT_EQ(light.at(0, 0), colour(Role::background, false));
  const Dots dark = drawn(four_cells(), {.width_px = 400, .height_px = 300, .scale = 2.5, .dark = true});
  EXPECT_EQ(dark.width(), 1000);
  EXPECT_EQ(dark.height(), 750);
  EXPECT_EQ(dark.at(0, 0), colour(Role::background, true));
}

// More cells than dots, of which every hundredth row has a point.
TEST(DrawPicture, LosesNoPointOfAnImageOfMoreCellsThanDots) {
  constexpr std::size_t side = 1000;
  constexpr std::size_t points = 10;
  Figure figure = four_cells();
  FigurePanel& panel = figure.panels.front();
  panel.image = FigureImage{side, side, 0.0, 100.0, 0.0, 50.0, std::vector<raster::Rgb>(side * side, blue)};
  panel.colour_bar = FigureColourBar{"Level", "dB", -40.0, 0.0, {blue, red}};
  for (const double scale : {1.0, 1.5, 2.0})
    for (std::size_t shift = 20; shift < 60; ++shift) {
      panel.image->cells.assign(side * side, blue);
      for (std::size_t k = 0; k < points; ++k) panel.image->cells[(k * 100 + shift) * side + k * 50 + 2 * shift] = red;
      const Dots dots = drawn(figure, {.width_px = 400, .height_px = 300, .scale = scale});
      std::size_t seen = 0;
      bool above = false;
      for (int y = 0; y < dots.height(); ++y) {
        bool here = false;
        for (int x = 0; x < dots.width() * 3 / 4; ++x) here = here || dots.at(x, y) == red;
        if (here && !above) ++seen;
        above = here;
      }
      ASSERT_EQ(seen, points) << scale << " " << shift;
    }
}

TEST(DrawPicture, PutsCellsWhereTheirAxesSayInTheirOwnColours) {
  const Dots dots = drawn(four_cells());
  const Dots::Box lower_left = dots.box_of(red), lower_right = dots.box_of(green), upper_left = dots.box_of(blue),
                  upper_right = dots.box_of(grey);
  for (const Dots::Box& box : {lower_left, lower_right, upper_left, upper_right}) EXPECT_GT(box.dots, 1000);
  EXPECT_LT(lower_left.right, lower_right.left);
  EXPECT_LT(upper_left.bottom, lower_left.top);
  EXPECT_LT(upper_left.right, upper_right.left);
  EXPECT_LE(lower_right.left - lower_left.right, 2);  // no dot between them is of neither
  EXPECT_LE(lower_left.top - upper_left.bottom, 2);
}

TEST(DrawPicture, TurnsAnAxisThatIsSeenFromItsEnd) {
  Figure figure = four_cells();
  std::swap(figure.panels[0].x.first, figure.panels[0].x.last);
  const Dots dots = drawn(figure);
  EXPECT_GT(dots.box_of(red).left, dots.box_of(green).right);
}

// A metre is as long up as across, so 100 m x 50 m is twice as wide as high; a strip fills its axes.
TEST(DrawPicture, KeepsTheScaleOfImagesInMetresUnlessTheyAreStrips) {
  const auto shape = [](const Figure& figure) {
    const Dots dots = drawn(figure);
    const Dots::Box left = dots.box_of(red), right = dots.box_of(grey);
    return static_cast<double>(right.right - left.left) / static_cast<double>(left.bottom - right.top);
  };
  Figure figure = four_cells();
  EXPECT_NEAR(shape(figure), 2.0, 0.03);
  figure.panels[0].y.last = figure.panels[0].image->y_last = 100.0;
  EXPECT_NEAR(shape(figure), 1.0, 0.02);
  figure.panels[0].y.unit = "s";
  EXPECT_GT(shape(figure), 1.2);
  figure.panels[0].y.unit = "m";
  figure.panels[0].y.last = figure.panels[0].image->y_last = 10.0;
  EXPECT_LT(shape(figure), 2.0);
}

TEST(DrawPicture, DrawsACurveFromPlaceToPlaceAndBreaksItAtNaN) {
  const Dots whole = drawn(one_curve({0.0, 1.0}, {0.5, 0.5}));
  const Dots::Box line = whole.box_of_colours();
  EXPECT_GT(line.right - line.left, 300);
  EXPECT_LE(line.bottom - line.top, 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Dots broken = drawn(one_curve({0.0, 0.25, 0.5, 0.75, 1.0}, {0.5, 0.5, nan, 0.5, 0.5}));
  EXPECT_NEAR(broken.box_of_colours().dots, whole.box_of_colours().dots / 2, 12);
}

TEST(DrawPicture, CutsWhatIsFarOutsideWithoutBendingIt) {
  // Through the middle of the panel, and 1e12 panels on.
  const Dots::Box steep = drawn(one_curve({-1e12, 1e12 + 1.0}, {-1e12, 1e12 + 1.0})).box_of_colours();
  const Dots::Box plain = drawn(one_curve({0.0, 1.0}, {0.0, 1.0})).box_of_colours();
  EXPECT_NEAR(steep.left, plain.left, 4);
  EXPECT_NEAR(steep.right, plain.right, 4);
  EXPECT_NEAR(steep.dots, plain.dots, 60);
  EXPECT_EQ(drawn(one_curve({0.0, 1.0}, {2e9, 3e9})).box_of_colours().dots, 0);
}

TEST(DrawPicture, DrawsManyPointsAsItDrawsFew) {
  std::vector<double> x, y;
  for (int i = 0; i <= 200'000; ++i) {
    x.push_back(i / 200'000.0);
    y.push_back(0.5);
  }
  const Dots::Box many = drawn(one_curve(x, y)).box_of_colours();
  const Dots::Box few = drawn(one_curve({0.0, 1.0}, {0.5, 0.5})).box_of_colours();
  EXPECT_EQ(many.right, few.right);
  EXPECT_EQ(many.dots, few.dots);
}

// A long chirp fills its panel; all of its points took minutes.
TEST(DrawPicture, DrawsACurveThatGoesUpAndDownManyTimesInEachPixel) {
  std::vector<double> x, y;
  for (int i = 0; i <= 131'072; ++i) {
    x.push_back(i / 131'072.0);
    y.push_back(0.5 + 0.5 * std::sin(2e-3 * i * i));
  }
  const sarsim::test::ProcessorTime time;
  const Dots::Box box = drawn(one_curve(x, y)).box_of_colours();
  EXPECT_LT(time.seconds(), 5.0);
  EXPECT_GT(box.dots, 9 * (box.right - box.left) * (box.bottom - box.top) / 10);
}

TEST(DrawPicture, DrawsBarsMarksLegendTwinsAndColourBars) {
  Figure figure = one_curve({0.2, 0.4, 0.6}, {0.5, 0.9, 0.3});
  FigurePanel& panel = figure.panels[0];
  panel.curves[0].bars = true;
  panel.curves.push_back({"named", Role::curve_2, false, {0.0, 1.0}, {0.1, 0.2}});
  panel.marks.push_back({0.5, 0.5, "here"});
  panel.x.twin = {"Delay", "s", 2.0};
  panel.y.twin = {"Speed", "m/s", 3.0};
  panel.colour_bar = FigureColourBar{"Level", "dB", -40.0, 0.0, {red, blue}};
  figure.panels.push_back(panel);
  const Dots dots = drawn(figure, {.width_px = 600, .height_px = 600});
  EXPECT_GT(dots.box_near(colour(Role::curve, false)).dots, 20);
  EXPECT_GT(dots.box_near(colour(Role::curve_2, false)).dots, 20);
  EXPECT_GT(dots.box_near(colour(Role::error, false)).dots, 10);
  // The bar ends in its colours, blue above red, to the right of the panel.
  bool reds = false, blues = false;
  for (int y = 0; y < dots.height(); ++y)
    for (int x = 400; x < dots.width(); ++x) {
      const raster::Rgb c = dots.at(x, y);
      reds = reds || (c.red > 240 && c.blue < 15 && c.green < 15);
      blues = blues || (c.blue > 240 && c.red < 15 && c.green < 15);
    }
  EXPECT_TRUE(reds);
  EXPECT_TRUE(blues);
}

TEST(DrawPicture, LeavesPanelsTheirRoomWhateverTheTitle) {
  Figure figure = four_cells();
  const int plain = drawn(figure).box_of(red).dots;
  for (const std::string& title :
       {std::string(3000, 'x'), std::string("a \xff\xfe broken\nname \x01"), std::string()}) {
    figure.title = title;
    EXPECT_GT(drawn(figure).box_of(red).dots, plain / 2) << title.substr(0, 20);
  }
}

TEST(DrawPicture, SurvivesFiguresWithNothingInThem) {
  Figure figure;
  for (const PictureKind kind : {PictureKind::png, PictureKind::svg, PictureKind::pdf})
    EXPECT_FALSE(draw_picture(figure, kind, small).empty());
  figure = one_curve({}, {});
  figure.panels[0].x = {"", "", 1.0, 1.0, {}};
  figure.panels[0].y = {"", "", std::numeric_limits<double>::infinity(), 0.0, {}};
  figure.panels[0].image.emplace();
  for (const PictureStyle& style : {small, PictureStyle{.width_px = 1, .height_px = 1}})
    EXPECT_FALSE(draw_picture(figure, PictureKind::png, style).empty());
}

TEST(DrawPicture, GivesTheSameBytesForTheSameFigure) {
  for (const PictureKind kind : {PictureKind::png, PictureKind::pdf})
    EXPECT_TRUE(draw_picture(four_cells(), kind, small) == draw_picture(four_cells(), kind, small));
  EXPECT_THAT(draw_picture(four_cells(), PictureKind::svg, small), testing::HasSubstr("<svg"));
  const std::string pdf = draw_picture(four_cells(), PictureKind::pdf, small);
  EXPECT_THAT(pdf, testing::StartsWith("%PDF"));
  EXPECT_THAT(pdf, testing::Not(testing::HasSubstr("CreationDate")));
}

TEST(DrawPicture, IsLeftWhereAStopIsRequested) {
  core::StopFlag stop;
  stop.request();
  for (const PictureKind kind : {PictureKind::png, PictureKind::svg, PictureKind::pdf}) {
    EXPECT_THROW((void)draw_picture(four_cells(), kind, small, &stop), core::Interrupted);
    EXPECT_THROW((void)draw_sheet({}, kind, small, &stop), core::Interrupted);
  }
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "stopped_picture_test.png";
  EXPECT_THROW(write_picture(four_cells(), path, small, &stop), core::Interrupted);
  EXPECT_FALSE(std::filesystem::exists(path));
}

// The stop comes when all is drawn, while the library packs a picture of 144 million dots: seconds of work.
TEST(DrawPicture, IsLeftWhileItIsPacked) {
  core::StopFlag stop;
  const PictureStyle large{12000, 12000};
  std::thread later([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    stop.request();
  });
  const sarsim::test::ProcessorTime time;
  EXPECT_THROW((void)draw_picture(four_cells(), PictureKind::png, large, &stop), core::Interrupted);
  later.join();
  EXPECT_LT(time.seconds(), 3.0);
}

TEST(WritePicture, KnowsKindsByTheEndingOfTheName) {
  EXPECT_EQ(picture_kind_of("a/b.PNG"), PictureKind::png);
  EXPECT_EQ(picture_kind_of("b.svg"), PictureKind::svg);
  EXPECT_EQ(picture_kind_of("b.pdf"), PictureKind::pdf);
  for (const char* name : {"b", "b.jpg", "png", ".png"}) EXPECT_EQ(picture_kind_of(name), std::nullopt) << name;
}

TEST(WritePicture, LeavesWhatStoodThereWhereItCannotBeWritten) {
  EXPECT_THROW(write_picture(four_cells(), "/no/such/folder/a.png", small), std::system_error);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "write_picture_test.png";
  write_picture(four_cells(), path, small);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(bytes, draw_picture(four_cells(), PictureKind::png, small));
  std::filesystem::remove(path);
}

}  // namespace draw_figure_test
}  // namespace sarsim::picture
