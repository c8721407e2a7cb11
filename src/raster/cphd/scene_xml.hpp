#pragma once

#include <pugixml.hpp>

#include "raster/cphd/cphd_description.hpp"

/// Elements that CPHD and CRSD have in common.
namespace sarsim::raster {

/// An element with X, Y and Z.
pugi::xml_node put_xyz(pugi::xml_node parent, const char* name, const core::Vec3& v);
/// An element with X and Y.
pugi::xml_node put_xy(pugi::xml_node parent, const char* name, double x, double y);
/// `true` or `false`.
void put_flag(pugi::xml_node parent, const char* name, bool value);
/// `<Parameter name="NAME">VALUE</Parameter>`
void put_parameter(pugi::xml_node parent, const std::string& name, const std::string& value);
/// A polynomial in two coordinates.
void put_plane(pugi::xml_node parent, const char* name, const AreaPlane& plane);
/// SceneCoordinates with the proposed grid.
/// @param polygon  the image area also as a polygon
void put_scene(pugi::xml_node root, const SceneCoordinates& scene, bool polygon);
/// When the points of the area are seen: the middle, as a polynomial, and how long.
void put_dwell(pugi::xml_node root, const char* name, const AreaPlane& centre_time_s, double dwell_s);
/// X1Y1, X2Y2 and, where wanted, the polygon of an area.
void put_area(pugi::xml_node parent, const AreaRectangle& area, bool polygon);

}  // namespace sarsim::raster
