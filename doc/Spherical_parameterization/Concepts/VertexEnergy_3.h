/*!
\ingroup PkgSphericalParameterizationConcepts
\cgalConcept

The concept `VertexEnergy_3` describes what a vertex update gets to see of a vertex: the part of the objective that depends on
the vertex, as a function of two coordinates of the tangent plane in which the vertex is the origin.

The point of the sphere with the coordinates \f$ (x, y) \f$ is the one that is projected to them orthogonally; the unit of length is
the radius of the sphere. The models are internal to the package.

\sa `VertexUpdate_3`
*/
class VertexEnergy_3
{
public:
  /// \name Operations
  /// @{

  /// returns the energy with the vertex at the point with the coordinates `x` and `y`, or infinity if that inverts a face.
  double operator()(double x, double y) const;

  /// computes the first derivatives \f$ (f_x, f_y) \f$ and the second ones \f$ (f_{xx}, f_{xy}, f_{yy}) \f$ at the origin, and returns
  /// the energy there.
  ///
  /// \param gradient receives the first derivatives
  /// \param hessian receives the second derivatives
  double derivatives(std::array<double, 2>& gradient, std::array<double, 3>& hessian) const;

  /// computes the first derivatives \f$ (f_x, f_y) \f$ at the origin alone, which takes less time, and returns the energy there.
  ///
  /// \param gradient receives the first derivatives
  double gradient(std::array<double, 2>& gradient) const;

  /// returns the length of the shortest edge at the vertex.
  double shortest_edge() const;

  /// @}
};
