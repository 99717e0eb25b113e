#!/usr/bin/env bash
# surface_mesh_geodesics matrix --store, --status, --verify
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid9.off # 81 vertices

# status <folder>: the second line of the table
status() {
  "$program" matrix --status "$1" | line /dev/stdin 2
}

is_silent matrix "$grid" --source all --store whole > table
equals "$(line table 1)" rows,rows_done,shards,shards_done,shards_in_work
equals "$(line table 2)" 81,81,6,6,0
equals "$(status whole)" 81,81,6,6,0
equals "$(ls whole | head -n 3 | paste -sd ' ')" \
  "manifest.json rows_000000_000016.npy rows_000016_000032.npy"
is_silent matrix --verify whole > verified
equals "$(line verified 2)" "checksums of shards,6,0,"
equals "$(line verified 3)" "rows computed anew,10,0,"
equals "$(wc -l < verified)" 5

# What is there already is not computed again without a word. Other options do not fit.
rejects 2 "the folder has a matrix; --resume computes what is missing" matrix "$grid" --source all --store whole
rejects 3 "the folder has the matrix of sources, targets and options with the hash" \
  matrix "$grid" --source all --store whole --resume --float32
rejects 3 "the folder has the matrix of a mesh with the hash" \
  matrix "$data/grid8.off" --source all --store whole --resume
cp -r whole damaged
printf 'x' | dd of=damaged/rows_000032_000048.npy bs=1 seek=777 conv=notrunc status=none
code=0
"$program" matrix --verify damaged > verified 2> err || code=$?
equals "$code" 1
contains err "the shard of the rows 32:48 is damaged; --resume computes it again"
is_silent matrix "$grid" --source all --store damaged --resume > table
diff -r whole damaged

# The tasks of an array job, in any order and at the same time.
for rows in 40:60 0:20 60:81 20:40; do
  "$program" matrix "$grid" --source all --store tasks --rows $rows --shard-rows 16 > "table_$rows" &
done
wait
diff -r whole tasks

# An array job may have more tasks than there are rows.
"$program" matrix "$grid" --source all --store tasks --rows 81:90 > table 2> err
equals "$(line table 2)" 0,0,0,0,0
contains err "no shard begins in the rows 81:90: nothing was computed"

# What another host has locked is left to it, and the matrix is not complete.
mkdir left
printf node7.4711.99 > left/rows_000016_000032.lock
code=0
"$program" matrix "$grid" --source all --store left > table 2> err || code=$?
equals "$code" 1
equals "$(line table 2)" 81,65,6,5,1
contains err "missing rows: 16, shards that other processes have locked: 1; --resume computes what is missing"
rm left/rows_000016_000032.lock
is_silent matrix "$grid" --source all --store left --resume > table
diff -r whole left

# Signals leave a folder that can be completed. (The shell ignores Ctrl-C for processes in the background;
# test_distance_matrix_store_kills sends it.)
for signal in HUP TERM KILL; do
  for _ in 1 2 3; do
    "$program" matrix "$grid" --source all --store killed --resume --shard-rows 1 > table 2>&1 &
    process=$!
    sleep 0.05
    kill -$signal $process 2> kill.err || true # it may have ended
    wait $process || true
  done
done
is_silent matrix "$grid" --source all --store killed --resume > table
equals "$(line table 2)" 81,81,81,81,0
is_silent matrix --verify killed > verified
equals "$(find killed -name '*.tmp' -o -name '*.lock' -o -name '*.done')" ""

# Other kinds: 32 bits, half of a symmetric matrix, pairs within a radius, few sources.
is_silent matrix "$grid" --source all --store single --float32 > table
is_silent matrix "$grid" --source all --store half --symmetric > table
is_silent matrix "$grid" --source all --store peeled --symmetric --peel > table
rejects 2 "--peel needs --symmetric" matrix "$grid" --source all --store other --peel
is_silent matrix "$grid" --source all --store near --radius 0.3 > table
is_silent matrix "$grid" --source 5 --source-point 0.51,0.5,0 --target all --store few > table
for folder in single half peeled near few; do
  is_silent matrix --verify $folder > verified
  equals "$(line verified 3 | cut -d, -f3)" 0
done

# Several meshes, the largest first.
printf '# meshes\n%s\n\n  %s \n' "$data/grid4.off" "$grid" > list
is_silent matrix --meshes list --source all --store many > table
equals "$(line table 2)" 97,97,7,7,0
for file in whole/*.npy; do
  cmp "$file" "many/grid9/${file#whole/}"
done
equals "$(status many/grid4)" 16,16,1,1,0

# The same by the processes of an MPI job, if there are any.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_btl_vader_single_copy_mechanism=none
if command -v mpirun > mpirun.path && "$program" matrix "$grid" --source 0 --store alone --mpi > table 2> err; then
  mpirun -n 3 "$program" matrix "$grid" --source all --store job --mpi > table
  equals "$(line table 2)" 81,81,6,6,0
  diff -r whole job
  mpirun -n 3 "$program" matrix --meshes list --source all --store jobs --mpi > table
  equals "$(line table 2)" 97,97,7,7,0
  diff -r many jobs
  code=0
  mpirun -n 2 "$program" matrix --meshes list --source all --store jobs --mpi > table 2> err || code=$?
  equals "$code" 2
  contains err "the folder has a matrix; --resume computes what is missing of it"
  printf 'x' | dd of=jobs/grid9/rows_000032_000048.npy bs=1 seek=777 conv=notrunc status=none
  mpirun -n 3 "$program" matrix --meshes list --source all --store jobs --mpi --resume > table
  diff -r many jobs
else
  echo "NOTICE: the program was built without MPI: it is not run by several processes."
fi

# A mesh with a fault does not keep others from being stored. The larger file comes first.
(cat "$data/grid4.off"; seq -f '# %g' 2000) > bad.off
sed -i '3s/.*/nan 0 0/' bad.off
printf '%s\n' bad.off "$data/grid4.off" > faulty
code=0
"$program" matrix --meshes faulty --source all --store faults > table 2> err || code=$?
equals "$code" 3
contains err "bad.off, line 3: 'nan' is not a finite number"
contains err "1 of the meshes have faults"
equals "$(status faults/grid4)" 16,16,1,1,0

# A damaged shard that another process has locked is not done.
printf 'x' | dd of=many/grid9/rows_000032_000048.npy bs=1 seek=777 conv=notrunc status=none
printf node7.4711.99 > many/grid9/rows_000032_000048.lock
rejects 1 "many/grid9: other processes have locked damaged shards" \
  matrix --meshes list --source all --store many --resume
rm many/grid9/rows_000032_000048.lock
is_silent matrix --meshes list --source all --store many --resume > table

echo ...off > dots
cp "$grid" ...off # its name without the ending is that of the folder above
rejects 2 "...off: the name of the file gives no name for a folder" \
  matrix --meshes dots --source all --store twice
printf '%s\n%s\n' "$grid" "$grid" > list
rejects 2 "two meshes of the list would have the folder twice/grid9" matrix --meshes list --source all --store twice

rejects 2 "--float32 needs --store" matrix "$grid" --source all --float32
rejects 2 "--symmetric and --radius exclude each other" \
  matrix "$grid" --source all --store x --symmetric --radius 1
rejects 2 "--rows: '5' is not A:B" matrix "$grid" --source all --store x --rows 5
rejects 2 "--rows: '5:2' is not A:B" matrix "$grid" --source all --store x --rows 5:2
rejects 2 "--memory: '1T' is not a number of bytes" matrix "$grid" --source all --store x --memory 1T
rejects 2 "--store and --output exclude each other" matrix "$grid" --source all --store x -o x.csv
rejects 3 "none: the folder has no manifest.json" matrix --status none
rejects 2 "no mesh is given" matrix --source all --store x
rejects 2 "--store needs the name of a folder" matrix "$grid" --source all --store ""
rejects 2 "with --status, no mesh can be given" matrix "$grid" --status whole
awk 'NR > 2 && NF == 3 { print $1 "e-60", $2 "e-60", $3 "e-60"; next } { print }' "$data/grid4.off" > tiny.off
rejects 1 "a distance is too small for a number of 32 bits" matrix tiny.off --source all --store tiny --float32
[ ! -e x ]

# NumPy and SciPy read the files, if one of the interpreters has them.
python=
for each in python3 /usr/bin/python3; do
  if "$each" -c "import numpy, scipy.sparse, scipy.spatial" 2> python.err; then
    python=$each
  fi
done
if [ -n "$python" ]; then
  "$program" matrix "$grid" --source all | tail -n +2 > all.csv
  "$python" - << 'END'
import glob
import numpy as np
import scipy.sparse
import scipy.spatial.distance

d = np.loadtxt("all.csv", delimiter=",", usecols=range(1, 82))  # behind the label of the row
assert (np.concatenate([np.load(f) for f in sorted(glob.glob("whole/*.npy"))]) == d).all()
assert (np.load("whole/rows_000016_000032.npy", mmap_mode="r") == d[16:32]).all()
single = np.concatenate([np.load(f) for f in sorted(glob.glob("single/*.npy"))])
assert single.dtype == np.float32 and (single == d.astype(np.float32)).all()
half = np.concatenate([np.load(f) for f in sorted(glob.glob("half/*.npy"))])
assert (scipy.spatial.distance.squareform(half) == np.triu(d, 1) + np.triu(d, 1).T).all()
parts = []
for f in sorted(glob.glob("near/*.indptr.npy")):
    indptr, indices, data = (np.load(f.replace("indptr", name)) for name in ("indptr", "indices", "data"))
    part = scipy.sparse.csr_matrix((data, indices, indptr), shape=(len(indptr) - 1, 81))
    assert np.shares_memory(part.data, data) and np.shares_memory(part.indices, indices)
    assert np.shares_memory(part.indptr, indptr)
    parts.append(part)
assert (scipy.sparse.vstack(parts).toarray() == np.where(d <= 0.3, d, 0)).all()
END
else
  echo "NOTICE: NumPy and SciPy were not found: they do not read the files."
fi
