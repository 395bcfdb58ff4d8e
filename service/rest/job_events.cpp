// SPDX-License-Identifier: MIT
#include "rest/job_events.h"

#include "api/job_message.h"
#include "rest/api_json.h"

namespace slipstitch::rest {

Piece JobEvents::next() {
  const jobs::Outcome<jobs::Job> job = store_.get(id_);
  if (!job || store_.stopping()) return {"", Piece::Then::broken};
  Piece piece;
  if (job->revision != last_seen_) {
    piece.bytes =
        "event: job\nid: " + std::to_string(job->revision) + "\ndata: " + api_json(message_from_job(*job)) + "\n\n";
    last_seen_ = job->revision;
  }
  if (jobs::is_terminal(job->state)) {
    piece.bytes += "event: end\ndata: {}\n\n";
    return piece;
  }
  piece.then = Piece::Then::wait;
  return piece;
}

}  // namespace slipstitch::rest
