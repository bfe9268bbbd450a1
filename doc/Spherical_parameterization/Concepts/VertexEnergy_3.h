/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `VertexEnergy_3` describes what a vertex update gets to see of a vertex: the part of the objective that depends on
the vertex, as a function of two coordinates of the tangent plane in which the vertex is the origin. The point of the sphere
with the coordinates \f$ (x, y) \f$ is the one that is projected to them orthogonally. The models are internal to the package.

\sa `VertexUpdate_3`
*/
class VertexEnergy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the energy with the vertex at \f$ (x, y) \f$, or infinity if that inverts a face.
  double operator()(double x, double y) const;

  /// computes the gradient \f$ (f_x, f_y) \f$ and the Hessian \f$ (f_{xx}, f_{xy}, f_{yy}) \f$ at the origin, and
  /// returns the energy there.
  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const;

  /// computes the gradient alone, which takes less time, and returns the energy at the origin.
  double gradient(std::array<double, 2>& gradient) const;

  /// returns the length of the shortest edge at the vertex, on the unit sphere.
  double shortest_edge() const;

  /// @}
};
