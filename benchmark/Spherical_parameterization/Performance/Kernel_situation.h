// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_KERNEL_SITUATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_KERNEL_SITUATION_H

#include "../include/mesh_files.h"

#include <CGAL/Spherical_parameterization/Bijective_low_distortion_parameterizer_3.h>
#include <CGAL/Spherical_parameterization/Default_visitor.h>
#include <CGAL/Spherical_parameterization/Determinant_barrier_3.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Newton_update_3.h>
#include <CGAL/Spherical_parameterization/Optimal_radius_3.h>
#include <CGAL/Spherical_parameterization/Parameterization_report.h>
#include <CGAL/Spherical_parameterization/Relative_sharpness_3.h>
#include <CGAL/Spherical_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Spherical_parameterization/internal/Bijectivity_certificate.h>
#include <CGAL/Spherical_parameterization/internal/Block_coordinate_descent.h>
#include <CGAL/Spherical_parameterization/internal/Hierarchical_embedding.h>
#include <CGAL/Spherical_parameterization/internal/Independent_sets.h>
#include <CGAL/Spherical_parameterization/internal/Indexed_mesh.h>
#include <CGAL/Spherical_parameterization/internal/Mesh_hierarchy.h>
#include <CGAL/Spherical_parameterization/internal/Packed_double.h>
#include <CGAL/Spherical_parameterization/internal/Rest_limits.h>
#include <CGAL/Spherical_parameterization/internal/Rest_triangle.h>
#include <CGAL/Spherical_parameterization/internal/Run_control.h>
#include <CGAL/Spherical_parameterization/internal/Star_energy.h>
#include <CGAL/Spherical_parameterization/internal/Star_kernel.h>
#include <CGAL/Spherical_parameterization/internal/Star_packets.h>
#include <CGAL/Spherical_parameterization/internal/Vector_3d.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_removal.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_rings.h>
#include <CGAL/Spherical_parameterization/internal/read_mesh.h>
#include <CGAL/Spherical_parameterization/internal/run_in_lanes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace benchmarks {

namespace SP = CGAL::Spherical_parameterization;

// How much a kernel has done.
struct Work
{
  std::size_t items;  // vertices or faces
  double result = 0.; // depends on all that is computed, so that no compiler leaves it out
};

// A mesh and a map of it that is still some sweeps from its end, as most sweeps of a run find it, and the kernels of the
// default method as calls that do the same work whenever they are made. What the kernels look like inside the package
// is known here and nowhere else among the benchmarks.
class Kernel_situation
{
public:
  // Reads the mesh, and the map if there is a file for it; if there is a name but no file, the map is made and written.
  // \throws std::runtime_error if something cannot be read, written or mapped
  Kernel_situation(const std::filesystem::path& mesh_file, const std::filesystem::path& map_file)
    : m_tmesh(read_mesh(mesh_file))
  {
    SP::Parameterization_report report;
    const SP::Error_code error = SP::internal::read_mesh(m_tmesh, m_tmesh.points(), m_mesh, m_vertices_of_mesh, report);
    if(error != SP::OK)
    {
      throw std::runtime_error(SP::get_error_message(error));
    }
    set_map(std::filesystem::exists(map_file) ? read_map(map_file) : make_map(map_file));
    m_hierarchy.emplace(SP::internal::Mesh_hierarchy::build<CGAL::Sequential_tag>(m_mesh.rings(), m_mesh.points()));
    const SP::internal::Energy_summary summary = descent<CGAL::Sequential_tag>().measure(m_positions, m_radius, 0.);
    m_sharpness = SP::Relative_sharpness_3()(0, summary.average(), summary.largest());
    m_largest_energy = summary.largest();
    take_stars();
    take_holes();
  }
  Kernel_situation(const Kernel_situation&) = delete; // the stars refer to it
  Kernel_situation& operator=(const Kernel_situation&) = delete;

  // From the caller's mesh to flat arrays with numbers of their own.
  Work read() const
  {
    SP::Parameterization_report report;
    SP::internal::Indexed_mesh mesh;
    std::vector<Mesh::Vertex_index> vertices_of_mesh;
    SP::internal::read_mesh(m_tmesh, m_tmesh.points(), mesh, vertices_of_mesh, report);
    return {mesh.number_of_vertices(), mesh.points()[0][0]};
  }

  // The independent sets of the vertices.
  Work color() const
  {
    const SP::internal::Independent_sets sets(m_mesh.rings());
    return {m_mesh.number_of_vertices(), static_cast<double>(sets.number_of_sets())};
  }

  // All that a descent sets up, the independent sets included.
  template <class ConcurrencyTag>
  Work prepare_descent() const
  {
    const Descent<ConcurrencyTag> descent(m_mesh.rings(), m_mesh.points(), m_energy, m_update);
    return {m_mesh.number_of_vertices(), static_cast<double>(descent.faces().size())};
  }

  // Each star is taken anew, with the derivatives of the energies of its faces.
  Work load_stars()
  {
    return for_all_stars([&](const auto& view, auto& star) {
      star.energy.load(view, m_map.data());
      return star.energy.shortest_edge();
    });
  }

  // The energy of each star where the update puts the vertex, or at its centre if it stays.
  Work evaluate_stars()
  {
    return for_all_stars([](const auto&, auto& star) { return star.energy(star.step[0], star.step[1]); });
  }

  // The energy of each star with its gradient and its Hessian.
  Work differentiate_stars()
  {
    return for_all_stars([](const auto&, auto& star) {
      auto gradient = star.step;
      std::array<std::decay_t<decltype(gradient[0])>, 3> hessian;
      return star.energy.derivatives(gradient, hessian) + gradient[0] + hessian[1];
    });
  }

  // The step of each vertex: the star is taken, differentiated, and evaluated as often as it takes.
  Work update_stars()
  {
    return for_all_stars([&](const auto& view, auto& star) {
      take_step(view, star);
      return star.step[0] + star.step[1];
    });
  }

  // Moves all vertices once, so `restore_positions()` has to be called before the next time.
  template <class ConcurrencyTag>
  Work sweep()
  {
    descent<ConcurrencyTag>().sweep(m_positions, m_radius, m_sharpness);
    return {m_positions.size(), m_positions[0][0]};
  }
  void restore_positions() { m_positions = m_map; }

  // The energy of all faces of the map.
  template <class ConcurrencyTag>
  Work measure()
  {
    const SP::internal::Energy_summary summary = descent<ConcurrencyTag>().measure(m_map, m_radius, m_sharpness);
    return {m_mesh.rings().number_of_faces(), summary.mean()};
  }

  // The search for the worst faces of the map, as measure() or the constructor has left them, and their neighbourhood.
  Work find_focus()
  {
    constexpr double share_of_largest = 0.6; // this and the bound on their number as by default
    const std::size_t n = m_mesh.number_of_vertices(), most = n / 5;
    auto& descent = this->descent<CGAL::Sequential_tag>();
    descent.reserve_focus(most);
    return {n, static_cast<double>(descent.focus_on_faces_above(share_of_largest * m_largest_energy, most))};
  }

  // The cost of removing each vertex of the finest level.
  Work cost_removals() const
  {
    using SP::internal::Vertex_removal;

    const std::uint32_t n = static_cast<std::uint32_t>(m_mesh.number_of_vertices());
    double result = 0.;
    for(std::uint32_t v = 0; v < n; ++v)
    {
      result += static_cast<double>(Vertex_removal::best(m_mesh.rings(), m_mesh.points(), v, false).rank());
    }
    return {n, result};
  }

  // All levels down to the tetrahedron.
  template <class ConcurrencyTag>
  Work coarsen() const
  {
    const auto hierarchy = SP::internal::Mesh_hierarchy::build<ConcurrencyTag>(m_mesh.rings(), m_mesh.points());
    return {m_mesh.number_of_vertices(), static_cast<double>(hierarchy.number_of_levels())};
  }

  // A place for each vertex that the finest level adds.
  Work insert()
  {
    double result = 0.;
    SP::internal::Vector_3d point;
    for(const Hole& hole : m_holes)
    {
      m_kernel.find_point(hole, point);
      result += point[0];
    }
    return {m_holes.size(), result};
  }

  // The whole way from the tetrahedron up to the mesh, with the sweeps of the coarser levels. It uses the hierarchy up,
  // so `restore_hierarchy()` has to be called before.
  template <class ConcurrencyTag>
  Work embed()
  {
    constexpr std::size_t sweeps_per_level = 20; // as by default

    SP::Default_visitor visitor;
    SP::Parameterization_report report;
    SP::internal::Run_control<SP::Default_visitor> control(visitor, 0., report);
    SP::internal::Hierarchical_embedding<Energy, SP::Relative_sharpness_3, Update, ConcurrencyTag> embedding(
        *m_hierarchy_in_use, m_mesh.points(), m_energy, SP::Relative_sharpness_3(), m_update, sweeps_per_level,
        SP::internal::Rest_limits());
    std::vector<SP::internal::Vector_3d> positions;
    embedding.run(positions, false, control);
    return {m_mesh.number_of_vertices(), positions[0][0]};
  }

  void restore_hierarchy() { m_hierarchy_in_use.emplace(*m_hierarchy); }

  // The exact check of all faces, and of the degree.
  template <class ConcurrencyTag>
  Work certify() const
  {
    const auto certificate = SP::internal::certify_bijectivity<Kernel, ConcurrencyTag>(m_images, m_triangles);
    return {m_triangles.size(), static_cast<double>(certificate.degree)};
  }

private:
  using Energy = SP::Symmetric_Dirichlet_energy_3;
  using Update = SP::Newton_update_3;
  template <class ConcurrencyTag>
  using Descent = SP::internal::Block_coordinate_descent<Energy, Update, ConcurrencyTag>;

  // As many stars as a number of this type has lanes, and where the update puts their vertices.
  template <class FT>
  struct Star
  {
    SP::internal::Star_energy<Energy, SP::Determinant_barrier_3, FT> energy;
    std::array<FT, 2> step;
  };

  // The ring of a vertex of the finest level, from its target on, as Star_kernel wants it.
  struct Hole
  {
    std::vector<SP::internal::Vector_3d> points;

    std::size_t size() const { return points.size(); }
    const SP::internal::Vector_3d& operator[](std::size_t j) const { return points[j]; }
  };

  static constexpr std::size_t number_of_stars = 128; // so few that they stay in the cache: what they cost, not the way
  static constexpr std::size_t most_faces = 16;       // of a star
  static constexpr unsigned int sweeps_of_map = 10;

  // Images of the vertices of m_tmesh.
  using Images = std::vector<Kernel::Point_3>;

  static Images read_map(const std::filesystem::path& file)
  {
    const Mesh map = benchmarks::read_mesh(file);
    return Images(map.points().begin(), map.points().end());
  }

  Images make_map(const std::filesystem::path& file)
  {
    Mesh map = m_tmesh;
    const Sphere_map sphere = add_sphere_map(map);
    SP::Bijective_low_distortion_parameterizer_3<Mesh> parameterizer;
    const SP::Error_code error =
        parameterizer.parameterize(map, sphere, CGAL::parameters::number_of_iterations(sweeps_of_map));
    if(error != SP::OK)
    {
      throw std::runtime_error(SP::get_error_message(error));
    }
    constexpr int digits = 17;
    if(!file.empty() &&
       !CGAL::IO::write_polygon_mesh(file.string(), m_tmesh,
                                     CGAL::parameters::vertex_point_map(sphere).stream_precision(digits)))
    {
      throw std::runtime_error(file.string() + ": cannot be written");
    }
    return Images(sphere.begin(), sphere.end());
  }

  // Takes the map as positions on the unit sphere. The radius is the best one for the map.
  void set_map(const Images& images)
  {
    if(images.size() != m_tmesh.number_of_vertices())
    {
      throw std::runtime_error("the map is not that of the mesh");
    }
    for(std::size_t v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      const Kernel::Point_3& p = images[m_vertices_of_mesh[m_mesh.original(v)].idx()];
      const SP::internal::Vector_3d u = {p.x(), p.y(), p.z()};
      m_map.push_back(SP::internal::normalized(u));
      m_images.push_back(Kernel::Point_3(m_map[v][0], m_map[v][1], m_map[v][2]));
    }
    const auto triangles = m_mesh.triangles();
    m_triangles.assign(triangles.begin(), triangles.end());
    if(!SP::internal::certify_bijectivity<Kernel>(m_images, m_triangles).is_bijective())
    {
      throw std::runtime_error("the map is not one-to-one");
    }
    restore_positions();
    for(int k = 0; k < 10; ++k)
    {
      descent<CGAL::Sequential_tag>().measure(m_positions, m_radius, 0.);
      m_radius = SP::Optimal_radius_3()(m_energy, descent<CGAL::Sequential_tag>().faces(), m_radius);
    }
  }

  // Made when it is needed first.
  template <class ConcurrencyTag>
  Descent<ConcurrencyTag>& descent()
  {
    auto& descent = std::get<std::optional<Descent<ConcurrencyTag>>>(m_descents);
    if(!descent)
    {
      descent.emplace(m_mesh.rings(), m_mesh.points(), m_energy, m_update);
    }
    return *descent;
  }

  // A star of the mesh, as Star_packets wants it.
  struct Ring_star
  {
    std::uint32_t vertex;
    SP::internal::Vertex_rings::Ring ring;
    const std::vector<SP::internal::Vector_3d>& points;

    std::size_t degree() const { return ring.size(); }
    std::uint32_t neighbor(std::size_t j) const { return ring[j]; }
    SP::internal::Rest_triangle rest(std::size_t j) const
    {
      return SP::internal::Rest_triangle::from_points(
          points[vertex], points[ring[j]], points[ring[j + 1 < ring.size() ? j + 1 : 0]], SP::internal::Rest_limits());
    }
  };

  // A sample from everywhere.
  void take_stars()
  {
    const std::size_t n = m_mesh.number_of_vertices(), count = (std::min)(n, number_of_stars);
    std::vector<std::uint32_t> vertices;
    for(std::size_t k = 0; k < count; ++k)
    {
      const std::size_t v = k * n / count;
      if(m_mesh.rings().degree(v) <= most_faces)
      {
        vertices.push_back(static_cast<std::uint32_t>(v));
      }
    }
    m_number_of_stars = vertices.size();
    m_star_packets.assign(vertices, {0, vertices.size()}, [&](std::uint32_t v) { return m_mesh.rings().degree(v); });
    for(std::size_t packet = 0; packet < m_star_packets.number_of_packets(); ++packet)
    {
      m_star_packets.fill(packet, [&](std::uint32_t v) {
        return Ring_star{v, m_mesh.rings().ring(v), m_mesh.points()};
      });
    }
    for_all_stars([&](const auto& view, auto& star) {
      star.energy.set_objective(m_radius * m_radius, m_sharpness);
      take_step(view, star);
      return star.step[0];
    });
  }

  template <class View, class FT>
  void take_step(const View& view, Star<FT>& star) const
  {
    star.energy.load(view, m_map.data());
    star.step = {FT(0.), FT(0.)};
    m_update(star.energy, star.step);
  }

  // Calls f(view, star) for the stars of the sample, in as many lanes as a sweep uses.
  template <class Function>
  Work for_all_stars(const Function& f)
  {
    using SP::internal::lane;

    double result = 0.;
    SP::internal::run_in_lanes([&](auto number_type) {
      using FT = typename decltype(number_type)::FT;
      constexpr std::size_t width = SP::internal::Lanes<FT>::width;
      std::vector<Star<FT>>& stars = std::get<std::vector<Star<FT>>>(m_stars);
      std::size_t n = 0;
      for(std::size_t k = 0; k < m_star_packets.number_of_packets(); ++k)
      {
        const SP::internal::Star_packets::Packet& packet = m_star_packets.packet(k);
        for(std::size_t first = 0; first < packet.number_of_stars; first += width, ++n)
        {
          if(n == stars.size())
          {
            stars.push_back(
                {SP::internal::Star_energy<Energy, SP::Determinant_barrier_3, FT>(m_energy), {FT(0.), FT(0.)}});
          }
          const auto view = m_star_packets.view<FT>(packet, first);
          result += lane(f(view, stars[n]), 0);
        }
      }
    });
    return {m_number_of_stars, result};
  }

  // Where the sweeps have left no room around the target, there is none for the insertion that was before them either.
  void take_holes()
  {
    const SP::internal::Mesh_hierarchy::Level& finest = m_hierarchy->level(0);
    for(const SP::internal::Mesh_hierarchy::Removed_vertex& removed : finest.removed)
    {
      const SP::internal::Vertex_rings::Ring ring = m_mesh.rings().ring(removed.vertex);
      Hole hole;
      for(std::size_t j = 0; j < ring.size(); ++j)
      {
        hole.points.push_back(m_map[ring[(removed.target + j) % ring.size()]]);
      }
      SP::internal::Vector_3d point;
      if(m_kernel.find_point(hole, point))
      {
        m_holes.push_back(std::move(hole));
      }
    }
  }

  Mesh m_tmesh;
  SP::internal::Indexed_mesh m_mesh;
  std::vector<Mesh::Vertex_index> m_vertices_of_mesh;
  Energy m_energy;
  Update m_update;
  double m_radius = 1., m_sharpness = 0., m_largest_energy = 0.;
  std::vector<SP::internal::Vector_3d> m_map, m_positions; // on the unit sphere; the latter move
  std::tuple<std::optional<Descent<CGAL::Sequential_tag>>
#ifdef CGAL_LINKED_WITH_TBB
             ,
             std::optional<Descent<CGAL::Parallel_tag>>
#endif
             >
      m_descents;
  SP::internal::Star_packets m_star_packets;
  std::size_t m_number_of_stars = 0;
  std::tuple<std::vector<Star<double>>, std::vector<Star<SP::internal::Packed_double<2>>>,
             std::vector<Star<SP::internal::Packed_double<4>>>>
      m_stars; // for one kind of numbers
  std::optional<SP::internal::Mesh_hierarchy> m_hierarchy, m_hierarchy_in_use;
  SP::internal::Star_kernel m_kernel;
  std::vector<Hole> m_holes;
  std::vector<Kernel::Point_3> m_images;
  std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

} // namespace benchmarks

#endif // CGAL_SPHERICAL_PARAMETERIZATION_BENCHMARKS_KERNEL_SITUATION_H
