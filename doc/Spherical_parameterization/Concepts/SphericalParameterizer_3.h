/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphericalParameterizer_3` describes a method that maps a closed triangle mesh of genus 0 to a sphere around the
origin. As any one-to-one map can start a method that improves one, an initial parameterizer is a model of the same
concept.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3<TriangleMesh, InitialParameterizer, Energy, Sharpness, Radius, VertexUpdate, Barrier>}
\cgalHasModels{CGAL::Spherical_parameterization::Published_low_distortion_parameterizer_3<TriangleMesh, InitialParameterizer, Sharpness, Radius>}
\cgalHasModels{CGAL::Spherical_parameterization::Hierarchical_parameterizer_3<TriangleMesh, Energy, Sharpness, VertexUpdate>}
\cgalHasModels{CGAL::Spherical_parameterization::Stereographic_parameterizer_3<TriangleMesh, SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Harmonic_parameterizer_3<TriangleMesh, SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Conformal_parameterizer_3<TriangleMesh, SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::ARAP_parameterizer_3<TriangleMesh, InitialParameterizer, SolverTraits>}
\cgalHasModels{CGAL::Spherical_parameterization::Precomputed_parameterizer_3<TriangleMesh, VertexSphereMap>}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::parameterize()`
*/
class SphericalParameterizer_3
{
public:
  /// \name Operations
  /// @{

  /// computes the map.
  ///
  /// \tparam ConcurrencyTag one of `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, and `CGAL::Parallel_if_available_tag`
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam VertexSphereMap a model of `WritablePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"; what is not of use is to be
  ///        ignored
  ///
  /// \return `OK` only if the map that was written is one-to-one, and `ERROR_NO_1_TO_1_MAPPING` if it is not; with all
  ///         other values no map is written
  template <class ConcurrencyTag, class TriangleMesh, class VertexSphereMap, class NamedParameters>
  CGAL::Spherical_parameterization::Error_code parameterize(const TriangleMesh& tmesh,
                                                            VertexSphereMap vertex_sphere_map,
                                                            const NamedParameters& np);

  /// @}
};
