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

  /// returns the sharpness of a sweep over the mesh, at least 0. It is called with `sweep` 0, and what is the average and the
  /// largest energy there, for the levels of a hierarchy as well that have at least half of the vertices of the mesh and no fewer
  /// than 2500: they are to end close to where the mesh will.
  ///
  /// \param sweep the number of the sweep, from 0
  /// \param average_energy the average energy of the faces before the sweep
  /// \param largest_energy the largest energy of a face before the sweep
  double operator()(std::size_t sweep, double average_energy, double largest_energy);

  /// returns the sharpness of the next sweeps over a coarser level of a hierarchy, whose largest energy is `largest_energy`. It
  /// is not called on levels below 300 vertices, where it is 0. Neither function is when a hierarchy is mapped again after an
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
