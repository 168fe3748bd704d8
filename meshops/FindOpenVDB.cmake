# SPDX-License-Identifier: GPL-3.0-or-later
# Includes OpenVDB's own find module, which Debian keeps where find_package does not look; in a block, since the module
# prints messages and turns BUILD_SHARED_LIBS on in the caller's scope.
block(PROPAGATE OpenVDB_FOUND OpenVDB_VERSION)
    set(folder /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
    list(APPEND CMAKE_MODULE_PATH ${folder}) # find modules of OpenVDB's dependencies
    set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
    include(${folder}/FindOpenVDB.cmake OPTIONAL)
endblock()
