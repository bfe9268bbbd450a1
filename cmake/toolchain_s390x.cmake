# Builds for Linux on s390x, which is big-endian, on Debian. What runs is emulated by QEMU.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR s390x)
set(CMAKE_C_COMPILER s390x-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER s390x-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi) # notes on how vectors are passed
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-s390x-static)
set(PREFIX /usr/s390x-linux-gnu)
include("${CMAKE_CURRENT_LIST_DIR}/headers_of_this_system.cmake")
