#include "raster/cphd/scene_xml.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/xml/xml.hpp"

namespace sarsim::raster {

namespace {

using core::append_count;
using core::append_number;
using core::append_text;
using pugi::xml_node;

void put_latitude(xml_node node, const radar::Geodetic& place) {
  append_number(node, "Lat", place.latitude_rad * core::deg_per_rad);
  append_number(node, "Lon", place.longitude_rad * core::deg_per_rad);
}

// The corners of the area, clockwise as seen from above.
std::array<std::array<double, 2>, 4> corners_of(const AreaRectangle& a) {
  return {{{a.x1, a.y1}, {a.x1, a.y2}, {a.x2, a.y2}, {a.x2, a.y1}}};
}

// The grid that is proposed for an image: the area in whole cells about the origin.
void put_grid(xml_node node, const SceneCoordinates& scene) {
  const auto lines = [](double low, double high, double step) {
    return std::pair{std::llround(low / step + 0.5), std::max(std::llround((high - low) / step), 1LL)};
  };
  const auto [first_line, line_count] = lines(scene.area.x1, scene.area.x2, scene.x_step_m);
  const auto [first_sample, sample_count] = lines(scene.area.y1, scene.area.y2, scene.y_step_m);
  xml_node grid = node.append_child("ImageGrid");
  xml_node origin = grid.append_child("IARPLocation");
  append_number(origin, "Line", 0.0);
  append_number(origin, "Sample", 0.0);
  xml_node x = grid.append_child("IAXExtent");
  append_number(x, "LineSpacing", scene.x_step_m);
  append_count(x, "FirstLine", first_line);
  append_count(x, "NumLines", line_count);
  xml_node y = grid.append_child("IAYExtent");
  append_number(y, "SampleSpacing", scene.y_step_m);
  append_count(y, "FirstSample", first_sample);
  append_count(y, "NumSamples", sample_count);
}

}  // namespace

void put_flag(xml_node parent, const char* name, bool value) { append_text(parent, name, value ? "true" : "false"); }

xml_node put_xyz(xml_node parent, const char* name, const core::Vec3& v) {
  xml_node node = parent.append_child(name);
  append_number(node, "X", v.x);
  append_number(node, "Y", v.y);
  append_number(node, "Z", v.z);
  return node;
}

xml_node put_xy(xml_node parent, const char* name, double x, double y) {
  xml_node node = parent.append_child(name);
  append_number(node, "X", x);
  append_number(node, "Y", y);
  return node;
}

void put_parameter(xml_node parent, const std::string& name, const std::string& value) {
  append_text(parent, "Parameter", value).append_attribute("name").set_value(name.c_str());
}

void put_plane(xml_node parent, const char* name, const AreaPlane& plane) {
  const int order = plane.x_slope != 0.0 || plane.y_slope != 0.0 ? 1 : 0;
  xml_node poly = parent.append_child(name);
  poly.append_attribute("order1").set_value(order);
  poly.append_attribute("order2").set_value(order);
  const auto put = [&](int e1, int e2, double value) {
    xml_node coefficient = append_number(poly, "Coef", value);
    coefficient.append_attribute("exponent1").set_value(e1);
    coefficient.append_attribute("exponent2").set_value(e2);
  };
  put(0, 0, plane.constant);
  if (order == 0) return;
  put(1, 0, plane.x_slope);
  put(0, 1, plane.y_slope);
}

void put_area(xml_node parent, const AreaRectangle& area, bool polygon) {
  xml_node node = parent.append_child("ImageArea");
  put_xy(node, "X1Y1", area.x1, area.y1);
  put_xy(node, "X2Y2", area.x2, area.y2);
  if (!polygon) return;
  xml_node vertices = node.append_child("Polygon");
  vertices.append_attribute("size").set_value(4);
  int number = 0;
  for (const auto& [x, y] : corners_of(area))
    put_xy(vertices, "Vertex", x, y).append_attribute("index").set_value(++number);
}

void put_scene(xml_node root, const SceneCoordinates& scene, bool polygon) {
  xml_node node = root.append_child("SceneCoordinates");
  append_text(node, "EarthModel", "WGS_84");
  xml_node origin = node.append_child("IARP");
  put_xyz(origin, "ECF", scene.origin_m);
  const radar::Geodetic place = radar::geodetic_of(scene.origin_m);
  xml_node llh = origin.append_child("LLH");
  put_latitude(llh, place);
  append_number(llh, "HAE", place.height_m);
  xml_node plane = node.append_child("ReferenceSurface").append_child("Planar");
  put_xyz(plane, "uIAX", scene.x_axis);
  put_xyz(plane, "uIAY", scene.y_axis);
  put_area(node, scene.area, polygon);
  xml_node corners = node.append_child("ImageAreaCornerPoints");
  int number = 0;
  for (const auto& [x, y] : corners_of(scene.area)) {
    xml_node corner = corners.append_child("IACP");
    corner.append_attribute("index").set_value(++number);
    put_latitude(corner, radar::geodetic_of(scene.origin_m + x * scene.x_axis + y * scene.y_axis));
  }
  if (scene.x_step_m > 0.0 && scene.y_step_m > 0.0) put_grid(node, scene);
}

void put_dwell(xml_node root, const char* name, const AreaPlane& centre_time_s, double dwell_s) {
  xml_node node = root.append_child(name);
  append_count(node, "NumCODTimes", 1);
  xml_node centre = node.append_child("CODTime");
  append_text(centre, "Identifier", "COD");
  put_plane(centre, "CODTimePoly", centre_time_s);
  append_count(node, "NumDwellTimes", 1);
  xml_node dwell = node.append_child("DwellTime");
  append_text(dwell, "Identifier", "Dwell");
  put_plane(dwell, "DwellTimePoly", {dwell_s, 0.0, 0.0});
}

}  // namespace sarsim::raster
