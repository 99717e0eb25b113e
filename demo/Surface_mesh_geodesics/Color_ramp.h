#ifndef SURFACE_MESH_GEODESICS_DEMO_COLOR_RAMP_H
#define SURFACE_MESH_GEODESICS_DEMO_COLOR_RAMP_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace geodesics_demo {

using Color = std::array<unsigned char, 3>;

// The color of a distance, from dark violet to light yellow. The lightness increases, so the order is visible without
// distinguishing red from green, and in gray prints. Gray means not reached.
inline Color color_of_distance(double distance, double largest)
{
  static const std::array<std::array<double, 3>, 6> ramp
    = {{{76, 40, 140}, {56, 96, 174}, {30, 138, 160}, {62, 178, 122}, {168, 208, 70}, {252, 232, 92}}};
  if(!std::isfinite(distance))
    return {128, 128, 128};
  const double t = largest > 0 ? (std::min)(5 * distance / largest, 5.) : 0;
  const std::size_t i = (std::min)(static_cast<std::size_t>(t), std::size_t(4));
  const double weight = t - static_cast<double>(i);
  Color color{};
  for(std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<unsigned char>((1 - weight) * ramp[i][k] + weight * ramp[i + 1][k]);
  return color;
}

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_COLOR_RAMP_H
