/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphericalParameterizationVisitor` describes objects that observe the progress of a run and may stop it. Runs are calls
of `CGAL::Spherical_parameterization::parameterize()`, `CGAL::Spherical_parameterization::map_surface()` and the other functions in
the table.

All functions are called from the thread that started the run. If one of them throws an exception, the output map is left unchanged.
Each parameterizer calls the functions that apply to it. `on_level()` is called only if the run starts from the levels of
`CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`.

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

`CGAL::Spherical_parameterization::map_surface()` minimizes the energy on levels of the first surface. There are no levels if the
surfaces already match.

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

  /// called once the mesh, or both surfaces with their maps, have been found valid, before an initial map is computed.
  ///
  /// \param number_of_vertices the number of vertices that will be mapped, without isolated vertices
  void on_initialization_begin(std::size_t number_of_vertices);

  /// called when a level of the hierarchy has been mapped: before `on_initialization_end()` by parameterizers, after it
  /// by `map_surface()`.
  ///
  /// \param number_of_vertices the number of vertices of the level; it increases from call to call, but starts again if
  ///        an attempt failed
  void on_level(std::size_t number_of_vertices);

  /// called when the initial map has been computed, or the aligned initial map of `map_surface()`, before the energy is
  /// minimized. From now on, a parameterizer that guarantees a bijection returns one immediately when it is stopped.
  void on_initialization_end();

  /// called after each sweep over the mesh, or each step of a method that moves all vertices at once.
  ///
  /// \param iteration the number of the sweep or step, from 1
  /// \param energy the objective: \f$ \Phi \f$ for a relative sharpness, see
  ///        `CGAL::Spherical_parameterization::Sharpness`; for a schedule,
  ///        \f$ \log( \frac{1}{n} \sum \exp( s E ) ) / s \f$, or the average energy for \f$ s = 0 \f$, which may
  ///        increase when \f$ s \f$ does. For other methods, the energy that they minimize, in units of the area
  /// \param radius the radius of the sphere in the unit of length of the mesh
  void after_iteration(std::size_t iteration, double energy, double radius);

  /// called after `after_iteration()`; before each level while a hierarchy is constructed; before or after each
  /// sweep over a level; and every few milliseconds while spheres are aligned, overlaid or measured. The clock of
  /// `maximum_running_time` is checked at the same times.
  ///
  /// \param iteration the number of the sweep or step, from 1; 0 on the levels and where there are none
  /// \param energy as for `after_iteration()`; on the levels, the average energy or the objective of the level; 0 where
  ///        it is not known
  ///
  /// \return `false` to stop as soon as possible. A parameterizer then certifies and returns the current map; on the
  ///         levels, it first maps the rest of the hierarchy with the minimum of one sweep per level. An alignment
  ///         returns the best rotations found so far. Other functions return `ERROR_STOPPED`.
  bool go_further(std::size_t iteration, double energy);

  /// called after the last sweep or step, before the map is certified and written.
  void on_optimization_end();

  /// @}
};
