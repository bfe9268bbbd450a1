/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphericalParameterizer_3` describes a method that maps a closed triangle mesh of genus 0 to a sphere around the origin.

Initial parameterizers are models of the same concept, since any bijective map can start a method that improves it. An initial
parameterizer is called with the named parameters `vertex_point_map` and `visitor`, and its result is certified before it is used.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3<Energy, Radius, InitialParameterizer>}
\cgalHasModels{CGAL::Spherical_parameterization::Published_low_distortion_parameterizer_3<Radius, InitialParameterizer>}
\cgalHasModels{CGAL::Spherical_parameterization::Hierarchical_parameterizer_3<Energy>}
\cgalHasModels{CGAL::Spherical_parameterization::Stereographic_parameterizer_3<SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Schnyder_parameterizer_3}
\cgalHasModels{CGAL::Spherical_parameterization::Harmonic_parameterizer_3<SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Target_area_parameterizer_3<Energy, DensityMap>}
\cgalHasModels{CGAL::Spherical_parameterization::Conformal_parameterizer_3<SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::ARAP_parameterizer_3<InitialParameterizer, SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Precomputed_parameterizer_3<VertexSphereMap>}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::parameterize()`
*/
class SphericalParameterizer_3
{
public:
  /// \name Operations
  /// @{

  /// computes the map. The object may change, for example to report later on the run, so concurrent calls need separate
  /// objects.
  ///
  /// \tparam ConcurrencyTag one of `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, and `CGAL::Parallel_if_available_tag`
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam VertexSphereMap a model of `WritablePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` of a \cgal kernel as
  ///         value type; its coordinates are of type `double` or `float`, or of an exact number type
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tmesh the mesh
  /// \param vertex_sphere_map the map to be written
  /// \param np named parameters; parameters that do not apply are ignored
  ///
  /// \return `OK` only if the map that was written is bijective; `ERROR_NO_1_TO_1_MAPPING` if it was written and is not
  ///         bijective. With all other values, the map is unchanged, unless it rounded the written values and this
  ///         inverted faces.
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  CGAL::Spherical_parameterization::Error_code parameterize(const TriangleMesh& tmesh,
                                                            VertexSphereMap vertex_sphere_map,
                                                            const NamedParameters& np);

  /// @}

  /// \name Optional Members
  /// These members are optional.
  /// @{

  /// returns whether the parameters of the method are in their ranges. If not, a parameterizer that would start from
  /// its map returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// @}
};
