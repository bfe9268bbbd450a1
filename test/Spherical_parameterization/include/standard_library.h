#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEST_STANDARD_LIBRARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEST_STANDARD_LIBRARY_H

// What the tests use of the standard library.

#include <algorithm>
#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <istream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <ostream>
#include <queue>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEST_STANDARD_LIBRARY_H
