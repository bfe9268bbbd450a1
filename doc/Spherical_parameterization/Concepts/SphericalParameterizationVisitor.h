/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `SphericalParameterizationVisitor` describes what is told of the progress of a parameterization and may stop it.
All functions are called from the thread that called `CGAL::Spherical_parameterization::parameterize()`. An exception
that is thrown by one of them leaves the output map as it was.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spherical_parameterization::Default_visitor}
\cgalHasModelsEnd
*/
class SphericalParameterizationVisitor
{
public:
  /// \name Operations
  /// @{

  /// called once the mesh has been found valid, before an initial map is made.
  void on_initialization_begin(std::size_t number_of_vertices);

  /// called when a level of the hierarchy with `number_of_vertices` vertices has been mapped; they grow from call to call,
  /// but start again if an attempt has failed.
  void on_level(std::size_t number_of_vertices);

  /// called when the initial map is there.
  void on_initialization_end();

  /// called after sweep number `iteration`, from 1, over the mesh, with the mean energy that it has lowered and the radius.
  void after_iteration(std::size_t iteration, double energy, double radius);

  /// called after `after_iteration()`, and now and then on the levels of the hierarchy, there with `iteration` 0.
  ///
  /// \return `false` to stop as soon as possible; the map that has been reached is certified and returned nonetheless
  bool go_further(std::size_t iteration, double energy);

  /// called after the last sweep, before the map is certified and written.
  void on_optimization_end();

  /// @}
};
