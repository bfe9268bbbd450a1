/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes the energy of the map of one face, a function of the two invariants
\f$ I = \sigma_1^2 + \sigma_2^2 \f$ and \f$ d = \sigma_1 \sigma_2 \f$ of its singular values \f$ \sigma_1 \leq \sigma_2 \f$.

The energy must not be negative, has to be smooth for positive arguments, grow beyond all bounds as \f$ d \f$ goes to 0 (this keeps
faces from being inverted), and be convex along lines in the plane, at least near its minimum. It is called by several threads at
once.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Symmetric_Dirichlet_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Isometric_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Conformal_energy_3}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`
\sa `CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`
*/
class DistortionEnergy_3
{
public:
  /// \name Optional Type
  /// @{

  /// An alias of `CGAL::Tag_true` in an energy both of whose operations are templates. A model need not have it.
  ///
  /// \code
  /// template <class FT>
  /// FT operator()(const FT& i, const FT& d) const;
  /// template <class FT>
  /// CGAL::Spherical_parameterization::Basic_energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const;
  /// \endcode
  ///
  /// `FT` is any type that can be constructed from a `double` and has a sign and the four operations of arithmetic with itself and
  /// with `double`. Then, with `CGAL::Spherical_parameterization::Newton_update_3`, which moves several vertices at once, the
  /// energy is evaluated for several faces in one call. Without it, it is called for one face after the other, which gives the same
  /// map in somewhat more time.
  typedef unspecified_type Is_lanewise;

  /// @}

  /// \name Operations
  /// @{

  /// returns the energy of a face whose map has the invariants `i` and `d`, both positive.
  double operator()(double i, double d) const;

  /// returns the energy of a face whose map has the invariants `i` and `d`, both positive, with its first and second derivatives in
  /// them.
  CGAL::Spherical_parameterization::Energy_derivatives_3 derivatives(double i, double d) const;

  /// @}

  /// \name Optional Members
  /// A model need not have these.
  /// @{

  /// returns whether the parameters of the energy are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// returns the factor by which the radius has to be multiplied to minimise the sum of the energies of `faces`, for energies that
  /// have a closed form of it.
  ///
  /// It is called by `CGAL::Spherical_parameterization::Optimal_radius_3`, which otherwise finds the factor by Newton's method.
  ///
  /// \tparam FaceRange a model of `ConstRange` whose value type is `CGAL::Spherical_parameterization::Face_invariants_3`
  template <class FaceRange>
  double optimal_scale(const FaceRange& faces) const;

  /// @}
};
