#!/usr/bin/env bash
# Does the Arduino library work? Reads the library for a Cortex-M4F and what Rust has shown (OUT/rust.txt); writes
# OUT/arduino/carom, which an Arduino IDE takes as a library, compiles its sketch and runs it under QEMU.
set -euo pipefail
cd "$(dirname "$0")/.."
library=$1 out=$2
folder=$out/arduino/carom
rm -rf "$folder"
mkdir -p "$folder/src/cortex-m4/fpv4-sp-d16-hard"
cp -r arduino/library.properties arduino/examples "$folder"
cp include/carom.h "$folder/src"
cp "$library" "$folder/src/cortex-m4/fpv4-sp-d16-hard"

# As arduino-cli does it: the sketch is C++ that includes Arduino.h, the library is linked by its name.
sketch=$folder/examples/TiltBox/TiltBox.ino
arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -std=gnu++17 -Os -Wall -Wextra -Werror \
  -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti -nostartfiles --specs=nano.specs \
  -Iboard -I"$folder/src" -include Arduino.h -x c++ "$sketch" board/board.cpp -x none \
  -L"$folder/src/cortex-m4/fpv4-sp-d16-hard" -lcarom_c -Wl,--gc-sections -Wl,-z,noexecstack -Tboard/mps2.ld -o "$out/TiltBox.elf"
timeout --foreground 600 qemu-system-arm -M mps2-an386 -cpu cortex-m4 -nographic \
  -semihosting-config enable=on,target=native -kernel "$out/TiltBox.elf" </dev/null >"$out/arduino.txt" 2>&1
tr -d '\r' <"$out/arduino.txt" | diff "$out/rust.txt" -
panics=$(arm-none-eabi-nm "$out/TiltBox.elf" | grep -c 'core9panicking' || true)
echo "Arduino sketch: same digests; $(arm-none-eabi-size "$out/TiltBox.elf" |
  awk 'NR == 2 { print "flash " $1 + $2 ", RAM " $2 + $3 }'), panic symbols $panics"
((panics == 0))
