# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(sherd) defines the libraries sherd::meshops, sherd::core and sherd::fracture, and from the program
# sherd::scene (reads scenes and builds simulations), sherd::recording (writes and reads recordings) and sherd::run
# (runs scenes).
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Eigen3 3.4)
find_dependency(CGAL)
find_dependency(CHOLMOD)
find_dependency(TBB)
find_dependency(OpenVDB 10)
# CMake finds HDF5 by compiling a C program.
if(NOT CMAKE_C_COMPILER_LOADED)
    enable_language(C)
endif()
find_dependency(HDF5 1.10 COMPONENTS C)
find_dependency(PNG 1.6)
find_dependency(JPEG)
find_dependency(ZLIB)
find_dependency(fmt)
find_dependency(tomlplusplus)
list(REMOVE_ITEM CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/sherdTargets.cmake)
