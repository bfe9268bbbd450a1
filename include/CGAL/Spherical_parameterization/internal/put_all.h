// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors
//

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PUT_ALL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PUT_ALL_H

#include <CGAL/license/Spherical_parameterization.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <exception>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

// Writes values[k] for the key key(k), for all k, and returns true. If the map can be read as well, is_accepted() is
// asked when all have been written: if it returns false, or if it, put() or get() throws, the values that have been
// overwritten are put back; a key that refuses any value keeps its own. A map that can only be written keeps what it
// has got. What is thrown first reaches the caller.
template <class PropertyMap, class Key, class Condition>
bool put_all(PropertyMap map, const Key& key,
             const std::vector<typename boost::property_traits<PropertyMap>::value_type>& values,
             const Condition& is_accepted)
{
  using Category = typename boost::property_traits<PropertyMap>::category;
  if constexpr(std::is_convertible<Category, boost::readable_property_map_tag>::value)
  {
    std::vector<typename boost::property_traits<PropertyMap>::value_type> former;
    former.reserve(values.size());
    const auto put_back = [&] {
      std::exception_ptr first_exception;
      for(std::size_t k = former.size(); k-- > 0;)
        try
        {
          put(map, key(k), former[k]);
        }
        catch(...) // the others are put back all the same
        {
          if(!first_exception)
            first_exception = std::current_exception();
        }
      return first_exception;
    };
    try
    {
      for(std::size_t k = 0; k < values.size(); ++k)
      {
        former.push_back(get(map, key(k)));
        put(map, key(k), values[k]);
      }
      if(is_accepted())
        return true;
    }
    catch(...)
    {
      put_back();
      throw;
    }
    if(const std::exception_ptr exception = put_back())
      std::rethrow_exception(exception);
    return false;
  }
  else
  {
    for(std::size_t k = 0; k < values.size(); ++k)
      put(map, key(k), values[k]);
    return true;
  }
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PUT_ALL_H
