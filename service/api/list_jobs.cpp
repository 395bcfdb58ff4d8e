// SPDX-License-Identifier: MIT
#include "api/list_jobs.h"

#include "api/job_message.h"
#include "api/message_limits.h"

namespace slipstitch {

jobs::Outcome<v1::ListSimJobsResponse> list_jobs(const jobs::JobStore& store, const v1::ListSimJobsRequest& request) {
  const jobs::ListQuery query{request.page_size(), request.page_token(), state_from_message(request.state())};
  const jobs::Outcome<jobs::JobPage> page = store.list(query);
  if (!page) return page.error();
  v1::ListSimJobsResponse response;
  std::size_t bytes = 0;
  response.set_next_page_token(page->next_page_token);
  for (const jobs::Job& job : page->jobs) {
    v1::SimJob message = message_from_job(job);
    bytes += message.ByteSizeLong();
    if (bytes > kMaxListBytes && response.jobs_size() > 0) {
      const std::string last = id_from_name(response.jobs(response.jobs_size() - 1).name());
      response.set_next_page_token(jobs::page_token_after(last, query));
      break;
    }
    *response.add_jobs() = std::move(message);
  }
  return response;
}

}  // namespace slipstitch
