# usage: compare.sh STEM TIER "WIDTH…" CPU…: links STEM.stc.bc for each processor, shades at each width, and
# fails unless all grids are the same text.
set -eu
stem=$1 tier=$2 widths=$3
shift 3
for cpu in "$@"; do
  anysl-link "$stem.stc.bc" --math "$tier" --mcpu "$cpu" --width "$(echo $widths | tr ' ' ,)" -o "$stem.$tier.so"
  for width in $widths; do
    anysl-shade "$stem.$tier.so" --grid 61x37 --width $width --print Ci --json > "$stem.$tier.$cpu.$width"
    cmp "$stem.$tier.$1.1" "$stem.$tier.$cpu.$width"
  done
done
