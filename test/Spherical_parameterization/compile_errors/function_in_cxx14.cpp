// -std=c++14

#include <CGAL/Spherical_parameterization/parameterize.h> // error: needs C++17
