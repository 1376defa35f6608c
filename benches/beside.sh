#!/bin/sh
# How fast is carom beside the fastest published C code? Reads the folder `Cell` of github.com/FSmallenburg/EDMD
# (arXiv:2201.01100), which is built with its stock flags; runs both in turn, writes a table of collisions a second.
#
# Usage: benches/beside.sh FOLDER [TURNS [CASE...]]
#
# Both are timed by user CPU time on one core. Of the C code a run that ends at once is taken off, for its start;
# carom's bench leaves its own start out. The C code starts from a crystal, as carom's cases do.
set -eu
source=${1:?"usage: benches/beside.sh FOLDER [TURNS [CASE...]]"}
turns=${2:-5}
[ $# -gt 2 ] && shift 2 || set -- hs3d-1372 hs3d-13500 hs3d-108000 hs3d-dilute
[ -f "$source/mdCell.c" ] || { echo "beside.sh: no mdCell.c in $source" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
cargo build --release --quiet -p carom-host

# The C code keeps its parameters in its source: N, packing fraction and how long it simulates.
build() { # name N packing time cells
  mkdir -p "$work/$1"
  cp "$source"/*.c "$source"/*.h "$source/Makefile" "$work/$1/"
  sed -i -e "s/^double maxtime = .*/double maxtime = $4;/" \
    -e "s/^double writeinterval = .*/double writeinterval = $4 * 0.99999;/" \
    -e "s/^double snapshotinterval = .*/double snapshotinterval = 1e9;/" \
    -e "s/^int initialconfig = .*/int initialconfig = 1;/" -e "s/^double packfrac = .*/double packfrac = $3;/" \
    -e "s/^int N = .*/int N = $2;/" -e "s/^#define MAXCEL .*/#define MAXCEL $5/" "$work/$1/mdCell.c"
  make -s -C "$work/$1" md >"$work/make.log" 2>&1 || { cat "$work/make.log" >&2; exit 1; }
}

prepare() { # case
  case $1 in
    hs3d-1372) set -- "$1" 1372 0.2617993878 200 75 ;;
    hs3d-13500) set -- "$1" 13500 0.2617993878 20 75 ;;
    hs3d-108000) set -- "$1" 108000 0.2617993878 4 75 ;;
    hs3d-1000000) set -- "$1" 1000188 0.2617993878 1 130 ;;
    hs3d-dilute) set -- "$1" 13500 0.01 500 75 ;;
    hs3d-dilute-0.001) set -- "$1" 13500 0.001 1000 75 ;;
    *) echo "beside.sh: $1 is none of hs3d-1372, -13500, -108000, -1000000, -dilute, -dilute-0.001" >&2; exit 1 ;;
  esac
  build "$1" "$2" "$3" "$4" "$5"
  build "$1.start" "$2" "$3" 1e-9 "$5"
}

seconds() { # program: user seconds of its run; what it prints goes to $work/out
  (cd "$(dirname "$1")" && bash -c 'TIMEFORMAT=%U; time "$0" >"$1"' "$1" "$work/out" 2>&1)
}

theirs() { # case
  start=$(seconds "$work/$1.start/md")
  all=$(seconds "$work/$1/md")
  collisions=$(sed -n 's/.*Collisions: \([0-9]*\).*/\1/p' "$work/out" | tail -1)
  echo "$collisions $all $start" | awk '{ printf "%.0f\n", $1 / ($2 - $3) }'
}

ours() { # case
  target/release/carom bench "$1" --json | sed -n 's/.*"collisions_per_s": \([0-9]*\).*/\1/p'
}

median() { sort -n | awk '{ x[NR] = $1 } END { print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'; }

echo "| case | carom | C code | ratio |"
echo "|---|---|---|---|"
for case in "$@"; do
  prepare "$case"
  for _ in $(seq "$turns"); do
    mine=$(ours "$case")
    other=$(theirs "$case")
    echo "$mine" >>"$work/$case.ours"
    echo "$other" >>"$work/$case.theirs"
    echo "$mine $other" | awk '{ print $1 / $2 }' >>"$work/$case.ratio"
  done
  printf '| %s | %.0f k | %.0f k | %.2f |\n' "$case" "$(median <"$work/$case.ours" | awk '{ print $1 / 1000 }')" \
    "$(median <"$work/$case.theirs" | awk '{ print $1 / 1000 }')" "$(median <"$work/$case.ratio")"
done
