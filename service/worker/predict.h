// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// Reads a serialized Scene from standard input, writes a serialized Prediction to standard output: nothing, if there
/// is none. Takes a few seconds of processor time and a GiB of memory at most, and is ended by the system beyond that.
/// Exit code.
int predict_for_server();

}  // namespace slipstitch
