# SPDX-License-Identifier: MIT
# sspql_dev: the flags of our own programs, tests and examples. Nothing of it reaches a user of the library.

add_library(sspql_dev INTERFACE)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  # No contraction into fused multiply-add: the same seeds give the same bits with every compiler.
  target_compile_options(sspql_dev INTERFACE -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off)
endif()
target_compile_definitions(sspql_dev INTERFACE EIGEN_MPL2_ONLY)
