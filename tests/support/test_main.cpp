// SPDX-License-Identifier: MIT
// main of every test program: like the programs themselves it runs BLAS with the kernels that fit the CPU.
#include <gtest/gtest.h>

#include "platform/startup.h"

int main(int argc, char** argv) {
  slipstitch::start_process(argv);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
