# SPDX-License-Identifier: GPL-3.0-or-later
# SuiteSparse 5 has no CMake configuration of its own. Defines CHOLMOD::CHOLMOD, which links OpenBLAS: on the
# reference BLAS the factorization takes five times as long. Used by this project and by its installed package.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(OPENBLAS_LIBRARY openblas)
# The OpenMP runtime that CHOLMOD itself runs on, whatever compiler builds this project.
find_library(GOMP_LIBRARY NAMES libgomp.so.1 gomp)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY OPENBLAS_LIBRARY GOMP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR OPENBLAS_LIBRARY
                                                GOMP_LIBRARY)
if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
    add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED)
    set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
                          IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
                          INTERFACE_LINK_LIBRARIES "${OPENBLAS_LIBRARY};${GOMP_LIBRARY}")
endif()
