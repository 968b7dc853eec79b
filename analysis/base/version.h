// The version of the library and of the program. CMake and the Python package read it here.
#pragma once

#define STICKSLIP_VERSION_MAJOR 0
#define STICKSLIP_VERSION_MINOR 2
#define STICKSLIP_VERSION_PATCH 0
#define STICKSLIP_VERSION "0.2.0"
/// For comparisons: 10000 · major + 100 · minor + patch.
#define STICKSLIP_VERSION_NUMBER \
    (10000 * STICKSLIP_VERSION_MAJOR + 100 * STICKSLIP_VERSION_MINOR + STICKSLIP_VERSION_PATCH)
