/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphericalParameterizationVisitor` describes what is told of the progress of a run and may stop it: of
`CGAL::Spherical_parameterization::parameterize()`, `CGAL::Spherical_parameterization::map_surface()` or
`CGAL::Spherical_parameterization::align_spheres()`.

All functions are called from the thread that called that function. An exception of one of them leaves the output map as it was. Each
parameterizer calls what applies to it, and `on_level()` only if it starts from the levels of
`CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`:

| Parameterizer or function | `on_initialization_begin()` <br> `on_initialization_end()` | `on_level()` | `after_iteration()` | `go_further()` | `on_optimization_end()` |
| :------------ | :----: | :----: | :----: | :----: | :----: |
| \link CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3 `%Bijective_low_distortion_parameterizer_3` \endlink | yes | from a hierarchy | yes | yes | yes |
| \link CGAL::Spherical_parameterization::Published_low_distortion_parameterizer_3 `%Published_low_distortion_parameterizer_3` \endlink | yes | from a hierarchy | yes | yes | yes |
| \link CGAL::Spherical_parameterization::Hierarchical_parameterizer_3 `%Hierarchical_parameterizer_3` \endlink | yes | yes | - | yes | - |
| \link CGAL::Spherical_parameterization::Stereographic_parameterizer_3 `%Stereographic_parameterizer_3` \endlink | yes | - | - | - | - |
| \link CGAL::Spherical_parameterization::Schnyder_parameterizer_3 `%Schnyder_parameterizer_3` \endlink | yes | - | - | - | - |
| \link CGAL::Spherical_parameterization::Harmonic_parameterizer_3 `%Harmonic_parameterizer_3` \endlink | yes | - | yes | yes | yes |
| \link CGAL::Spherical_parameterization::Target_area_parameterizer_3 `%Target_area_parameterizer_3` \endlink | yes | yes | yes | yes | yes |
| \link CGAL::Spherical_parameterization::Conformal_parameterizer_3 `%Conformal_parameterizer_3` \endlink | yes | - | yes | yes | yes |
| \link CGAL::Spherical_parameterization::ARAP_parameterizer_3 `%ARAP_parameterizer_3` \endlink | yes | from a hierarchy | yes | yes | yes |
| \link CGAL::Spherical_parameterization::Precomputed_parameterizer_3 `%Precomputed_parameterizer_3` \endlink | - | - | - | - | - |
| \link CGAL::Spherical_parameterization::map_surface() `map_surface()` \endlink | yes | yes | - | yes | yes |
| \link CGAL::Spherical_parameterization::align_spheres() `align_spheres()` \endlink | - | - | - | yes | - |
| \link CGAL::Spherical_parameterization::overlay() `overlay()` \endlink | - | - | - | yes | - |
| \link CGAL::Spherical_parameterization::measure_distance() `measure_distance()` \endlink | - | - | - | yes | - |
| \link CGAL::Spherical_parameterization::transfer() `transfer()` \endlink, \link CGAL::Spherical_parameterization::remesh_through_sphere() `remesh_through_sphere()` \endlink | - | - | - | yes | - |

`CGAL::Spherical_parameterization::map_surface()` lowers the energy on levels of the first surface, of which there are none if the
surfaces agree as they are.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::parameterize()`
\sa `CGAL::Spherical_parameterization::map_surface()`
\sa `CGAL::Spherical_parameterization::align_spheres()`
*/
class SphericalParameterizationVisitor
{
public:
  /// \name Operations
  /// @{

  /// called once the mesh, or both surfaces with their maps, have been found valid, before an initial map is made.
  ///
  /// \param number_of_vertices the vertices that will be mapped; isolated vertices do not count
  void on_initialization_begin(std::size_t number_of_vertices);

  /// called when a level of the hierarchy has been mapped: before `on_initialization_end()`, but by `map_surface()` after it.
  ///
  /// \param number_of_vertices the vertices of the level; they grow from call to call, but start again if an attempt
  ///        failed
  void on_level(std::size_t number_of_vertices);

  /// called when the initial map is there, of `map_surface()` the aligned start, before anything is lowered. From now on, stopping a
  /// parameterizer leaves a bijection at once, if the method promises one.
  void on_initialization_end();

  /// called after each sweep over the mesh, or each step of a method that moves all vertices at once.
  ///
  /// \param iteration the number of the sweep or step, from 1
  /// \param energy what the sweep has lowered: for the dial of a `CGAL::Spherical_parameterization::Sharpness`, the objective
  ///        \f$ \Phi \f$; for a schedule, \f$ \log( \frac{1}{n} \sum \exp( s E ) ) / s \f$, or the average energy for
  ///        \f$ s = 0 \f$, which may grow where \f$ s \f$ does. Of the other methods, the energy that they minimise, in
  ///        units of the area
  /// \param radius the radius of the sphere in the unit of length of the mesh
  void after_iteration(std::size_t iteration, double energy, double radius);

  /// called after `after_iteration()`; while a hierarchy is made, before each level, and later before each sweep over one; and while
  /// spheres are aligned, overlaid or measured, every few milliseconds. The clock of `maximum_running_time` is asked as often.
  ///
  /// \param iteration the number of the sweep or step, from 1; 0 on the levels and where there are none
  /// \param energy as for `after_iteration()`; on the levels, the average energy of the level; 0 where there are none
  ///
  /// \return `false` to stop as soon as possible: the map that has been reached is certified and returned, or the best
  ///         rotations that have been found, or else nothing but `ERROR_STOPPED`. On the levels, the rest of the hierarchy is mapped first, with the minimum of one
  ///         sweep a level.
  bool go_further(std::size_t iteration, double energy);

  /// called after the last sweep or step, before the map is certified and written.
  void on_optimization_end();

  /// @}
};
