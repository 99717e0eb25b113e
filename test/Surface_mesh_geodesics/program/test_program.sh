#!/usr/bin/env bash
# Common to all subcommands: help, input and output.
# A fourth argument is the man page.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
man_page=$4
grid=$data/grid4.off
subcommands="distances path voronoi sample remesh matrix check info"

# --- help -------------------------------------------------------------------------------------------------------------

is_silent --version > version
contains version "surface_mesh_geodesics "
is_silent --help > help
for subcommand in $subcommands; do
  contains help "  $subcommand "
  is_silent "$subcommand" --help > "help_$subcommand"
  is_silent help "$subcommand" > other_help
  cmp "help_$subcommand" other_help
  contains "help_$subcommand" "usage: surface_mesh_geodesics $subcommand MESH [options]"
  contains "help_$subcommand" "  surface_mesh_geodesics $subcommand bunny.off"
  contains "$man_page" ".B $subcommand"
done
# every option of the help is in the man page, and the help lists all subcommands tested here
equals "$(awk '/^subcommands:/ { on = 1; next } /^$/ { on = 0 } on { print $1 }' help | paste -sd ' ')" "$subcommands"
sed 's/\\-/-/g' "$man_page" > man_text
for option in $(cat help_* | grep -o -e '--[a-z-]*' | sort -u); do
  contains man_text "$(echo "$option" | sed -E 's/--(target|site|first)($|-)/--source\2/')"
done
rejects 2 "there is no subcommand 'bogus'" bogus
rejects 2 "there is no subcommand 'bogus'" help bogus
status=0
"$program" > no_arguments.out 2> no_arguments.err || status=$?
equals "$status" 2
[ ! -s no_arguments.out ]
contains no_arguments.err "usage: "

for word in --version --help; do
  rejects 2 "'bogus' after $word is superfluous" $word bogus
done
rejects 2 "'extra' after help is superfluous" help info extra
rejects 2 "there is no subcommand ''" ""
rejects 2 "unrecognised option '--bogus'; see surface_mesh_geodesics info --help" info --help --bogus

# words that are nearly right
rejects 2 "there is no subcommand 'distance' (did you mean 'distances'?); see" distance
rejects 2 "did you mean 'voronoi'?" help vornoi
rejects 2 "unrecognised option '--sorce' (did you mean '--source'?)" distances --sorce 0
rejects 2 "did you mean '--tolerance'?" voronoi --tolerence=1

# --- input ------------------------------------------------------------------------------------------------------------

: > empty.off
echo "this is no mesh" > text.off
head -n 20 "$grid" > no_last_faces.off
head -c 150 "$grid" > no_last_points.off
sed 's/^0 0 0$/0 nan 0/' "$grid" > not_a_number.off
sed 's/^0 0 0$/0 1e999 0/' "$grid" > too_large.off
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' > no_faces.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n' > vertex_twice.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n' > two_corners.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n' > no_vertex.obj
printf '%s\n' OFF '5 5 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '1 1 1' '3 0 1 2' '3 1 3 2' '3 2 3 4' '3 3 0 4' '3 4 0 1' \
  > moebius.off # a strip without orientation
"$program" distances "$grid" --source 0 --isolines 0 -o whole.ply
head -c 700 whole.ply > half.ply
header=$(($(grep --text --byte-offset --only-matching end_header whole.ply | cut -d: -f1) + 11)) # its bytes
{ head -c $header whole.ply; printf '\0\0\0\0\0\0\370\177'; tail -c +$((header + 9)) whole.ply; } > nan.ply
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n' > half.stl
for subcommand in $subcommands; do
  case $subcommand in
    distances | matrix | check) arguments=(--source 0) ;;
    path) arguments=(--source 0 --target 1) ;;
    voronoi) arguments=(--site 0) ;;
    sample | remesh) arguments=(--number 3) ;;
    info) arguments=() ;;
  esac
  rejects 2 "no mesh is given" "$subcommand" "${arguments[@]}"
  rejects 3 "none.off: the file does not exist" "$subcommand" none.off "${arguments[@]}"
  rejects 3 "empty.off: the file is empty" "$subcommand" empty.off "${arguments[@]}"
  rejects 3 "no_last_faces.off, line 21: the file ends after 2 of 18 faces" "$subcommand" no_last_faces.off "${arguments[@]}"
  rejects 2 "lists have commas and no blanks (0,1,2)" "$subcommand" "$grid" "${arguments[@]}" another.off
done
rejects 3 ".: is a folder, not a file" info .
rejects 3 "/dev/null: the name must end with one of .off" info /dev/null
rejects 2 "the name of an input file is empty" info ""
printf 'OFF\n3 1 0\n0 0 0\n1e308 0 0\n0 1e308 0\n3 0 1 2\n' > huge.off
rejects 3 "huge.off: vertex 1 has a coordinate that is not finite, or too large" info huge.off
# a mesh of size zero, or nearly zero, is valid
printf 'OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n' > point.off
printf 'OFF\n3 1 0\n0 0 0\n1e-320 0 0\n0 1e-320 0\n3 0 1 2\n' > tiny.off
for mesh in point tiny; do
  is_silent voronoi $mesh.off --site 0,1 -o $mesh.ply
done
is_silent distances point.off --source-point 0,0,0 > point.csv
# but the program finds no nearest location to a point if CGAL's trees cannot distinguish the mesh from a point
rejects 3 "tiny.off: the mesh is too large or too small to locate points, or the point is too far" \
  distances tiny.off --source-point 0,0,0
rejects 3 "text.off, line 1: 'this' is not the beginning of an OFF file" info text.off
rejects 3 "no_last_points.off, line " info no_last_points.off
rejects 3 "not_a_number.off, line 3: 'nan' is not a finite number: a coordinate is needed" info not_a_number.off
rejects 3 "too_large.off, line 3: '1e999' is not a finite number" info too_large.off
rejects 3 "no_faces.off: the file contains no faces" info no_faces.off
rejects 3 "vertex_twice.off: face 0 (line 6) has the vertex 1 twice; --repair may mend it" info vertex_twice.off
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 1 2 0\n' > face_twice.off
rejects 3 "face_twice.off: face 1 (line 7) repeats face 0 (line 6); --repair may mend it" info face_twice.off
rejects 3 "two_corners.off: face 0 (line 6) has fewer than three vertices" info two_corners.off
rejects 3 "no_vertex.obj, line 4: there is no vertex 7; the file has 3" info no_vertex.obj
rejects 3 "half.ply: the file ends too early" info half.ply
rejects 3 "half.stl, line 6: the file ends, but the word 'vertex' is needed" info half.stl
rejects 3 "nan.ply: a coordinate of vertex" info nan.ply
rejects 3 " has 3 faces: face 0 " info "$data/edge_three_faces.off"
rejects 3 "moebius.off: the orientations of face 0 (line 8) and face 4 (line 12) differ: both lead from vertex 0" info moebius.off
rejects 3 "must end with one of .off, .obj, .ply, .stl, .ts" info "$man_page"

# --- output -----------------------------------------------------------------------------------------------------------

distances=(distances "$grid" --source 0)
rejects 4 "nowhere/x.csv: cannot be written: No such file or directory" "${distances[@]}" -o nowhere/x.csv
rejects 4 "cannot be written: Not a directory" "${distances[@]}" -o text.off/x.csv
mkdir folder.csv
rejects 4 "folder.csv: cannot be written: it is a folder" "${distances[@]}" -o folder.csv
if [ -e /dev/full ]; then
  ln -s /dev/full full.csv
  rejects 4 "cannot be written: No space left on device" "${distances[@]}" -o full.csv
  status=0
  "$program" "${distances[@]}" > /dev/full 2> full.err || status=$?
  equals "$status" 4
  contains full.err "standard output: cannot be written"
fi
if [ "$(id -u)" -ne 0 ]; then # root may write every file
  echo old > protected.csv
  chmod a-w protected.csv
  rejects 4 "protected.csv: cannot be written: Permission denied" "${distances[@]}" -o protected.csv
  equals "$(cat protected.csv)" old
fi

rejects 2 "the name of an output file is empty" "${distances[@]}" -o ""
rejects 2 "x.jpg: the name must end with one of" "${distances[@]}" -o x.jpg
is_silent "${distances[@]}" -o /dev/null > null.out # a device is as good as the standard output
[ ! -s null.out ]
mkfifo table
cat table > piped.csv &
is_silent "${distances[@]}" -o table
wait $!
cmp piped.csv <("$program" "${distances[@]}")
# A terminal hears what has been written; the other tests have none, and hear nothing.
if command -v script > /dev/null; then
  script --quiet --command "'$program' distances '$grid' --source 0 -o told.csv --lines told.obj" terminal.log > told.out
  grep --quiet -E 'wrote told.csv \([0-9.]+ kB\), told.obj \([0-9.]+ kB\) in [0-9.e-]+ s' told.out
  script --quiet --command "'$program' distances '$grid' --source 0 -o told.csv --quiet" terminal.log > quiet.out
  [ ! -s quiet.out ]
fi
rejects 2 "option '--quiet' cannot be specified more than once" "${distances[@]}" --quiet --quiet
rejects 2 "option '--seed' cannot be specified more than once" "${distances[@]}" --seed 1 --seed 2

# A command does not overwrite its input, under any name.
cp "$grid" mesh.off
ln -s mesh.off link.off
printf '0\n' > locations.csv
for arguments in "mesh.off -o mesh.off" "mesh.off -o link.off" "link.off -o $work/mesh.off"; do
  rejects 2 "this command reads the file; give the output another name" remesh --number 3 $arguments
done
rejects 2 "locations.csv: this command reads the file" distances mesh.off --source-file locations.csv -o locations.csv
cmp "$grid" mesh.off
equals "$(cat locations.csv)" 0

# An error leaves the old file unchanged, and no other file.
echo old > kept.csv
rejects 2 "there is no vertex 99" distances "$grid" --source 99 -o kept.csv
rejects 3 "the file is empty" distances empty.off --source 0 -o kept.csv
rejects 4 "cannot be written" "${distances[@]}" -o kept.csv -o nowhere/x.csv
equals "$(cat kept.csv)" old
no_remains

# So does a signal. The program waits for its mesh from a pipe that nobody fills.
mkfifo pipe.off
"$program" distances pipe.off --source 0 -o kept.csv &
process=$!
for _ in $(seq 100); do
  [ -z "$(find . -name '.[0-9]*')" ] || break
  sleep 0.1
done
[ -n "$(find . -name '.[0-9]*')" ] # the file has been begun
kill -TERM "$process"
status=0
wait "$process" || status=$?
equals "$status" 143
equals "$(cat kept.csv)" old
no_remains

# So does a signal while files are written: the first one is complete; the second one, a pipe that nobody empties, keeps
# the program waiting.
mkfifo full_pipe.csv
exec 9<> full_pipe.csv
"$program" matrix "$data/grid9.off" --source all -o whole.csv -o full_pipe.csv &
process=$!
for _ in $(seq 100); do
  [ -z "$(find . -name '.[0-9]*whole.csv' -size +64k)" ] || break
  sleep 0.1
done
[ -n "$(find . -name '.[0-9]*whole.csv' -size +64k)" ]
kill -TERM "$process"
status=0
wait "$process" || status=$?
exec 9>&-
equals "$status" 143
[ ! -e whole.csv ]
no_remains

# a file that is named twice is written once
for i in 1 2; do # a new file, then an existing one
  "$program" distances "$data/grid9.off" --source 0 -o twice.csv -o ./twice.csv -o twice.csv
done
equals "$(wc -l < twice.csv)" "$(wc -l < <("$program" distances "$data/grid9.off" --source 0))"

# a file does not receive the descriptor of a closed stream, and no remarks
"$program" remesh "$data/grid9.off" --number 5 -o mesh.off 2>&-
equals "$(line mesh.off 1)" OFF

# if the reader of a pipe ends, no file is left behind
"$program" distances "$data/grid9.off" --source 0 -o part.csv -o - | head -n 1 > first.txt || true
no_remains

# --- completion for bash ----------------------------------------------------------------------------------------------

source "$data/../../../demo/Surface_mesh_geodesics/completion.bash"
# completed <words of the command line, the last one incomplete>
completed() {
  COMP_WORDS=(surface_mesh_geodesics "$@") COMP_CWORD=$#
  _surface_mesh_geodesics "$program" "${!#}"
  echo "${COMPREPLY[*]}"
}
equals "$(completed dis)" distances
equals "$(completed "")" "distances path voronoi sample remesh matrix check info --help --version"
equals "$(completed remesh mesh.off --)" "--number --iterations --avoid --avoid-property --output --repair --quiet --help"
equals "$(completed path mesh.off --target-f)" --target-file
equals "$(completed path me)" "" # files, by bash itself
