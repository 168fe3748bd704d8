# SPDX-License-Identifier: GPL-3.0-or-later
# OpenVDB's own find module, which Debian keeps where find_package does not look; in a block, since it chatters
# and turns BUILD_SHARED_LIBS on for whoever calls it.
block(PROPAGATE OpenVDB_FOUND OpenVDB_VERSION)
    set(folder /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
    list(APPEND CMAKE_MODULE_PATH ${folder}) # of its own dependencies
    set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
    include(${folder}/FindOpenVDB.cmake OPTIONAL)
endblock()
