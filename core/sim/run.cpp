// SPDX-License-Identifier: MIT
#include "sim/run.h"
