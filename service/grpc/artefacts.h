// SPDX-License-Identifier: MIT
#pragma once

#include "api/job_message.h"
#include "grpc/stream_reactor.h"

namespace slipstitch {

/// Started; owns itself.
grpc::ServerWriteReactor<v1::ArtefactChunk>* stream_artefact(jobs::JobStore& store, const ArtefactName& name,
                                                             StreamOptions options);

}  // namespace slipstitch
