/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphereRadiusPolicy_3` describes how the radius of the sphere is chosen where it is not left to the objective, as
`CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3` does by default. A policy may take the radius in another
direction than the vertices, so that the objective may rise from sweep to sweep.

The policy is called before each sweep over the mesh, and once more after the last one. The first and the last time the radius
becomes what it returns, otherwise it goes half the way, in the sense of the geometric mean (all the way in
`CGAL::Spherical_parameterization::Published_low_distortion_parameterizer_3`); a value that is not positive and finite is ignored. On
the coarse levels of a hierarchy, `CGAL::Spherical_parameterization::Optimal_radius_3` is in use. A policy may have mutable state:
each run works on a copy of the one that the parameterizer was given.

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

  /// returns the radius to start with, in the unit of length of the surface.
  ///
  /// \param equal_area_radius the radius of the sphere which has the area of the surface, eq. 10 of \cgalCite{cgal:whfl-bspld-16}
  double initial_radius(double equal_area_radius) const;

  /// returns the radius that follows `radius`.
  ///
  /// \tparam Energy a model of `DistortionEnergy_3`
  ///
  /// \param energy the energy in use
  /// \param faces the faces, as they are on the sphere of radius `radius`
  /// \param radius the current radius in the unit of length of the surface
  template <class Energy>
  double operator()(const Energy& energy, const CGAL::Spherical_parameterization::Face_range_3& faces, double radius);

  /// @}

  /// \name Optional Members
  /// A model need not have these.
  /// @{

  /// starts the next phase of the policy and returns whether there is one. It is called when energy and radius have
  /// settled, and as often as it returns `true`, at most 1000 times, before the last radius is asked for, which is that of
  /// the last phase. It is not called after it has returned `false`. Without it, the policy has one phase.
  bool next_phase();

  /// returns whether the parameters of the policy are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// @}
};
