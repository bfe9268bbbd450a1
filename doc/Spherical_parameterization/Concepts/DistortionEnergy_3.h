/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes the distortion energy of a face, a function of the two invariants
\f$ I = \sigma_1^2 + \sigma_2^2 \f$ and \f$ d = \sigma_1 \sigma_2 \f$ of the singular values \f$ \sigma_1 \leq \sigma_2 \f$ of its
map.

The energy must be non-negative and smooth for positive arguments. It must go to infinity as \f$ d \f$ goes to 0, which prevents
inverted faces. It must be convex along lines in the plane, at least near its minimum. Several threads call it concurrently.

Both operations are either functions of `double`, or templates over the number type as below. The map is bitwise identical in both
cases. Several vertices are moved at once by vector instructions. Templates are then called with packs of numbers, one per lane;
functions of `double` are called for each lane in turn. A template must compile for any type `FT` that is constructible from
`double` and has a sign and the four arithmetic operations with itself and with `double`. This excludes branches and the functions
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

  /// returns the energy of a face whose map has the invariants `i` and `d`, both positive, and its first and second
  /// derivatives in the invariants.
  ///
  /// \tparam FT the number type, see above
  template <class FT>
  CGAL::Spherical_parameterization::Energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const;

  /// @}

  /// \name Optional Members
  /// These members are optional.
  /// @{

  /// If this is `true`, faces are weighted by their areas on the surface, in all sums and means, including those of the
  /// report. If it is `false` or missing, all faces have the same weight.
  static constexpr bool weighs_faces_by_area = false;

  /// If this is `true`, the surface is stretched before it is mapped: areas are multiplied by a density that grows with
  /// the curvature, and angles are preserved. If it is `false` or missing, faces have the areas of the surface.
  static constexpr bool follows_curvature = false;

  /// returns whether the parameters of the energy are in their ranges. If not, a parameterizer returns
  /// `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// returns the factor that minimizes the sum of the energies of `faces` when the radius is multiplied by it, for
  /// energies for which it has a closed form. If this member is missing,
  /// `CGAL::Spherical_parameterization::Optimal_radius_3` computes the factor by Newton's method.
  double optimal_scale(const CGAL::Spherical_parameterization::Face_range_3& faces) const;

  /// @}
};
