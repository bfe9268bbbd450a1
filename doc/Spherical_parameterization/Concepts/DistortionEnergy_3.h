/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `DistortionEnergy_3` describes the energy of the map of one face, a function of the two invariants
\f$ I = \sigma_1^2 + \sigma_2^2 \f$ and \f$ d = \sigma_1 \sigma_2 \f$ of its singular values. It must not be negative, has
to be smooth for positive arguments, grow beyond all bounds as \f$ d \f$ goes to 0 (this keeps faces from being inverted), and be convex along
lines in the plane, at least near its minimum. It is called by several threads at once.

A model may have, in addition,

- `bool is_valid() const`, whether its parameters are in their ranges; if not, a parameterizer returns `ERROR_WRONG_PARAMETER`;
- `template <class FaceRange> double optimal_scale(const FaceRange& faces) const`, the factor for the radius that minimises the
  sum of the energies of a range of `Face_invariants_3`, if it has a closed form; see `Optimal_radius_3`;
- a nested type `Is_lanewise`, an alias of `CGAL::Tag_true`. It says that both functions of the concept are templates,
  `template <class FT> FT operator()(const FT& i, const FT& d) const` and
  `template <class FT> CGAL::Spherical_parameterization::Basic_energy_derivatives_3<FT> derivatives(const FT& i, const FT& d) const`,
  for any type `FT` that has the four operations of arithmetic with itself and with `double`. Then several vertices are moved at
  once, and the energy is evaluated for all of them in one call. Without it, it is called for one after the other, which gives the
  same map in somewhat more time.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Symmetric_Dirichlet_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Isometric_energy_3}
\cgalHasModels{CGAL::Spherical_parameterization::Conformal_energy_3}
\cgalHasModelsEnd
*/
class DistortionEnergy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the energy.
  double operator()(double i, double d) const;

  /// returns the energy and its first and second derivatives in `i` and `d`.
  CGAL::Spherical_parameterization::Energy_derivatives_3 derivatives(double i, double d) const;

  /// @}
};
