/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphereRadiusPolicy_3` describes how the radius of the sphere is chosen. Without a policy, as by default in
`CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`, the radius is a variable of the objective. A policy
may choose a radius that increases the objective, so that the objective is not monotonic over the sweeps.

The policy is called before each sweep over the mesh, and once more after the last one. At the first and the last call, its result
becomes the radius. At all other calls, the new radius is the geometric mean of the old radius and the result, or the result itself
in `CGAL::Spherical_parameterization::Published_low_distortion_parameterizer_3`. A result that is not positive and finite is
ignored. The coarse levels of a hierarchy use the radius that minimizes their energy instead. A policy may have mutable state: each run works on a copy of the policy that was passed to the parameterizer.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Two_phase_radius_3<FirstRadius, SecondRadius>}
\cgalHasModels{CGAL::Spherical_parameterization::Area_preserving_radius_3}
\cgalHasModels{CGAL::Spherical_parameterization::Area_balancing_radius_3}
\cgalHasModels{CGAL::Spherical_parameterization::Optimal_radius_3}
\cgalHasModels{CGAL::Spherical_parameterization::Fixed_radius_3}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`
*/
class SphereRadiusPolicy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the initial radius, in the unit of length of the surface.
  ///
  /// \param equal_area_radius the radius of the sphere that has the area of the surface, eq. 10 of
  ///        \cgalCite{cgal:whfl-bspld-16}
  double initial_radius(double equal_area_radius) const;

  /// returns the radius that follows `radius`.
  ///
  /// \tparam Energy a model of `DistortionEnergy_3`
  ///
  /// \param energy the energy in use
  /// \param faces the faces, mapped to the sphere of radius `radius`
  /// \param radius the current radius in the unit of length of the surface
  template <class Energy>
  double operator()(const Energy& energy, const CGAL::Spherical_parameterization::Face_range_3& faces, double radius);

  /// @}

  /// \name Optional Members
  /// These members are optional.
  /// @{

  /// starts the next phase of the policy and returns whether there is one. It is called when energy and radius have
  /// converged, repeatedly until it returns `false`, at most 1000 times, before the final radius is requested, which is
  /// that of the last phase. It is not called again after it has returned `false`. If this member is missing, the
  /// policy has one phase.
  bool next_phase();

  /// returns whether the parameters of the policy are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// @}
};
