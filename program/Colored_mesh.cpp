#include "Colored_mesh.h"

#include <algorithm>
#include <cmath>

namespace Program {

Colored_mesh::Colored_mesh(std::size_t number_of_vertices, const std::vector<Polygon>& faces,
                           const std::vector<double>& distortions, double min)
  : m_faces(faces)
  , m_values(number_of_vertices, 0.)
  , m_range{min, min_range * min}
{
  std::vector<int> counts(number_of_vertices, 0);
  for(std::size_t f = 0; f < faces.size(); ++f)
    if(std::isfinite(distortions[f]))
      for(const std::size_t v : faces[f])
      {
        m_values[v] += distortions[f];
        ++counts[v];
      }
  std::vector<double> known;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(counts[v] > 0)
    {
      m_values[v] /= counts[v];
      known.push_back(m_values[v]);
    }
  if(known.empty())
    return;
  const std::size_t rank = static_cast<std::size_t>(quantile * static_cast<double>(known.size() - 1));
  std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(rank), known.end());
  m_range[1] = (std::max)(m_range[1], known[rank]);
}

void Colored_mesh::write(std::ostream& out, const std::vector<Point_3>& points) const
{
  constexpr int digits_of_points = 17, digits_of_values = 6;

  out << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty double x\nproperty double y\nproperty double z"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nelement face "
      << m_faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    const std::array<int, 3> color =
        m_values[v] > 0. ? color_of((m_values[v] - m_range[0]) / (m_range[1] - m_range[0])) : grey;
    out.precision(digits_of_points);
    out << points[v].x() << ' ' << points[v].y() << ' ' << points[v].z() << ' ';
    out.precision(digits_of_values);
    out << color[0] << ' ' << color[1] << ' ' << color[2] << ' ' << m_values[v] << '\n';
  }
  for(const Polygon& t : m_faces)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

std::array<int, 3> Colored_mesh::color_of(double t)
{
  constexpr double first_lightness = 0.3, last_lightness = 0.93;
  constexpr double first_hue = 5.2, last_hue = 1.85;       // in radians
  constexpr double first_chroma = 0.1, last_chroma = 0.16; // all that sRGB holds along this way

  t = (std::min)((std::max)(t, 0.), 1.);
  const double lightness = first_lightness + t * (last_lightness - first_lightness);
  const double hue = first_hue + t * (last_hue - first_hue);
  const double chroma = first_chroma + t * t * t * t * (last_chroma - first_chroma);
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);

  // Oklab to linear sRGB
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const std::array<double, 3> linear = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  std::array<int, 3> rgb{};
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double x = (std::min)((std::max)(linear[i], 0.), 1.);
    const double gamma = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1. / 2.4) - 0.055;
    rgb[i] = static_cast<int>(std::lround(255. * gamma));
  }
  return rgb;
}
} // namespace Program
