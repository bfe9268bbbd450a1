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

#include <CGAL/license/Spherical_parameterization.h>

// From here to end_arithmetic.h, each floating-point operation is rounded by itself.
//
// Where the processor multiplies and adds in one operation, compilers use it for a * b + c unless they are asked not to, and the
// result is another one in the last digit: on AArch64, and on x86-64 with -march=native. So each header that computes is between
// these two files, its includes are not: what the package takes from other libraries (std::inner_product, products of
// std::complex) is compiled as the user wants, and must not be used where it rounds twice. There is nothing to do for a target without such an operation.
// g++ inlines none of these functions into functions of others. Its vectorizer multiplies and adds in one operation even so (the
// patterns of complex numbers in g++ 12, with -ffp-contract=off as well), and is left out: what counts is written in lanes.
//
// It has no include guard, as CGAL/disable_warnings.h has none.
#if defined(__clang__)
#pragma float_control(push)
#pragma clang fp contract(off)
#elif defined(__GNUC__) && defined(__FP_FAST_FMA)
#pragma GCC push_options
#pragma GCC optimize("fp-contract=off", "no-tree-vectorize")
#elif defined(_MSC_VER)
#pragma float_control(push)
#pragma fp_contract(off)
#endif
