// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/remote/connection.h"
#include "cli/remote/read_stream.h"

namespace slipstitch {

inline bool has_ended(v1::SimJob::State state) {
  return state == v1::SimJob::SUCCEEDED || state == v1::SimJob::FAILED || state == v1::SimJob::CANCELLED;
}

/// Hands every snapshot of the job to `on_job` until one shows its end, which is returned. A stream that breaks after
/// its first message is opened again a few times; `on_break` hears of each break. No value and no error code: stopped.
Reply<v1::SimJob> watch_job(const Connection& connection, const std::string& name, const StopTest& should_stop,
                            const std::function<void(const v1::SimJob&)>& on_job,
                            const std::function<void(const RemoteError&)>& on_break);

}  // namespace slipstitch
