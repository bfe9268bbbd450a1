# find_file_libraries(): the libraries of geometry images and of files of cortical surfaces, for the program, the Python module and the tests, if
# they are there.
function(find_file_libraries)
  find_package(PNG QUIET)
  find_package(ZLIB QUIET)
  find_package(EXPAT QUIET)
  # Debian's files of Imath, which OpenEXR needs, print at length that a part of it is missing that was not asked for.
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  find_package(OpenEXR QUIET CONFIG)
endfunction()

# use_surface_files(TARGET PREFIX): links the libraries of these files that there are, and defines PREFIX_MGH and PREFIX_GIFTI
# where there are those of a format.
function(use_surface_files target prefix)
  if(TARGET ZLIB::ZLIB)
    target_link_libraries(${target} PRIVATE ZLIB::ZLIB)
    target_compile_definitions(${target} PRIVATE ${prefix}_MGH)
  endif()
  if(TARGET ZLIB::ZLIB AND TARGET EXPAT::EXPAT)
    target_link_libraries(${target} PRIVATE EXPAT::EXPAT)
    target_compile_definitions(${target} PRIVATE ${prefix}_GIFTI)
  else()
    message(STATUS "NOTICE: zlib or expat is not found. ${target} will not read GIFTI or MGH files.")
  endif()
endfunction()
