#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check_text.sh ROOT: house rules that a search can check. Prints every line that breaks one.
set -euo pipefail
cd -- "$1"
failed=0

files() {  # PATTERN...; files of the repository whose names match one
  local pattern names=()
  for pattern in "$@"; do names+=(-o -name "$pattern"); done
  find . \( -path ./.git -o -path './build*' -o -name node_modules \) -prune -o -type f \( "${names[@]:1}" \) -printf '%P\n' | sort
}
scripts=('*.ts' '*.mjs' '*.css')  # of the viewer
sources=('*.h' '*.cpp' '*.proto' CMakeLists.txt '*.cmake' '*.sh' run "${scripts[@]}")
texts=("${sources[@]}" '*.md' '*.json' '*.csv' '*.txt' '.clang-*' '.gitignore')

forbid() {  # WHY REGEX PATTERN...; the scripts beside this one hold the words and are left out
  local why=$1 regex=$2 hits
  shift 2
  hits=$(files "$@" | grep -v "^tests/repository/.*\.sh$" | xargs -r grep -nE -e "$regex" /dev/null) || return 0
  printf '%s\n' "$hits" | sed "s|\$|    <- $why|"
  failed=1
}

forbid 'results must not depend on reordered arithmetic' '-ffast-math|-Ofast|-funsafe-math|-fassociative-math' \
  "${sources[@]}" CMakePresets.json
forbid 'no test is skipped' 'GTEST_SKIP|\b(it|test|describe)\.(skip|todo|only)\b|skip: true|TEST(_F|_P)?\([A-Za-z0-9_]*, *DISABLED_|\bDISABLED_[A-Z]|DISABLED (TRUE|ON)|SKIP_RETURN_CODE' \
  "${sources[@]}"
forbid 'unfinished work belongs in the tracker' '\b(TODO|FIXME|XXX|HACK)\b' "${sources[@]}"
forbid 'a path of one machine' '(^|[^A-Za-z0-9_.-])/(work|home|root|Users|mnt)/' "${texts[@]}"
forbid 'a path outside the repository' '\.\./(shared|\.library)\b|\.library/' "${texts[@]}"
forbid 'mutable state for the whole process' '^(static|inline|thread_local) (thread_local )?[A-Za-z_:<>]+ [a-z_]+( =.*|\{.*)?;' \
  '*.h' '*.cpp'
forbid 'names every name of a library' '^using namespace ' '*.h'

while read -r file; do
  first=$(head -n 1 "$file")
  [[ $first == '// SPDX-License-Identifier: MIT' ]] || { echo "$file:1: the first line is not the SPDX line"; failed=1; }
  if [[ $file == *.h ]] && ! grep -qx '#pragma once' "$file"; then
    echo "$file: no #pragma once"
    failed=1
  fi
  [[ ${file##*/} =~ ^[a-z0-9_]+\.(h|cpp)$ ]] || { echo "$file: a file name is snake_case"; failed=1; }
done < <(files '*.h' '*.cpp')

while read -r file; do
  first=$(head -n 1 "$file")
  [[ $first == '// SPDX-License-Identifier: MIT' ]] || { echo "$file:1: the first line is not the SPDX line"; failed=1; }
  [[ ${file##*/} =~ ^[a-z0-9_]+(\.(test|config))?\.(ts|mjs)$ ]] || { echo "$file: a file name is snake_case"; failed=1; }
done < <(files '*.ts' '*.mjs')

# So every header with a source of its own is compiled alone; CMakeLists.txt here compiles the rest of the core's.
while read -r file; do
  header=${file%.cpp}.h
  [[ -e $header ]] || continue
  include=$(grep -m 1 '^#include' "$file" || true)
  [[ $include == "#include \"${header#*/}\"" ]] || { echo "$file: its own header comes first"; failed=1; }
done < <(files '*.cpp' | grep -E '^(core|service|clients)/')

while read -r file; do
  lines=$(wc -l <"$file")
  ((lines <= 800)) || { echo "$file: $lines lines; 800 is the limit"; failed=1; }
done < <(files "${sources[@]}")

count=$(files "${sources[@]}" | wc -l)
((count > 0)) || { echo 'no source found: is this the root of the repository?'; exit 1; }
((failed)) || echo "$count files keep the rules"
exit "$failed"
