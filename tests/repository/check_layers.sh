#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check_layers.sh ROOT: every #include under core, service and clients must follow the table. Prints each that does not.
set -euo pipefail
cd -- "$1"

# Folder: the folders of ours that it may include besides itself.
read -r -d '' table <<'TABLE' || true
math:
solve: math
model: math solve
collide: math solve model
force: math solve model collide
sim: math solve model collide force
study: math solve model collide force sim
platform:
scene_io: CORE proto
formats: CORE
report: CORE
run_dir: CORE scene_io formats platform
studies: CORE report run_dir
prediction: CORE run_dir platform
jobs: CORE scene_io formats run_dir platform
api: CORE scene_io formats run_dir platform jobs proto
grpc: CORE scene_io formats run_dir platform jobs api proto stubs
rest: CORE scene_io formats run_dir platform jobs api proto
worker: CORE report scene_io formats run_dir studies prediction platform jobs proto
server: CORE scene_io formats run_dir platform jobs api grpc rest worker proto stubs
cli: CORE report scene_io formats run_dir studies prediction platform jobs grpc server proto stubs
TABLE
core='math solve model collide force sim study'

# Headers of others that stop somewhere: the pattern, and the folders that may use it (core does no I/O either).
read -r -d '' foreign <<'FOREIGN' || true
^(grpc|grpcpp)/ grpc server cli
^google/protobuf/ scene_io api grpc rest worker server cli
^nlohmann/ scene_io formats run_dir studies prediction jobs api grpc rest worker server cli
^(fstream|iostream|filesystem|unistd\.h|fcntl\.h)$ platform scene_io formats run_dir studies prediction jobs api grpc rest worker server cli
FOREIGN

find core service clients -name '*.h' -o -name '*.cpp' 2>/dev/null | sort |
  xargs -r grep -nE '^[[:space:]]*#[[:space:]]*include' /dev/null |
  awk -v table="$table" -v core="$core" -v foreign="$foreign" '
    BEGIN {
      count = split(table, lines, "\n")
      for (i = 1; i <= count; i++) {
        split(lines[i], part, ":")
        gsub("CORE", core, part[2])
        allowed[part[1]] = " " part[1] " " part[2] " "
      }
      foreign_count = split(foreign, foreign_lines, "\n")
    }
    function complain(text) { print file ":" line ": " text; bad = 1 }
    {
      match($0, /^[^:]*:[0-9]+:/)
      split(substr($0, 1, RLENGTH), place, ":")
      file = place[1]; line = place[2]
      split(file, path, "/")
      folder = path[2]
      directive = substr($0, RLENGTH + 1)
      if (!match(directive, /["<][^">]*[">]/)) { complain("an #include without a plain file name"); next }
      quoted = substr(directive, RSTART, 1) == "\""
      header = substr(directive, RSTART + 1, RLENGTH - 2)
      seen++
      if (!(folder in allowed)) { complain("folder " folder " is not in the table"); next }
      if (header ~ /(^|\/)\.\.?\//) { complain("relative path " header); next }

      split(header, target, "/")
      to = target[1]
      if (header ~ /\.grpc\.pb\.h$/) to = "stubs"
      else if (header ~ /\.pb\.h$/) to = header ~ /^google\/protobuf\// ? to : "proto"
      if (quoted && index(header, "/") == 0) complain("write the folder: \"" folder "/" header "\"")
      if ((to in allowed || to == "proto" || to == "stubs") && (quoted || to == "proto" || to == "stubs") &&
          index(allowed[folder], " " to " ") == 0)
        complain(folder " may not include " to " (" header ")")
      for (i = 1; i <= foreign_count; i++) {
        words = split(foreign_lines[i], word, " ")
        if (header !~ word[1]) continue
        found = 0
        for (j = 2; j <= words; j++) if (word[j] == folder) found = 1
        if (!found) complain(folder " may not include <" header ">")
      }
    }
    END {
      if (!seen) { print "no #include found: is this the root of the repository?"; exit 1 }
      if (bad) exit 1
      print seen " includes follow the table"
    }'
