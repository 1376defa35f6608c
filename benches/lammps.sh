#!/bin/sh
# How fast is eMD* beside LAMMPS on the same gas? Runs `carom bench emdstar-10000-…` and LAMMPS (Debian's package
# `lammps`, one core) in turn; writes a table of CPU seconds for a second of the gas, medians, and their ratio.
#
# Usage: benches/lammps.sh [TURNS [SKIN]]
#
# LAMMPS integrates MP13's elastic viscoelastic grains (Sec. VI B 6) by velocity Verlet with 50 steps a contact:
# pair style gran/hertz/history without friction or damping, whose stiffness is 2 Y / (3 (1 - nu^2)). Neighbour
# lists with a skin of one diameter were the fastest of 1/4, 1/2, 1, 2 and 4 diameters, at both packings.
set -eu
turns=${1:-5}
skin=${2:-0.2}
command -v lmp >/dev/null || { echo "lammps.sh: no program lmp; install the package lammps" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
cargo build --release --quiet -p carom-host

# The contact of two such grains that meet at the mean normal speed of all collisions, (pi kT / m)^(1/2) = 2.5 m/s,
# lasts 3.218 k^(-2/5) v^(-1/5) = 1.90 ms, k = 7.43e7 in units of m and s: a step is 1.90 ms / 50.
cat >"$work/in.gas" <<'END'
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
variable volume equal 4/3*PI*0.001
variable edge equal (10000*v_volume/${packing})^(1/3)
variable a equal ${edge}/25
variable b equal ${edge}/20
lattice custom 1 a1 $a 0 0 a2 0 $b 0 a3 0 0 $b basis 0.25 0.25 0.25
region box block 0 ${edge} 0 ${edge} 0 ${edge} units box
create_box 1 box
create_atoms 1 box
set type 1 diameter 0.2 density 1140
variable temperature equal 2*1140*v_volume/1.380649e-23
velocity all create ${temperature} 4321 dist gaussian
pair_style gran/hertz/history 7.936507936507937e8 NULL 0 NULL 0 0
pair_coeff * *
neighbor ${skin} bin
neigh_modify delay 0 every 1 check yes
fix 1 all nve/sphere
timestep 3.8e-5
thermo 1000000
run 2000
run 10000
END

median() { sort -g | awk '{ x[NR] = $1 } END { print (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'; }

# CPU seconds for a second of the gas: the last "Loop time", by the share of the processor it had.
theirs() { # packing
  lmp -in "$work/in.gas" -var packing "$1" -var skin "$skin" -log none >"$work/out" 2>&1 \
    || { tail -3 "$work/out" >&2; exit 1; }
  awk '/^Loop time/ { loop = $4 } /CPU use/ { share = $1 } END { print loop * share / 100 / (10000 * 3.8e-5) }' "$work/out"
}

ours() { # packing
  target/release/carom bench "emdstar-10000-$1" | awk 'NR == 2 { print $7 }'
}

echo "| packing | LAMMPS (CPU s / s) | carom (CPU s / s) | ratio |"
echo "|---|---|---|---|"
for packing in 0.001 0.01; do
  for _ in $(seq "$turns"); do
    mine=$(ours "$packing")
    other=$(theirs "$packing")
    echo "$mine" >>"$work/$packing.ours"
    echo "$other" >>"$work/$packing.theirs"
    echo "$other $mine" | awk '{ print $1 / $2 }' >>"$work/$packing.ratio"
  done
  printf '| %s | %.2f | %.4f | %.0f |\n' "$packing" "$(median <"$work/$packing.theirs")" \
    "$(median <"$work/$packing.ours")" "$(median <"$work/$packing.ratio")"
done
