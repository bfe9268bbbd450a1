# Builds for Linux on aarch64, on Debian. What runs is emulated by QEMU.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
# No notes on how vectors are passed; and no constants of several functions behind one address: g++ 12 puts some of those of
# test_numbers.cpp eight bytes away from where it reads them.
set(CMAKE_CXX_FLAGS_INIT "-Wno-psabi -fno-section-anchors")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
set(PREFIX /usr/aarch64-linux-gnu)
include("${CMAKE_CURRENT_LIST_DIR}/headers_of_this_system.cmake")
