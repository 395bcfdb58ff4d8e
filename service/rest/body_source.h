// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch::rest {

/// A part of a body, and how it goes on.
struct Piece {
  enum class Then {
    more,    // ask again when this is written
    wait,    // nothing more now: ask again when the job has changed
    end,     // that was the body
    broken,  // no more can be had: the connection is cut, so that the client sees that it is not the end
  };
  std::string bytes;
  Then then = Then::end;
};

/// A body that is made while it is sent. Called by one thread at a time; the next piece is made when the last one is
/// written, so a slow client costs one piece.
class BodySource {
 public:
  virtual ~BodySource() = default;

  virtual Piece next() = 0;

  /// Sent when there was nothing else for a while.
  virtual std::string keep_alive() const { return {}; }

  /// The job whose changes wake one that waits.
  virtual std::string job() const { return {}; }
};

}  // namespace slipstitch::rest
