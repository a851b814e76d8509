// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library's version; CMakeLists.txt reads it from here, so it is written once.

/// Grows with what old programs cannot live with. \ingroup core
#define SSPQL_VERSION_MAJOR 0
/// Grows with what is new; while the major version is 0, with what old programs cannot live with, too. \ingroup core
#define SSPQL_VERSION_MINOR 1
/// Grows with what was mended. \ingroup core
#define SSPQL_VERSION_PATCH 0

/// \cond
#define SSPQL_VERSION_STRINGIZE_(x) #x
#define SSPQL_VERSION_STRINGIZE(x) SSPQL_VERSION_STRINGIZE_(x)
/// \endcond
/// The version as text, "0.1.0". \ingroup core
#define SSPQL_VERSION                                  \
    SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_MAJOR)       \
    "." SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_MINOR) "." SSPQL_VERSION_STRINGIZE(SSPQL_VERSION_PATCH)
