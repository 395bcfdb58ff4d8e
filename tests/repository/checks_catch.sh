#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plants one violation after another in an otherwise clean tree; the checks must name each of them.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failed=0

clean_tree() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{core/math,core/sim,core/extra,service/{run_dir,jobs,api,rest,worker,platform},clients/cli,tests/unit}
  printf '// SPDX-License-Identifier: MIT\n#pragma once\n#include <vector>\n' >"$tree/core/math/types.h"
  printf '// SPDX-License-Identifier: MIT\n#include "math/types.h"\n#include "sim/run.h"\n' >"$tree/core/sim/run.cpp"
  printf 'project(example)\n' >"$tree/CMakeLists.txt"
}

catches() {  # CHECK EXPECTED-MESSAGE FILE LINE...
  local check=$1 expected=$2 file=$3 output status=0
  clean_tree
  if [[ ! -e $tree/$file && $file == *.@(h|cpp) && $expected != *SPDX* && $expected != *pragma* ]]; then
    printf '// SPDX-License-Identifier: MIT\n#pragma once\n' >"$tree/$file"
  fi
  printf '%s\n' "${@:4}" >>"$tree/$file"
  output=$("$here/$check" "$tree" 2>&1) || status=$?
  if ((status == 0)) || [[ $output != *"$file"*"$expected"* ]]; then
    printf '%s did not catch %s in %s: %s\n' "$check" "${*:4:1}" "$file" "$output"
    failed=1
  fi
}

clean_tree
"$here/check_layers.sh" "$tree" && "$here/check_text.sh" "$tree" || failed=1

layers() { catches check_layers.sh "$@"; }
layers 'math may not include sim' core/math/types.h '#include "sim/run.h"'
layers 'math may not include sim' core/math/types.h '  #  include "sim/run.h"'
layers 'sim may not include <nlohmann/json.hpp>' core/sim/run.cpp '#include <nlohmann/json.hpp>'
layers 'sim may not include <fstream>' core/sim/run.cpp '#include <fstream>'
layers 'sim may not include run_dir' core/sim/run.cpp '#include "run_dir/run_dir.h"'
layers 'sim may not include proto' core/sim/run.cpp '#include "slipstitch/v1/scene.pb.h"'
layers 'run_dir may not include <grpcpp/grpcpp.h>' service/run_dir/a.cpp '#include <grpcpp/grpcpp.h>'
layers 'jobs may not include stubs' service/jobs/a.h '#include "slipstitch/v1/job.grpc.pb.h"'
layers 'jobs may not include grpc' service/jobs/a.h '#include "grpc/status.h"'
layers 'rest may not include grpc' service/rest/a.cpp '#include "grpc/status.h"'
layers 'api may not include <grpcpp/grpcpp.h>' service/api/a.h '#include <grpcpp/grpcpp.h>'
layers 'worker may not include grpc' service/worker/a.cpp '#include "grpc/status.h"'
layers 'platform may not include sim' service/platform/a.cpp '#include "sim/run.h"'
layers 'cli may not include worker' clients/cli/a.cpp '#include "worker/run_worker.h"'
layers 'relative path' core/sim/run.cpp '#include "../math/types.h"'
layers 'write the folder' core/sim/run.cpp '#include "run.h"'
layers 'folder extra is not in the table' core/extra/a.cpp '#include <vector>'
layers 'without a plain file name' core/sim/run.cpp '#include HEADER'

text() { catches check_text.sh "$@"; }
text 'reordered arithmetic' CMakeLists.txt 'add_compile_options(-ffast-math)'
text 'no test is skipped' tests/unit/a.cpp 'GTEST_SKIP() << "slow";'
text 'no test is skipped' tests/unit/a.cpp 'TEST(Solver, DISABLED_Converges) {}'
text 'belongs in the tracker' core/sim/run.cpp '// TODO: friction'
text 'path of one machine' README.md 'see /work/notes.md'
text 'path of one machine' CMakeLists.txt 'set(X "/home/me/lib")'
text 'outside the repository' README.md 'see ../shared/architecture.md'
text 'mutable state' core/sim/run.cpp 'static int counter = 0;'
text 'every name of a library' core/math/types.h 'using namespace std;'
text 'not the SPDX line' core/sim/b.h '#pragma once'
text 'no #pragma once' core/math/b.h '// SPDX-License-Identifier: MIT'
text 'its own header comes first' core/math/types.cpp '#include <vector>' '#include "math/types.h"'
text 'snake_case' core/sim/RunLoop.cpp 'int x();'
text 'snake_case' tests/unit/jobList.ts '// SPDX-License-Identifier: MIT'
text 'not the SPDX line' tests/unit/a.mjs 'export {};'
text 'no test is skipped' tests/unit/a.test.ts '// SPDX-License-Identifier: MIT' "it.skip('draws', () => {});"
text '800 is the limit' core/sim/run.cpp "$(seq -f '// line %g' 900)"

for check in check_layers.sh check_text.sh; do
  rm -rf "${tree:?}"/*
  if "$here/$check" "$tree" >/dev/null 2>&1; then
    echo "$check passes on an empty folder"
    failed=1
  fi
done
exit "$failed"
