/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `VertexUpdate_3` describes how one vertex moves on the sphere while all others stay. It is called by several threads
at once, by each of them for one vertex after the other. That `CGAL::Spherical_parameterization::Newton_update_3` can also be
called for several vertices at once is no part of the concept.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Newton_update_3}
\cgalHasModels{CGAL::Spherical_parameterization::Gradient_update_3}
\cgalHasModelsEnd

\sa `VertexEnergy_3`
\sa `CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`
\sa `CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`
*/
class VertexUpdate_3
{
public:
  /// \name Operations
  /// @{

  /// chooses where a vertex moves, in coordinates of the tangent plane in which it is the origin.
  ///
  /// \tparam VertexEnergy a model of `VertexEnergy_3`
  ///
  /// \param energy the energy of the star of the vertex
  /// \param step the coordinates to move to; not to be touched if the vertex stays
  ///
  /// \return whether the vertex moves; only allowed if `energy` is finite at `step`
  template <class VertexEnergy>
  bool operator()(const VertexEnergy& energy, std::array<double, 2>& step) const;

  /// @}

  /// \name Optional Members
  /// A model need not have these.
  /// @{

  /// returns whether the parameters of the update are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// returns the update for the levels of a hierarchy that are coarser than the mesh, an object of the same type. Without this
  /// member, all levels get the same update.
  VertexUpdate_3 on_coarse_levels() const;

  /// @}
};
