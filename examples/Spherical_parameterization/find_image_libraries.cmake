# find_image_libraries(): the libraries of geometry images, for the examples and the tests, if they are there.
function(find_image_libraries)
  find_package(PNG QUIET)
  # Debian's files of Imath, which OpenEXR needs, tell at length that a part of it is missing that nobody asked for.
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
  find_package(OpenEXR QUIET CONFIG)
endfunction()
