#ifndef SURFACE_MESH_GEODESICS_MESHES_OF_CELLS_H
#define SURFACE_MESH_GEODESICS_MESHES_OF_CELLS_H

// Meshes drawn with characters: unit squares of the plane, and surfaces of solids made of unit cubes.

#include "Indexed_mesh.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

// Unit squares of the plane: a '#' in row r, column c is the square [c, c+1] x [r, r+1], cut into n x n smaller squares
// of two triangles each.
inline Indexed_mesh plane_cells(const std::string& name, const std::vector<std::string>& rows, std::size_t n = 1)
{
  Indexed_mesh mesh;
  mesh.name = name;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> index_of;
  auto id = [&](std::size_t x, std::size_t y) {
    const auto inserted = index_of.insert({{x, y}, mesh.points.size()});
    if(inserted.second)
    {
      mesh.points.push_back(
        {static_cast<double>(x) / static_cast<double>(n), static_cast<double>(y) / static_cast<double>(n), 0.});
    }
    return inserted.first->second;
  };
  for(std::size_t y = 0; y < rows.size() * n; ++y)
  {
    for(std::size_t x = 0; x < rows[y / n].size() * n; ++x)
    {
      if(rows[y / n][x / n] != '#')
      {
        continue;
      }
      const std::size_t a = id(x, y);
      const std::size_t b = id(x + 1, y);
      const std::size_t c = id(x + 1, y + 1);
      const std::size_t d = id(x, y + 1);
      add_quadrilateral(mesh, a, b, c, d, (x + y) % 2 == 0);
    }
  }
  return mesh;
}

// A solid made of unit cubes: layers[z][y][x] == '#' is a cube. Coordinates outside the layers are empty.
class Solid_of_cubes
{
public:
  using Lattice_point = std::array<int, 3>;

  explicit Solid_of_cubes(const std::vector<std::vector<std::string>>& layers) : m_layers(layers) {}

  bool contains(const Lattice_point& p) const
  {
    if(p[2] < 0 || p[2] >= static_cast<int>(m_layers.size()))
    {
      return false;
    }
    const std::vector<std::string>& layer = m_layers[static_cast<std::size_t>(p[2])];
    if(p[1] < 0 || p[1] >= static_cast<int>(layer.size()))
    {
      return false;
    }
    const std::string& row = layer[static_cast<std::size_t>(p[1])];
    return p[0] >= 0 && p[0] < static_cast<int>(row.size()) && row[static_cast<std::size_t>(p[0])] == '#';
  }

  // Calls visit(cube) for each cube, in the order of the layers, their rows and columns.
  template <class Visit>
  void for_each_cube(const Visit& visit) const
  {
    for(int z = 0; z < static_cast<int>(m_layers.size()); ++z)
    {
      for(int y = 0; y < static_cast<int>(m_layers[static_cast<std::size_t>(z)].size()); ++y)
      {
        const std::string& row = m_layers[static_cast<std::size_t>(z)][static_cast<std::size_t>(y)];
        for(int x = 0; x < static_cast<int>(row.size()); ++x)
        {
          if(contains({x, y, z}))
          {
            visit(Lattice_point{x, y, z});
          }
        }
      }
    }
  }

  // The corners of one side of a cube, counterclockwise as seen from outside.
  static std::array<Lattice_point, 4> corners_of_side(const Lattice_point& cube, std::size_t axis, int side)
  {
    const std::size_t first_axis = (axis + 1) % 3;
    const std::size_t second_axis = (axis + 2) % 3;
    std::array<Lattice_point, 4> corners;
    corners.fill(cube);
    for(Lattice_point& corner : corners)
    {
      corner[axis] += side;
    }
    corners[1][first_axis] += 1;
    corners[2][first_axis] += 1;
    corners[2][second_axis] += 1;
    corners[3][second_axis] += 1;
    if(side == 0)
    {
      std::swap(corners[1], corners[3]);
    }
    return corners;
  }

private:
  const std::vector<std::vector<std::string>>& m_layers;
};

// The surface of a solid made of unit cubes, two triangles per side of a cube.
inline Indexed_mesh voxel_surface(const std::string& name, const std::vector<std::vector<std::string>>& layers)
{
  using Lattice_point = Solid_of_cubes::Lattice_point;
  const Solid_of_cubes solid(layers);
  Indexed_mesh mesh;
  mesh.name = name;
  std::map<Lattice_point, std::size_t> index_of;
  auto id = [&](const Lattice_point& p) {
    const auto inserted = index_of.try_emplace(p, mesh.points.size());
    if(inserted.second)
    {
      mesh.points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    return inserted.first->second;
  };
  solid.for_each_cube([&](const Lattice_point& cube) {
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      for(int side = 0; side < 2; ++side)
      {
        Lattice_point neighbor = cube;
        neighbor[axis] += side == 1 ? 1 : -1;
        if(solid.contains(neighbor))
        {
          continue;
        }
        const std::array<Lattice_point, 4> corners = Solid_of_cubes::corners_of_side(cube, axis, side);
        mesh.faces.push_back({id(corners[0]), id(corners[1]), id(corners[2])});
        mesh.faces.push_back({id(corners[0]), id(corners[2]), id(corners[3])});
      }
    }
  });
  return mesh;
}

inline Indexed_mesh cube()
{
  return voxel_surface("cube", {{"#"}});
}

// The cube [0, n]^3 with n x n cells per side.
inline Indexed_mesh cube_grid(std::size_t n)
{
  return voxel_surface("cube grid", std::vector<std::vector<std::string>>(
                                      n, std::vector<std::string>(n, std::string(n, '#'))));
}

inline Indexed_mesh genus_2_polycube()
{
  return voxel_surface("genus 2 polycube", {{"#####", "#.#.#", "#####"}});
}

inline Indexed_mesh genus_3_polycube()
{
  return voxel_surface("genus 3 polycube", {{"#######", "#.#.#.#", "#######"}});
}

// A cube with three tunnels that intersect, of genus 5. All angles are equal, and most distances tie.
inline Indexed_mesh Menger_sponge()
{
  return voxel_surface("Menger sponge", {{"###", "#.#", "###"}, {"#.#", "...", "#.#"}, {"###", "#.#", "###"}});
}

inline Indexed_mesh strip(std::size_t n)
{
  return plane_cells("strip", {std::string(n, '#')});
}

inline Indexed_mesh spiral_corridor(std::size_t n = 1)
{
  return plane_cells("spiral corridor",
                     {"#########",
                      "........#",
                      "#######.#",
                      "#.....#.#",
                      "#.###.#.#",
                      "#.#...#.#",
                      "#.#####.#",
                      "#.......#",
                      "#########"},
                     n);
}

inline Indexed_mesh square_with_holes(std::size_t n = 1)
{
  return plane_cells("square with holes", {"#######", "#.###.#", "###.###", "#.###.#", "#######"}, n);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_MESHES_OF_CELLS_H
