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

// Between this file and end_arithmetic.h, each floating-point operation is rounded individually.
//
// If the processor has a fused multiply-add instruction, compilers use it for a * b + c by default, which changes the
// last digit of the result: on AArch64, and on x86-64 with -march=native. So the code of each header that computes is
// between these two files, but not its includes: functions of other libraries (std::inner_product, products of
// std::complex) are compiled with the user's options, and must not be used where they round twice. Targets without such
// an instruction need no options. g++ does not inline these functions into others. Its vectorizer uses fused
// multiply-add even with -ffp-contract=off (patterns of complex numbers in g++ 12), and is disabled;
// performance-critical code is written in lanes.
//
// This file has no include guard, like CGAL/disable_warnings.h.
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
