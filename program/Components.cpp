#include "Components.h"

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Program {

Components::Components(const std::vector<Polygon>& polygons)
  : m_part_of_face(polygons.size())
{
  std::vector<Side> sides;
  for(std::size_t f = 0; f < polygons.size(); ++f)
    for(std::size_t k = 0; k < polygons[f].size(); ++k)
    {
      const auto [v, w] = std::minmax(polygons[f][k], polygons[f][k + 1 < polygons[f].size() ? k + 1 : 0]);
      sides.push_back({std::uint64_t(v) << 32 | std::uint64_t(w), f});
    }
  boost::sort::spreadsort::integer_sort(
      sides.begin(), sides.end(), [](const Side& s, unsigned int shift) { return s.edge >> shift; },
      [](const Side& s, const Side& t) { return s.edge < t.edge; });
  std::vector<std::size_t> roots(polygons.size());
  std::iota(roots.begin(), roots.end(), std::size_t(0));
  const auto root_of = [&](std::size_t f) {
    while(roots[f] != f)
      f = roots[f] = roots[roots[f]];
    return f;
  };
  for(std::size_t k = 1; k < sides.size(); ++k)
    if(sides[k].edge == sides[k - 1].edge)
    {
      const auto [f, g] = std::minmax({root_of(sides[k].face), root_of(sides[k - 1].face)});
      roots[g] = f; // so that a root is the first of its faces
    }

  std::vector<std::pair<std::size_t, std::size_t>> parts; // size, root
  std::vector<std::size_t> part_of_root(polygons.size());
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    if(roots[f] == f)
    {
      part_of_root[f] = parts.size();
      parts.emplace_back(0, f);
    }
    ++parts[part_of_root[root_of(f)]].first;
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for(std::size_t k = 0; k < parts.size(); ++k)
  {
    m_sizes.push_back(parts[k].first);
    part_of_root[parts[k].second] = k;
  }
  for(std::size_t f = 0; f < polygons.size(); ++f)
    m_part_of_face[f] = part_of_root[root_of(f)];
}

void Components::keep(std::size_t part, std::vector<Polygon>& polygons) const
{
  std::size_t n = 0;
  for(std::size_t f = 0; f < polygons.size(); ++f)
    if(m_part_of_face[f] == part)
    {
      if(n < f)
        polygons[n] = std::move(polygons[f]);
      ++n;
    }
  polygons.resize(n);
}
} // namespace Program
