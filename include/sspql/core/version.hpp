// SPDX-License-Identifier: MIT
#pragma once

/// The library's version; CMakeLists.txt reads it from here, so it is written once.
#define SSPQL_VERSION_MAJOR 0
#define SSPQL_VERSION_MINOR 1
#define SSPQL_VERSION_PATCH 0

#define SSPQL_VERSION_STRINGIZE_(x) #x
#define SSPQL_VERSION_STRINGIZE(x) SSPQL_VERSION_STRINGIZE_(x)
#define SSPQL_VERSION                                  \
    SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_MAJOR)       \
    "." SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_MINOR) "." SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_PATCH)
