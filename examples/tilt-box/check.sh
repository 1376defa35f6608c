# Does the tilt box build for its boards, and do in QEMU what it does here? Read by ../check.sh; writes sizes and counts.

tilt_boards=(nrf52840:thumbv7em-none-eabihf rp2040:thumbv6m-none-eabi esp32c3:riscv32imc-unknown-none-elf)

tilt_box() {
  local board name target image=$CARGO_TARGET_DIR/thumbv7em-none-eabihf/release/carom-tilt-box-qemu
  for board in "${tilt_boards[@]}"; do
    name=${board%:*} target=${board#*:}
    build "tilt-box/$name" "$target" || return
    say "tilt box, $name: $(tilt_sizes "$CARGO_TARGET_DIR/$target/release/carom-tilt-box-$name")"
  done
  build tilt-box/qemu thumbv7em-none-eabihf || return
  COUNT=1 board thumbv7em-none-eabihf "$image" >"$work/tilt.there" || return
  (cd tilt-box/scene && cargo run --quiet --locked --example replay) >"$work/tilt.here" || return
  sed -n '/\./ s/^/tilt box, thumbv7em-none-eabihf: /p' "$work/tilt.there" >&2
  sed '/\./ d' "$work/tilt.there" | diff - "$work/tilt.here" >&2
}

# What is kept in flash, and what static data takes of RAM; the rest of RAM is the stack's.
tilt_sizes() { # image
  size -A "$1" | awk '
    $1 ~ /_dummy$/ || $1 ~ /^\.(stack|defmt|debug|comment|ARM|riscv|symtab|strtab|shstrtab)/ { next }
    $1 ~ /^\.(data|rwtext|trap)/ { flash += $2; ram += $2; next }
    $1 ~ /^\.(bss|uninit|noinit)/ { ram += $2; next }
    $1 ~ /^\./ && $3 > 0 { flash += $2 }
    END { print flash " bytes of flash, " ram " of RAM" }'
}
