/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SharpnessPolicy_3` describes how the sharpness \f$ s \f$ of the objective \f$ \sum \exp( s E ) \f$ is chosen for each
sweep. The objective is eq. 7 of \cgalCite{cgal:whfl-bspld-16}; \f$ s = 0 \f$ stands for the plain sum \f$ \sum E \f$ of eq. 6.

A policy may keep a state: each run works on a copy of the one that the parameterizer was given.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Relative_sharpness_3}
\cgalHasModels{CGAL::Spherical_parameterization::Absolute_sharpness_3}
\cgalHasModelsEnd

\sa `CGAL::Spherical_parameterization::Bijective_low_distortion_parameterizer_3`
\sa `CGAL::Spherical_parameterization::Hierarchical_parameterizer_3`
*/
class SharpnessPolicy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the sharpness of a sweep over the mesh, at least 0.
  ///
  /// It is also called, with `sweep` 0 and with the energies of the level, for those levels of a hierarchy that have at least 2500
  /// vertices and half of those of the mesh: what the mesh will be swept with first, they are swept with already. On levels, and by
  /// `CGAL::Spherical_parameterization::Hierarchical_parameterizer_3` on the mesh as well, the policy is asked anew every few
  /// sweeps. The hierarchy has a copy of the policy, whose state does not go on to the sweeps over the mesh.
  ///
  /// \param sweep the number of the sweep, from 0
  /// \param average_energy the average energy of the faces before the sweep
  /// \param largest_energy the largest energy of a face before the sweep
  double operator()(std::size_t sweep, double average_energy, double largest_energy);

  /// returns the sharpness of the next sweeps over a coarser level of a hierarchy, whose largest energy is `largest_energy`. On
  /// levels below 300 vertices it is 0 without being asked. Neither function is called when a hierarchy is mapped again after an
  /// attempt has failed.
  double on_coarse_level(double largest_energy) const;

  /// returns whether the schedule has come to its end, so that it makes sense to ask whether the map has settled.
  bool is_final() const;

  /// @}

  /// \name Optional Members
  /// A model need not have these.
  /// @{

  /// returns whether the parameters of the policy are in their ranges. If not, a parameterizer returns `ERROR_WRONG_PARAMETER`.
  bool is_valid() const;

  /// @}
};
