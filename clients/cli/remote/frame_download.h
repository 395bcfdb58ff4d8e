// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/remote/connection.h"
#include "cli/remote/read_stream.h"
#include "sim/frame.h"

namespace slipstitch {

struct FrameQuery {
  std::string name;  // simJobs/{id}
  std::uint32_t first = 0, stride = 1;
  std::optional<std::uint32_t> end;  // first frame not wanted
  bool follow = false;
};

struct FrameSink {
  std::function<std::string(const FrameHeader&)> header;  // once, even if the stream had to be opened again
  std::function<std::string(const Frame&)> frame;         // in ascending order, each once
  std::function<void(const RemoteError&)> broken;         // before the stream is opened again
};

/// How a download ended; exactly one of the first three, or none of them when it was stopped.
struct FrameDownload {
  std::optional<v1::StreamEnd> end;  // complete
  std::optional<RemoteError> error;  // the server refused, or the stream stayed broken
  std::string sink_error;            // what the sink returned
};

/// Reads frames; a stream that breaks, also one that ends without its end marker, is opened again a few times where it
/// broke.
FrameDownload download_frames(const Connection& connection, const FrameQuery& query, const StopTest& should_stop,
                              const FrameSink& sink);

}  // namespace slipstitch
