// Random locations of sources and queries, and their numbers on the command line.

#ifndef RANDOM_LOCATIONS_H
#define RANDOM_LOCATIONS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <vector>

// Random locations that are the same on every machine. (The distributions of the standard library differ.)
class Random_locations
{
public:
  explicit Random_locations(std::size_t seed) : m_generator(seed) {}

  template <class T>
  const T& element(const std::vector<T>& range)
  {
    return range[m_generator() % range.size()];
  }

  // Barycentric coordinates, each above 1/30, so that a location stays away from the border of its face.
  std::array<double, 3> inner_weights()
  {
    std::array<double, 3> weights = {0.1 + uniform(), 0.1 + uniform(), 0.1 + uniform()};
    const double sum = weights[0] + weights[1] + weights[2];
    weights[0] /= sum;
    weights[1] /= sum;
    weights[2] = 1. - weights[0] - weights[1];
    return weights;
  }

  // Returns a location strictly inside a random face.
  template <class Face_location, class Face>
  Face_location inner_location(const std::vector<Face>& faces)
  {
    const Face f = element(faces);
    const std::array<double, 3> w = inner_weights();
    return Face_location(f, {w[0], w[1], w[2]});
  }

private:
  double uniform() { return std::ldexp(static_cast<double>(m_generator() >> 11), -53); }

  std::mt19937_64 m_generator;
};

// Reads numbers that commas separate. Returns false if there is none, or if one is zero.
inline bool read_numbers(const std::string& text, std::vector<std::size_t>& numbers)
{
  numbers.clear();
  std::istringstream list(text);
  for(std::string item; std::getline(list, item, ',');)
  {
    numbers.push_back(std::strtoul(item.c_str(), nullptr, 10));
  }
  return !numbers.empty() && std::count(numbers.begin(), numbers.end(), std::size_t(0)) == 0;
}

#endif // RANDOM_LOCATIONS_H
