# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(sherd): the libraries sherd::meshops, sherd::core and sherd::fracture.
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Eigen3 3.4)
find_dependency(CGAL 5.5)
find_dependency(CHOLMOD)
find_dependency(OpenVDB 10)
list(REMOVE_ITEM CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/sherdTargets.cmake)
