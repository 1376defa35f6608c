#!/usr/bin/env bash
# Does carom compute the same bits on every target, within budget? Builds and runs firmware, WebAssembly and
# the host's replay; prints one table, or with --json the same as JSON; fails where a digest differs or a
# limit is broken. Needs a Rust toolchain; installs the rest with apt-get where it is missing (as root, Debian 12).
# Instructions are counted by QEMU (-icount shift=0): instructions, not cycles.
# CAROM_SECONDS says how long it may take: on a machine too busy for that the last parts are left out, and named at the end.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TERM_COLOR=never CARGO_INCREMENTAL=0
json=false
[[ ${1:-} == --json ]] && json=true
say() { printf '%s\n' "$*" >&2; }

out=$PWD/firmware/target
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$out}
work=$(mktemp -d)
golden=$PWD/../tests/bits/golden.txt
events=10000
failed=0
left_out=()
# Does a part of the checks, if there is time for it.
part() { # what, seconds that it takes on a slow machine, command
  if ((SECONDS + $2 > ${CAROM_SECONDS:-1000000})); then
    left_out+=("$1")
    say "NOT RUN, there is no time left: $1 ($SECONDS s)"
    return
  fi
  say "$1 ($SECONDS s)"
  "${@:3}"
}
# Boards run beside what is being built, each job in a process group of its own.
jobs=()
finish() {
  for job in "${jobs[@]}"; do kill -- "-$job" 2>/dev/null || true; done
  rm -rf "$work"
}
trap finish EXIT

need() { # command, Debian package
  command -v "$1" >/dev/null || missing+=("$2")
}
installed=$(rustup target list --installed 2>/dev/null || true)
missing=()
need qemu-system-arm qemu-system-arm
need qemu-system-riscv32 qemu-system-misc
need node nodejs
need nm binutils
need c++ g++
need arm-none-eabi-g++ gcc-arm-none-eabi
need python3 python3
need parallel parallel
python3 -c "import ensurepip, venv" 2>/dev/null || missing+=(python3-venv)
[[ -d /usr/lib/arm-none-eabi/include ]] || missing+=(libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib)
for target in thumbv7em-none-eabihf thumbv6m-none-eabi riscv32imc-unknown-none-elf wasm32-unknown-unknown; do
  [[ $installed == *"$target"* ]] || debian=true
done
if [[ ${debian:-false} == true ]]; then
  for package in rustc-web cargo-web rust-web-src; do
    dpkg -s "$package" >/dev/null 2>&1 || missing+=("$package")
  done
fi
# The oldest toolchain that carom promises. Debian's is unpacked into a folder: a newer one is installed.
oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' ../Cargo.toml)
toolchains=$(rustup toolchain list 2>/dev/null || true)
if [[ $toolchains != *"$oldest"* ]]; then
  for package in libllvm19 libpcre3 libhttp-parser2.9 libssh2-1; do
    dpkg -s "$package" >/dev/null 2>&1 || missing+=("$package")
  done
fi
if ((${#missing[@]})); then
  say "installing ${missing[*]}"
  { apt-get update -qq && apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >&2
fi

# Builds for a target: an installed one, or core from Debian's source of it.
build() { # directory, target, arguments of cargo
  local directory=$1 target=$2
  shift 2
  say "building $directory for $target ${*} ($SECONDS s)"
  if [[ $installed == *"$target"* ]]; then
    (cd "$directory" && cargo build --quiet --release --locked --target "$target" "$@")
    return
  fi
  local std=core
  [[ $target == wasm32* ]] && std=core,panic_abort
  (
    cd "$directory"
    PATH=$(rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin:$PATH
    RUSTC=$(dpkg -L rustc-web | grep 'bin/rustc$' | head -1) RUSTC_BOOTSTRAP=1
    export PATH RUSTC RUSTC_BOOTSTRAP
    "$(dpkg -L cargo-web | grep 'bin/cargo$' | head -1)" build --quiet --release --locked \
      -Zbuild-std=$std --target "$target" "$@"
  )
}

unpack_oldest() { # folder
  [[ ! -d $1 ]] || return 0
  local version
  version=$(apt-cache madison rustc-web | awk -v v="$oldest." 'index($3, v) == 1 { print $3; exit }')
  [[ -n $version ]] || { say "neither rustup nor Debian has Rust $oldest: rustup toolchain install $oldest" && return 1; }
  say "unpacking Rust $oldest ($SECONDS s)"
  mkdir -p "$work/oldest" "$1.new"
  (cd "$work/oldest" && apt-get download -qq {rustc-web,cargo-web,libstd-rust-web-dev,libstd-rust-web-"$oldest"}="$version") >&2
  for package in "$work"/oldest/*.deb; do dpkg-deb -x "$package" "$1.new"; done
  mv "$1.new" "$1"
}

# The host's replay by the oldest toolchain, not optimised, with the packages that scenes/Cargo.lock names.
replay_by_oldest() { # file of digests
  local cargo=(cargo "+$oldest") root=$out/rust-$oldest
  (
    export CARGO_TARGET_DIR=$CARGO_TARGET_DIR/oldest
    if [[ $toolchains != *"$oldest"* ]]; then
      unpack_oldest "$root" || exit 1
      cargo=("$root/usr/bin/cargo")
      export RUSTC=$root/usr/bin/rustc LD_LIBRARY_PATH=$root/usr/lib/x86_64-linux-gnu
    fi
    say "building the replay with Rust $oldest ($SECONDS s)"
    "${cargo[@]}" run --quiet --locked --manifest-path scenes/Cargo.toml --example replay -- $events >"$1"
  )
}

# Runs an image on its board; with COUNT=1 one instruction is one virtual nanosecond.
board() { # target, image, words of its command line
  local target=$1 image=$2 semihosting=enable=on,target=native count=()
  shift 2
  for word in "$@"; do semihosting+=",arg=$word"; done
  [[ ${COUNT:-0} == 1 ]] && count=(-icount shift=0,sleep=off)
  case $target:$image in
    thumbv7em*) set -- qemu-system-arm -M mps2-an386 -cpu cortex-m4 ;;
    # A Cortex-M3 runs the code of an M0, to the same instruction. A micro:bit holds the tilt box and no more.
    thumbv6m*/tilt_box) set -- qemu-system-arm -M microbit ;;
    thumbv6m*) set -- qemu-system-arm -M mps2-an385 -cpu cortex-m3 ;;
    riscv32*) set -- qemu-system-riscv32 -M virt -bios none ;;
  esac
  timeout --foreground 3600 "$@" -nographic "${count[@]}" -semihosting-config "$semihosting" -kernel "$image" </dev/null
}

# Compares a replay with the golden file; names the first event that differs.
compare() { # target, file of digests, replay command that takes: scene scalar from last
  local target=$1 file=$2 last=$events
  shift 2
  [[ $target != thumbv6m* ]] || last=5000 # as firmware/replay.rs
  sort "$file" >"$file.got"
  awk -v last=$last '$3 <= last' "$golden" | sort >"$file.wanted"
  if cmp -s "$file.got" "$file.wanted"; then echo true && return; fi
  echo false
  local first scene scalar
  first=$(comm -13 "$file.got" "$file.wanted" | sort -k1,2 -k3,3n | head -1)
  read -r scene scalar last _ <<<"$first"
  say "$target: $scene in $scalar differs between events $((last - 1000)) and $last"
  "$@" "$scene" "$scalar" $((last - 1000)) "$last" >"$file.there" 2>/dev/null || true
  "$host" "$scene" "$scalar" $((last - 1000)) "$last" >"$file.here"
  say "$target: the first event that differs: $(diff "$file.here" "$file.there" | sed -n 's/^[<>] //p' | head -1)"
}

flash() { size "$1" | awk 'NR == 2 { print $1 + $2 }'; }
panics() { nm "$1" | grep -c '4core9panicking' || true; }
# Bytes of the functions that write an error's letters (`Error::brief`), and symbols of the library's formatting.
brief() { nm -S -t d "$1" | awk '/7refusal5Error5brief|5error5brief5Brief/ { sum += $2 } END { print sum + 0 }'; }
texts() { nm "$1" | grep -c '4core3fmt' || true; }

# What flash is made of: bytes by crate and room, the largest first. What has no symbol are the tables' numbers.
rooms() { # image
  nm -C -S -t d "$1" | awk -v flash="$(flash "$1")" '
    $3 !~ /^[tTrRwW]$/ || /{shim/ { next }
    { size = $2 + 0; sub(/^[^ ]+ [^ ]+ . /, ""); room = "others" }
    /^<?carom_scenes::|main$/ { room = "program" }
    room == "others" && /carom_tables::/ { room = "carom_tables" }
    room == "others" && match($0, /carom::[a-z]+/) { room = substr($0, RSTART, RLENGTH) }
    { sum[room] += size; all += size }
    END { for (room in sum) print sum[room], room; print flash - all, "without a symbol" }' |
    sort -rn | awk '{ printf "%s%s", (NR > 1 ? ", " : ""), $0 } END { print "" }'
}

# One line of the table.
row() { # target digests flash ram instructions md panics stack lookup
  echo "$*" >"$work/row.$1"
  [[ $2 == true ]] || failed=1
}
limit() { # target what value limit budget
  local note=""
  (($4 == $5)) || note=" (the budget is $5: see firmware/README.md)"
  if [[ $3 == null ]] || (($3 > $4)); then
    say "$1: $2 is $3, more than $4$note" && failed=1
  elif [[ -n $note ]]; then
    say "$1: $2 is $3, within $4$note"
  fi
}
share() { if [[ $1 == null || ${2/null/0} == 0 ]]; then echo null; else echo $(($1 / $2)); fi; }

say "the host's replay ($SECONDS s)"
cargo build --quiet --release --manifest-path scenes/Cargo.toml --example replay --locked
host=$CARGO_TARGET_DIR/release/examples/replay
"$host" $events >"$work/host"
row x86_64-release "$(compare "x86_64" "$work/host" "$host")" null null null null null null null

# Runs what has been built for a board; writes its row, and fails where something is wrong.
run() { # target table-of-the-tilt-box
  local target=$1 table=$2 image=$CARGO_TARGET_DIR/$1/release begun=$SECONDS digests
  local measured=$CARGO_TARGET_DIR/$target.measured tilt=$CARGO_TARGET_DIR/$target.tilt
  failed=0
  board "$target" "$image/replay" >"$work/$target" || say "$target: the replay failed"
  replayed() { board "$target" "$image/replay" replay "$@"; }
  digests=$(compare "$target" "$work/$target" replayed)
  COUNT=1 board "$target" "$image/measure" >"$measured" || say "$target: measure failed"
  value() { awk -v what="$1" '$1 == what { v = $2 } END { print v == "" ? "null" : v }' "$measured"; }
  # Without counting it sleeps in real time where it is ahead, and is much faster where it is not.
  local count=1
  [[ $target == thumbv6m* ]] && count=0
  COUNT=$count board "$target" "$image/tilt_box" >"$tilt" 2>&1 || say "$target: the tilt box failed"
  if [[ $(tail -1 "$tilt") != "$(value "$table.events.digest")" ]]; then
    say "$target: the tilt box that sleeps ends elsewhere than the one that is measured" && failed=1
  fi
  local collisions
  collisions=$(value "$table.collisions")
  row "$target" "$digests" "$(flash "$image/tilt_box")" $(($(value memory) + $(value world))) \
    "$(share "$(value "$table.instructions")" "$collisions")" "$(share "$(value md)" "$collisions")" \
    "$(panics "$image/tilt_box")" "$(value "$table.stack")" "$(value "$table.lookup")"
  say "$target: flash of the tilt box: $(rooms "$image/tilt_box"); RAM: Memory $(value memory), World $(value world)"
  limit "$target" "contacts outside the table" "$(value "$table.outside")" 0 0
  COUNT=1 board "$target" "$image/frames" >"$CARGO_TARGET_DIR/$target.frames" || { say "$target: frames failed" && failed=1; }
  if grep ' E[0-9]' "$CARGO_TARGET_DIR/$target.frames" >&2; then say "$target: frames ended with an error" && failed=1; fi
  # Programs of least size: whether they do what they should.
  for least in smallest smallest_heap; do
    [[ ! -e $image/$least ]] || board "$target" "$image/$least" || { say "$target: $least failed" && failed=1; }
  done
  # A heap that is swung and held still until all sleep: on the board that has the time.
  if [[ $target == thumbv7em* ]]; then
    COUNT=1 board "$target" "$image/heap" >"$CARGO_TARGET_DIR/$target.heap" || { say "$target: heap failed" && failed=1; }
    sed "s/^/$target: heap: /" "$CARGO_TARGET_DIR/$target.heap" >&2
    grep -q '^digest ' "$CARGO_TARGET_DIR/$target.heap" || { say "$target: the heap did not end" && failed=1; }
    # The hourglass, and the rough tilt box: what frames of 25 ms take, and how they go slower in real time.
    # (They write to standard error, as the tilt box does.)
    for box in hourglass rough_box; do
      COUNT=1 board "$target" "$image/$box" >"$CARGO_TARGET_DIR/$target.$box" 2>&1 || { say "$target: $box failed" && failed=1; }
      say "$target: $box: $(flash "$image/$box") bytes of flash, $(grep ' [0-9]' "$CARGO_TARGET_DIR/$target.$box" | paste -sd, | sed 's/,/, /g')"
    done
  fi
  say "ran $target in $((SECONDS - begun)) s"
  exit $failed
}
metal() { # directory, what run takes
  local directory=$1 target=$2
  local level=()
  # Where arithmetic is calls, code that is not inlined is smaller, and hardly slower.
  [[ $target == thumbv6m* ]] && level=(--config 'profile.release.opt-level="z"')
  # All scenes, one with a vibrating plate, one with obstacles; and what has neither; and the hourglass.
  build "$directory" "$target" --bin replay "${level[@]}"
  build "$directory" "$target" --no-default-features --bins "${level[@]}"
  [[ $target != thumbv7em* ]] || build "$directory" "$target" --no-default-features --features obstacles --bin hourglass
  set -m
  run "${@:2}" &
  set +m
  jobs+=($!)
}

# The slowest board first.
metal firmware/cortex-m thumbv6m-none-eabi compact
metal firmware/riscv riscv32imc-unknown-none-elf compact
metal firmware/cortex-m thumbv7em-none-eabihf standard

replay_by_oldest "$work/oldest.digests" || say "Rust $oldest: the replay failed"
row "x86_64-rust-$oldest" "$(compare "x86_64, Rust $oldest" "$work/oldest.digests" "$host")" \
  null null null null null null null

in_wasm() {
  build firmware/wasm wasm32-unknown-unknown
  local module=$CARGO_TARGET_DIR/wasm32-unknown-unknown/release/carom_wasm_replay.wasm
  node firmware/wasm/replay.mjs "$module" >"$work/wasm32"
  row wasm32 "$(compare wasm32 "$work/wasm32" node firmware/wasm/replay.mjs "$module")" \
    null null null null null null null
}
part "replay in WebAssembly" 400 in_wasm

# On this machine and as an Arduino sketch.
from_c() {
  build c thumbv7em-none-eabihf --lib --no-default-features
  c/test.sh "$CARGO_TARGET_DIR/thumbv7em-none-eabihf/release/libcarom_c.a" >&2 || { say "c: failed" && failed=1; }
}
part "carom from C" 500 from_c

# A wheel in an environment of its own.
from_python() {
  env -u CARGO_TARGET_DIR python/test.sh >"$work/python" 2>&1 || { tail -200 "$work/python" >&2 && failed=1; }
}
part "carom from Python" 700 from_python

# Spread over HyperQueue, which is started here, GNU parallel, and Slurm's script, by the program of that step.
sweeps() {
  local target
  target=$(env -u CARGO_TARGET_DIR cargo metadata --format-version 1 --no-deps --manifest-path ../Cargo.toml |
    sed -n 's/.*"target_directory":"\([^"]*\)".*/\1/p')
  python3 -m venv "$work/hyperqueue" &&
    "$work/hyperqueue/bin/pip" install --quiet --disable-pip-version-check hyperqueue &&
    PATH=$work/hyperqueue/bin:$PATH CAROM=$target/release/carom sweep/check.sh
}
spread() { sweeps >"$work/sweeps" 2>&1 || { cat "$work/sweeps" >&2 && failed=1; }; }
part "sweeps" 100 spread

web() { env -u CARGO_TARGET_DIR "web/$1" "${@:2}" >"$work/web" 2>&1 || { tail -200 "$work/web" >&2 && failed=1 && false; }; }
built=false
page() { web build.sh && built=true || true; }
part "building web" 600 page

. tilt-box/check.sh
on_boards() { tilt_box || { say "tilt box: it does something else in QEMU than here, or does not build" && failed=1; }; }
part "the tilt box for its boards" 700 on_boards

soft_float() {
  cargo test --quiet --release --locked --manifest-path firmware/soft-float/Cargo.toml >"$work/soft-float" 2>&1 ||
    { cat "$work/soft-float" >&2 && failed=1; }
}
part "testing soft-float" 30 soft_float

say "waiting for the boards ($SECONDS s)"
for job in "${jobs[@]}"; do wait "$job" || failed=1; done
jobs=()
# The page wants a machine that is not busy.
tested() { $built && web test.sh --built || true; }
part "testing web" 200 tested

# Longest steps and frames, as docs/guide/firmware.md has them.
firmware/frames.sh "$CARGO_TARGET_DIR" >&2

rows=()
targets=(x86_64-release "x86_64-rust-$oldest" thumbv7em-none-eabihf thumbv6m-none-eabi riscv32imc-unknown-none-elf)
[[ " ${left_out[*]} " == *WebAssembly* ]] || targets+=(wasm32)
for target in "${targets[@]}"; do
  rows+=("$(cat "$work/row.$target" 2>/dev/null || echo "$target false null null null null null null null")")
done
field() { awk -v target="$1" -v n="$2" '$1 == target { print $n }' <(printf '%s\n' "${rows[@]}"); }

# What is allowed, and what is wanted. They differ where a budget is not reached.
m4=thumbv7em-none-eabihf m0=thumbv6m-none-eabi rv=riscv32imc-unknown-none-elf
. firmware/limits.sh
for target in $m4 $m0 riscv32imc-unknown-none-elf; do
  limit "$target" "panic symbols" "$(field "$target" 7)" 0 0
done

if $json; then
  printf '%s\n' "${rows[@]}" | awk 'BEGIN { printf "[" } {
    printf "%s\n {\"target\": \"%s\", \"digests_equal\": %s, \"flash_bytes\": %s, \"ram_bytes\": %s, \"instructions_per_collision\": %s, \"instructions_per_collision_md\": %s, \"panic_symbols\": %s}", (NR > 1 ? "," : ""), $1, $2, $3, $4, $5, $6, $7
  } END { print "\n]" }'
else
  {
    echo "target digests flash RAM instr/collision by-MD panics stack lookup"
    printf '%s\n' "${rows[@]}"
  } | sed 's/null/-/g' | column -t
fi
((${#left_out[@]} == 0)) || printf 'NOT RUN for want of time: %s\n' "${left_out[@]}" >&2
say "$SECONDS s"
exit $failed
