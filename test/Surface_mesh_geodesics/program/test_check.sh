#!/usr/bin/env bash
# surface_mesh_geodesics check
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# is_refuted <condition> <vertex> <arguments>: the table shows a violation of the condition by more than 1e-10 at the
# vertex, and one line names the condition that is violated most, its vertex and its meaning
is_refuted() {
  local status=0
  "$program" check "${@:3}" > refuted.csv 2> refuted.err || status=$?
  equals "$status" 1
  equals "$(wc -l < refuted.err)" 1
  contains refuted.err "surface_mesh_geodesics: error: the distances are not certified: "
  grep --quiet -E " [A-Z_]+ is violated by [^ ]+ at vertex $2: the distance " refuted.err \
    || fail "the message does not explain the violation: $(cat refuted.err)"
  equals "$(line refuted.csv 1)" condition,checks,worst_violation,vertex
  awk -F, -v c="$1" -v v="$2" '
    $1 == c && ($3 == "inf" || $3 > 1e-10) && $4 == v { n = 1 }
    END { exit !n }' refuted.csv \
    || fail "$1 is not violated at vertex $2: $(cat refuted.csv)"
}

# Distances of this program, computed and from a file.
is_silent check "$grid" --source 0 > check.csv
equals "$(line check.csv 1)" condition,checks,worst_violation,vertex
equals "$(column check.csv condition | tr '\n' ' ')" \
  "REACH SOURCES EDGES PAIRS_OF_FACES PATHS LOWER_BOUNDS PROOF REVERSE "
for checks in $(column check.csv checks); do
  [ "$checks" -gt 0 ] || fail "a condition has not been checked"
done
is_silent distances "$grid" --source 0 -o distances.csv
is_silent check "$grid" --source 0 --distances distances.csv -o same.csv
cmp check.csv same.csv

# In another order, with other columns, and with line ends of Windows.
awk -F, 'BEGIN { OFS = "," } NR == 1 { print "name", "distance", "vertex"; next } { print "x", $2, $1 }' distances.csv \
  | { read -r names; echo "$names"; sort -r; } | sed 's/$/\r/' > other_order.csv
is_silent check "$grid" --source 0 --distances other_order.csv -o same.csv
cmp check.csv same.csv

# With blanks around names and numbers, and lines of blanks.
sed 's/,/ ,\t/g; s/^/ /; $s/$/\n  \t/' distances.csv > blanks.csv
is_silent check "$grid" --source 0 --distances blanks.csv -o same.csv
cmp check.csv same.csv
# As R or Windows write it.
{ printf '\xef\xbb\xbf"vertex","distance"\r\n'; paste -d, <(column distances.csv vertex) <(column distances.csv distance) \
  | sed 's/^\(.*\),\(.*\)$/"\1",\2\r/'; } > quoted.csv
is_silent check "$grid" --source 0 --distances quoted.csv -o same.csv
cmp check.csv same.csv

# Several sources, points inside faces, a radius, a part without a source.
is_silent check "$grid" --source 0 --source-point 0.5,0.5,0 --source-random 2 --quiet > several.csv
is_silent check "$grid" --source 0 --radius 0.5 > near.csv
is_silent distances "$grid" --source 0 --radius 0.5 -o near_distances.csv
is_silent check "$grid" --source 0 --radius 0.5 --distances near_distances.csv > same.csv
cmp near.csv same.csv
is_silent check "$data/two_components.off" --source 0 > parts.csv

# Curves. The distance from the border of the square is min(x, 1 - x, y, 1 - y); of its vertices, 5, 6, 9 and 10 are
# inside. Distances from a vertex of the border are others.
awk 'BEGIN {
  print "vertex,distance"
  for(v = 0; v < 16; ++v) printf "%d,%.17g\n", v, (v == 5 || v == 6 || v == 9 || v == 10) / 3
}' > from_border.csv
is_silent check "$grid" --source-border --distances from_border.csv > border.csv
is_silent check "$grid" --source-border > same.csv
equals "$(column border.csv checks)" "$(column same.csv checks)"
printf 'v 0.1 0.2 0\nv 0.9 0.7 0\nv 0.3 0.8 0\nl 1 2 3 1\n' > curve.obj
is_silent distances "$grid" --source-curve curve.obj --source 0 --radius 0.4 -o from_curve.csv
is_silent check "$grid" --source-curve curve.obj --source 0 --radius 0.4 --distances from_curve.csv > curve.csv
is_refuted PATHS 15 "$grid" --source-border --distances distances.csv
sed 's/^9,.*/9,0.3334/' from_border.csv > longer.csv
is_refuted LOWER_BOUNDS 9 "$grid" --source-border --distances longer.csv
rejects 2 "--source-border: the surface has no border" check "$data/tetra.off" --source-border

# changed <vertex> <expression of the distance d>: the table with another distance of a vertex
changed() {
  awk -F, -v v="$1" 'BEGIN { OFS = "," } NR > 1 && $1 == v { d = $2; $2 = '"$2"' } { print }' OFMT='%.17g' \
    CONVFMT='%.17g' distances.csv
}

# Wrong distances: too long, too short, missing, not a number. A larger tolerance accepts small errors.
changed 6 'd * 1.000000001' > longer.csv
is_refuted LOWER_BOUNDS 6 "$grid" --source 0 --distances longer.csv
is_silent check "$grid" --source 0 --distances longer.csv --tolerance 1e-8 > tolerated.csv
changed 6 'd * 0.999999999' > shorter.csv
is_refuted PATHS 6 "$grid" --source 0 --distances shorter.csv
changed 10 '"inf"' > unreached.csv
is_refuted REACH 10 "$grid" --source 0 --distances unreached.csv
changed 10 '"nan"' > none.csv
is_refuted REACH 10 "$grid" --source 0 --distances none.csv
changed 0 '0.1' > source.csv
is_refuted SOURCES 0 "$grid" --source 0 --distances source.csv

# Invalid tables.
rejects 3 "there.csv: the file does not exist" check "$grid" --source 0 --distances there.csv
: > empty.csv
rejects 3 "empty.csv, line 1: there is no column 'vertex'" check "$grid" --source 0 --distances empty.csv
printf 'vertex,length\n0,0\n' > names.csv
rejects 3 "names.csv, line 1: there is no column 'distance'" check "$grid" --source 0 --distances names.csv
grep -v '^7,' distances.csv > missing.csv
rejects 3 "missing.csv: there is no distance for vertex 7" check "$grid" --source 0 --distances missing.csv
{ cat distances.csv; line distances.csv 9; } > twice.csv
rejects 3 "twice.csv, line 18: vertex 7 occurs twice" check "$grid" --source 0 --distances twice.csv
sed 's/^7,.*/16,0,0/' distances.csv > beyond.csv
rejects 3 "beyond.csv, line 9: there is no vertex '16'" check "$grid" --source 0 --distances beyond.csv
sed 's/^7,.*/7,far,0/' distances.csv > word.csv
rejects 3 "word.csv, line 9: 'far' is not a distance" check "$grid" --source 0 --distances word.csv
sed 's/^7,.*/7/' distances.csv > cut.csv
rejects 3 "cut.csv, line 9: a value is missing" check "$grid" --source 0 --distances cut.csv

mkdir folder.csv
rejects 3 "folder.csv: is a folder, not a file" check "$grid" --source 0 --distances folder.csv
rejects 2 "the name of an input file is empty" check "$grid" --source 0 --distances ""
cp distances.csv read.csv
rejects 2 "read.csv: this command reads the file" check "$grid" --source 0 --distances read.csv -o ./read.csv
cmp distances.csv read.csv

# Wrong command lines.
rejects 2 "--tolerance: 'abc' is not a positive number" check none.off --tolerance abc
rejects 2 "--radius: '1e400' is not a positive number" check none.off --source 0 --radius 1e400
rejects 2 "no source is given" check "$grid"
rejects 2 "'0' is not a positive number" check "$grid" --source 0 --tolerance 0
rejects 2 "the name must end with one of .csv" check "$grid" --source 0 -o x.ply
no_remains
