// SPDX-License-Identifier: MIT
#include "platform/startup.h"
#include "server/serve.h"

int main(int argc, char** argv) {
  slipstitch::start_process(argv);
  return slipstitch::serve({argv + 1, argv + argc}, "slipstitchd");
}
