#!/usr/bin/env bash
# How long are the longest step and the longest frame? Reads what the images `frames` and, of 32 beads, `measure` have
# written (TARGET.frames and TARGET.measured in the folder given, see ../check.sh); writes the table of docs/guide/firmware.md. Instructions; a share is that of frames.rs.
set -euo pipefail
folder=$1
echo "| scene | target | N | longest event | longest change of gravity | longest frame | mean frame | longest frame with a share | frames of 56 that go slower |"
echo "|---|---|---|---|---|---|---|---|---|"
beads() { # file of measure, table
  awk -v table="$2" '
    { value[$1] = $2 }
    function of(what) { return value[table "." what] }
    END { print "beads", 32, of("step"), of("turn"), of("frame"), int(of("all") / 56), of("share.frame"), of("share.late") }' "$1"
}
table() { # target, its name, the table of its tilt box
  [[ -e $folder/$1.frames && -e $folder/$1.measured ]] || return 0
  { cat "$folder/$1.frames" && beads "$folder/$1.measured" "$3"; } | awk -v name="$2" '
    function thousands(number, out) { out = ""; while (length(number) > 3) { out = "," substr(number, length(number) - 2) out; number = substr(number, 1, length(number) - 3) } return number out }
    $1 == "heap" || $1 == "beads" {
      scene = $1 == "heap" ? "hard disks, default mode" : "glass beads, papers\047 mode"
      line = "| " scene " | " name " | " $2
      for (i = 3; i <= NF; i++) line = line " | " thousands($i)
      print line " |"
    }'
}
table thumbv7em-none-eabihf M4F standard
table thumbv6m-none-eabi M0 compact
table riscv32imc-unknown-none-elf RV32IMC compact
