# For toolchains: the headers of CGAL, Boost, Eigen and CLI11 of this system, without GMP and TBB, in a folder of their own, as those
# beside them are of this system alone. Libraries are those of PREFIX, the folder of the other system's.

set(root "${CMAKE_BINARY_DIR}/root")
file(MAKE_DIRECTORY "${root}/include" "${root}/lib/cmake" "${root}/share/eigen3")
foreach(name CGAL boost CLI eigen3)
  file(CREATE_LINK "/usr/include/${name}" "${root}/include/${name}" SYMBOLIC)
endforeach()
file(GLOB cgal_dir /usr/lib/*/cmake/CGAL)
file(CREATE_LINK "${cgal_dir}" "${root}/lib/cmake/CGAL" SYMBOLIC)
file(CREATE_LINK /usr/share/eigen3/cmake "${root}/share/eigen3/cmake" SYMBOLIC)
set(CMAKE_FIND_ROOT_PATH "${root}" "${PREFIX}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CGAL_DISABLE_GMP ON)
