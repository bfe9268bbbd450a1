# Builds for Windows on Debian, by MinGW-w64:
#
#   cmake -S . -B build/windows -DCMAKE_TOOLCHAIN_FILE=cmake/toolchain_mingw.cmake
#
# The headers of CGAL, Boost, Eigen and CLI11 are those of this system, without GMP and TBB. What runs runs under Wine.

set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
find_program(SPHERICAL_PARAMETERIZATION_WINE NAMES wine64 wine PATHS /usr/lib/wine)
set(CMAKE_CROSSCOMPILING_EMULATOR "${CMAKE_COMMAND}" -E env "WINEPREFIX=${CMAKE_BINARY_DIR}/wine" WINEDEBUG=-all
                                  "${SPHERICAL_PARAMETERIZATION_WINE}")

set(PREFIX /usr/x86_64-w64-mingw32)
include("${CMAKE_CURRENT_LIST_DIR}/headers_of_this_system.cmake")
set(ZLIB_LIBRARY /usr/x86_64-w64-mingw32/lib/libz.a)
