// -std=c++14

#include <CGAL/spherical_parameterization.h> // error: needs C++17
