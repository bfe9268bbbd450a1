/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes the energy of the map of one face, a function of the two invariants
\f$ I = \sigma_1^2 + \sigma_2^2 \f$ and \f$ d = \sigma_1 \sigma_2 \f$ of its singular values \f$ \sigma_1 \leq \sigma_2 \f$.

The energy must not be negative, has to be smooth for positive arguments, grow beyond all bounds as \f$ d \f$ goes to 0 (this keeps
faces from being inverted), and be convex along lines in the plane, at least near its minimum. It is called by several threads at
once.

Both operations are written either for `double` or as templates over the number type, as here. The map is the same to the last bit
either way. Vertices are moved several at once, in the lanes of vector registers, and templates are then called with a number per
lane, functions of `double` for one lane after the other. A template has to compile for any type `FT` that can be constructed from a
`double` and has a sign and the four operations of arithmetic with itself and with `double`; that excludes branches and the functions
of `<cmath>`.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Symmetric_Dirichlet_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Isometric_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Conformal_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Stretch_energy_3}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`
\sa `CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`
*/
class DistortionEnergy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the energy of a face whose map has the invariants `i` and `d`, both positive.
  ///
  /// \tparam FT the number type, see above
  template <class FT>
  FT operator()(const FT& i, const FT& d) const;

  /// returns the energy of a face whose map has the invariants `i` and `d`, both positive, with its first and second derivatives in
  /// them.
  ///
  /// \tparam FT the number type, see above
  template <class FT>
  CGAL::Spherical_parameterization::Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const;

  /// @}

  /// \name Optional Members
  /// A model need not have these.
  /// @{

  /// If it is `true`, faces count by their areas on the surface: all sums and means over them have these as weights, also those of
  /// the report. If not, or without it, each face counts the same.
  static constexpr bool weighs_faces_by_area = false;

  /// If it is `true`, the surface is stretched before it is mapped: areas are multiplied by a density, larger where the surface is
  /// curved, and angles stay as they are. If not, or without it, faces have the areas of the surface.
  static constexpr bool follows_curvature = false;

  /// returns whether the parameters of the energy are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// returns the factor by which the radius has to be multiplied to minimise the sum of the energies of `faces`, for energies that
  /// have a closed form of it. Without it, `CGAL::Spherical_parameterization::Optimal_radius_3` finds the factor by Newton's method.
  double optimal_scale(const CGAL::Spherical_parameterization::Face_range_3& faces) const;

  /// @}
};
