// SPDX-License-Identifier: MIT
#pragma once

#include "grpc/job_message.h"
#include "grpc/stream_reactor.h"

namespace slipstitch {

/// scene.json and the files in report/, by name.
v1::ListArtefactsResponse artefacts_of(const std::string& id, const RunDir& dir);

/// Started; owns itself.
grpc::ServerWriteReactor<v1::ArtefactChunk>* stream_artefact(jobs::JobStore& store, const ArtefactName& name,
                                                             StreamOptions options);

}  // namespace slipstitch
