/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `VertexUpdate_3` describes how one vertex moves on the sphere while all others stay. It is called by several threads
at once.

A model may have `bool is_valid() const` in addition, whether its parameters are in their ranges.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Newton_update_3}
\cgalHasModels{CGAL::Spherical_parameterization::Gradient_update_3}
\cgalHasModelsEnd
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
};
