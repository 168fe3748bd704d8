# SPDX-License-Identifier: GPL-3.0-or-later
# SuiteSparse 5 has no CMake configuration of its own. Defines CHOLMOD::CHOLMOD, which links OpenBLAS: on the
# reference BLAS the factorization takes five times as long. Used by this project and by its installed package.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
find_library(OPENBLAS_LIBRARY openblas)
# The OpenMP runtime that CHOLMOD is linked with, independent of the compiler that builds this project.
find_library(GOMP_LIBRARY NAMES libgomp.so.1 gomp)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY OPENBLAS_LIBRARY GOMP_LIBRARY)
if(CHOLMOD_INCLUDE_DIR)
    set(CHOLMOD_VERSION "")
    file(GLOB headers ${CHOLMOD_INCLUDE_DIR}/cholmod.h ${CHOLMOD_INCLUDE_DIR}/cholmod_core.h) # 5 has the latter
    foreach(header ${headers})
        file(STRINGS ${header} lines REGEX "^#define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]+")
        list(TRANSFORM lines REPLACE ".* ([0-9]+).*" "\\1")
        list(APPEND CHOLMOD_VERSION ${lines})
    endforeach()
    list(JOIN CHOLMOD_VERSION "." CHOLMOD_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR OPENBLAS_LIBRARY
                                                GOMP_LIBRARY
                                          VERSION_VAR CHOLMOD_VERSION)
if(CHOLMOD_FOUND AND NOT TARGET CHOLMOD::CHOLMOD)
    add_library(CHOLMOD::CHOLMOD UNKNOWN IMPORTED)
    set_target_properties(CHOLMOD::CHOLMOD PROPERTIES
                          IMPORTED_LOCATION "${CHOLMOD_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
                          INTERFACE_LINK_LIBRARIES "${OPENBLAS_LIBRARY};${GOMP_LIBRARY}")
endif()
