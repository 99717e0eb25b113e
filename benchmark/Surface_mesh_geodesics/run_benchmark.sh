#!/usr/bin/env bash
# Measures geodesic_distances(), Surface_mesh_geodesic_paths and Surface_mesh_geodesic_Voronoi_diagram against
# CGAL::Surface_mesh_shortest_path and CGAL::Heat_method_3 on CGAL's data meshes. Writes the numbers as CSV files and as
# tables in Markdown. See readme.txt in this folder.
set -euo pipefail

usage()
{
  cat <<'END'
usage: run_benchmark.sh [options]
  --all              also measure every triangle mesh of the data with at least 5000 faces
  --no-standard      do not measure the standard meshes
  --paths            also measure Surface_mesh_geodesic_paths: builds, queries and paths
  --voronoi          also measure Surface_mesh_geodesic_Voronoi_diagram with 1 to 1000 sites
  --heat             also measure Heat_method_3: times and errors (needs Eigen)
  --questions        also run the programs for one question each: growth, anisotropy, sources, reach, rules,
                     instruction_sets, schedulers, flat vertices, face queries, isolines, curves, directions,
                     obstacles, small_component, threads, phases, matrix, matrix_store, rows, uses_of_diagrams;
                     draw plots if python3 has matplotlib
  --python           also measure what the Python module adds to the time of C++ (needs the module;
                     the variable PYTHON names the interpreter)
  --compile          also measure how long programs take to compile
  --certify          also certify distances on all meshes of the data, and compare them with the original
  --remesh           also remesh all meshes of the data with 200, 1000 and 4000 samples
  --repetitions N    runs of each method on the standard meshes (5)
  --all-repetitions N  the same for --all (3)
  --paths-repetitions N  the same for --paths (5)
  --questions-repetitions N  the same for --questions (7)
  --voronoi-repetitions N  the same for --voronoi (3)
  --heat-repetitions N  the same for --heat (5)
  --paths-meshes LIST  names of meshes for --paths ("bunny00 armadillo refined_elephant"); armadillo among them is also
                     measured subdivided once
  --kernel K         simple or epick (simple)
  --build FOLDER     where to build and write (build/benchmark)
  --data FILE        CGAL's data as a tar.gz (Debian: package libcgal-demo)
  --programs FOLDER  use the programs in this folder instead of building them
END
}

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
build="$root/build/benchmark"
data_archive=/usr/share/doc/libcgal-dev/data.tar.gz
programs=
repetitions=5
all_repetitions=3
paths_repetitions=5
questions_repetitions=7
paths_meshes="bunny00 armadillo refined_elephant"
kernel=simple
standard=yes
all=no
paths=no
voronoi=no
voronoi_repetitions=3
heat=no
heat_repetitions=5
questions=no
python=no
compile=no
certify=no
remesh=no

while [ $# -gt 0 ]; do
  case "$1" in
    --all) all=yes ;;
    --paths) paths=yes ;;
    --voronoi) voronoi=yes ;;
    --heat) heat=yes ;;
    --questions) questions=yes ;;
    --python) python=yes ;;
    --compile) compile=yes ;;
    --certify) certify=yes ;;
    --remesh) remesh=yes ;;
    --no-standard) standard=no ;;
    --repetitions) repetitions="$2"; shift ;;
    --all-repetitions) all_repetitions="$2"; shift ;;
    --paths-repetitions) paths_repetitions="$2"; shift ;;
    --voronoi-repetitions) voronoi_repetitions="$2"; shift ;;
    --heat-repetitions) heat_repetitions="$2"; shift ;;
    --questions-repetitions) questions_repetitions="$2"; shift ;;
    --paths-meshes) paths_meshes="$2"; shift ;;
    --kernel) kernel="$2"; shift ;;
    --build) build="$2"; shift ;;
    --data) data_archive="$2"; shift ;;
    --programs) programs="$2"; shift ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 1 ;;
  esac
  shift
done

mkdir -p "$build"
build="$(cd "$build" && pwd)"
flags="not known (--programs)"

if [ -z "$programs" ]; then
  # In CGAL's source tree, this folder is a project of its own.
  source=$root
  [ -f "$root/CMakeLists.txt" ] || source=$here
  cmake -S "$source" -B "$build/programs" -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DSurface_mesh_geodesics_TESTS=OFF -DSurface_mesh_geodesics_EXAMPLES=OFF \
    -DSurface_mesh_geodesics_BENCHMARK=ON -DSurface_mesh_geodesics_PROGRAM=OFF > "$build/configure.log"
  targets=()
  [ "$standard$all" = nono ] || targets+=(benchmark_against_shortest_path)
  [ "$paths" = no ] || targets+=(benchmark_paths_against_shortest_path)
  [ "$voronoi" = no ] || targets+=(benchmark_Voronoi_diagram)
  [ "$heat" = no ] || targets+=(benchmark_against_heat_method)
  [ "$questions" = no ] || targets+=(benchmark_growth benchmark_anisotropy benchmark_sources benchmark_reach
                                     benchmark_rules benchmark_instruction_sets benchmark_schedulers
                                     benchmark_flat_vertices
                                     benchmark_face_queries benchmark_isolines benchmark_curves
                                     benchmark_directions benchmark_obstacles
                                     benchmark_small_component
                                     benchmark_threads benchmark_phases benchmark_matrix
                                     benchmark_matrix_store benchmark_rows benchmark_uses_of_diagrams)
  [ "$python" = no ] || targets+=(benchmark_python)
  [ "$certify" = no ] || targets+=(benchmark_certification)
  [ "$remesh" = no ] || targets+=(benchmark_remeshing)
  if [ "${#targets[@]}" -gt 0 ]; then
    cmake --build "$build/programs" --target "${targets[@]}" > "$build/build.log"
    programs="$(dirname "$(find "$build/programs" -type f -name "${targets[0]}" | head -n 1)")"
  elif [ "$compile" = no ]; then
    usage >&2
    exit 1
  fi
fi
# The flags that the compiler received, without folders, warnings, file names and definitions that contain paths.
commands="$programs/../../compile_commands.json"
[ -f "$commands" ] || commands="$programs/compile_commands.json"
if [ -f "$commands" ]; then
  flags="$(grep '"command".*benchmark_' "$commands" | head -n 1 \
    | tr ' ' '\n' | grep -E '^-(O|f|m|march|std|DNDEBUG|D_GLIBCXX)' | sort -u | tr '\n' ' ' | sed 's/ $//')"
fi
program="$programs/benchmark_against_shortest_path"
paths_program="$programs/benchmark_paths_against_shortest_path"
voronoi_program="$programs/benchmark_Voronoi_diagram"
heat_program="$programs/benchmark_against_heat_method"

if [ ! -f "$build/data/meshes/bunny00.off" ]; then
  if [ ! -f "$data_archive" ] && command -v apt-get > /dev/null; then
    # Slim images of Debian do not install /usr/share/doc: take the file out of the package itself.
    mkdir -p "$build/libcgal-demo"
    (cd "$build/libcgal-demo" && apt-get download libcgal-demo && dpkg-deb --extract libcgal-demo_*.deb .) || true
    data_archive="$build/libcgal-demo/usr/share/doc/libcgal-dev/data.tar.gz"
  fi
  if [ ! -f "$data_archive" ]; then
    echo "$data_archive is missing: apt-get install libcgal-demo, or --data FILE" >&2
    exit 1
  fi
  mkdir -p "$build/unpacked"
  tar -xzf "$data_archive" -C "$build/unpacked"
  meshes="$(dirname "$(find "$build/unpacked" -name bunny00.off | head -n 1)")"
  mkdir -p "$build/data"
  mv "$meshes" "$build/data/meshes"
  rm -rf "$build/unpacked"
fi
meshes="$build/data/meshes"

# Converts a CSV file of benchmark_against_shortest_path to Markdown: the lines that start with '#', and a table.
markdown()
{
  awk -F, '
    function range(middle, low, high) {
      return middle == "" ? "" : sprintf(middle < 1000 ? "%.1f (%.1f–%.1f)" : "%.0f (%.0f–%.0f)", middle, low, high)
    }
    function times(ratio) { return ratio == "" ? "" : sprintf("%.1f", ratio) }
    /^#/ { sub(/^# /, ""); print "- " $0; next }
    /^mesh,/ {
      print ""
      print "| mesh | faces | original, ms | ours, ms | time ratio | original, added MB | " \
            "ours, added MB | memory ratio | windows propagated | ns per window | largest relative difference |"
      print "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      next
    }
    {
      name = $1; sub(/\.[a-z]+$/, "", name)
      if ($2 > 0) name = name ", subdivided " ($2 == 1 ? "once" : $2 == 2 ? "twice" : $2 " times")
      printf "| %s | %d | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", name, $3, \
             range($5, $6, $7), range($8, $9, $10), times($11), times($12), \
             ($13 == "" ? "" : sprintf("%.2f", $13)), times($14), $15, times($16), \
             ($17 == "" ? "" : sprintf("%.1e", $17))
      if ($11 != "") { ratio[++n] = $11; memory[n] = $14 }
      if ($1 ~ /^bunny00/) bunny[$2] = $8
    }
    function median(a, n,   i, j, t) {
      for (i = 2; i <= n; ++i)
        for (j = i; j > 1 && a[j - 1] + 0 > a[j] + 0; --j) { t = a[j]; a[j] = a[j - 1]; a[j - 1] = t }
      return n % 2 ? a[(n + 1) / 2] : (a[n / 2] + a[n / 2 + 1]) / 2
    }
    END {
      if (n > 4) {
        m = median(ratio, n)
        printf "\n%d meshes: ratio of times %.1f to %.1f, median %.1f", n, ratio[1], ratio[n], m
        m = median(memory, n)
        printf "; ratio of added memory %.1f to %.1f, median %.1f.\n", memory[1], memory[n], m
      }
      if (bunny[0] > 0 && bunny[2] > 0)
        printf "\nbunny00 subdivided twice (16 times the faces) takes %.1f times the time of bunny00.\n", \
               bunny[2] / bunny[0]
    }' "$1"
}

# Converts a CSV file of benchmark_paths_against_shortest_path to Markdown. Finds columns by their names.
markdown_of_paths()
{
  awk -F, '
    /^#/ { sub(/^# /, ""); print "- " $0; next }
    /^mesh,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    { row[++n] = $0 }
    function value(name) { return $(column[name]) }
    function number(x, digits) { return x == "" ? "" : sprintf("%." digits "f", x) }
    # Cells for the original, ours and their ratio.
    function three(name, digits) {
      return sprintf(" %s | %s | %s |", number(value("original_" name), digits), number(value("ours_" name), digits), \
                     number(value("ratio_" name), digits_of_ratio(value("ratio_" name))))
    }
    # Cells for ours and the ratio.
    function two(name, digits) {
      return sprintf(" %s | %s |", number(value("ours_" name), digits), \
                     number(value("ratio_" name), digits_of_ratio(value("ratio_" name))))
    }
    function digits_of_ratio(ratio) { return ratio < 2 ? 2 : 1 }
    function mesh(   name) {
      name = $1; sub(/\.[a-z]+$/, "", name)
      if ($2 > 0) name = name ", subdivided " ($2 == 1 ? "once" : $2 " times")
      return sprintf("| %s | %d |", name, value("sources"))
    }
    END {
      print "\n| mesh | sources | build: original, ms | ours for vertices, ms | ratio | ours for faces, ms | " \
            "ratio | added memory: original, MB | ours for vertices, MB | ratio | ours for faces, MB | ratio |"
      print "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      for (r = 1; r <= n; ++r) {
        $0 = row[r]
        print mesh() three("build_vertices_ms", 1) two("build_faces_ms", 1) three("memory_vertices_mb", 1) \
              two("memory_faces_mb", 1)
      }
      print "\n| mesh | sources | vertex query: original, µs | ours, µs | ratio | face query: original, µs | " \
            "ours, µs | ratio | vertex path: original, µs | ours, µs | ratio | face path: original, µs | " \
            "ours, µs | ratio | points of a path from a vertex, from a face | " \
            "largest relative difference of distances, of path lengths |"
      print "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      for (r = 1; r <= n; ++r) {
        $0 = row[r]
        difference = value("largest_distance_difference")
        printf "%s%s%s%s%s %s, %s | %s |\n", mesh(), three("vertex_query_us", 3), three("face_query_us", 2), \
               three("vertex_path_us", 1), three("face_path_us", 1), \
               value("points_per_vertex_path"), value("points_per_face_path"), \
               difference == "" ? "" : sprintf("%.1e, %.1e", difference, value("largest_path_length_difference"))
      }
    }' "$1"
}

# Converts a CSV file of benchmark_Voronoi_diagram to Markdown.
markdown_of_voronoi()
{
  awk -F, '
    /^#/ { sub(/^# /, ""); print "- " $0; next }
    /^mesh,/ {
      for (i = 1; i <= NF; ++i) column[$i] = i
      print "\n| mesh | faces | sites | distances, ms | windows all kept, ms | removal, ms | diagram, ms | " \
            "diagram / distances | windows kept | at once | ratio | all kept, MB | removal, MB | diagram, MB | " \
            "arcs | vertices | naive, ms | naive / diagram |"
      print "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
      next
    }
    function value(name) { return $(column[name]) }
    {
      name = $1; sub(/\.[a-z]+$/, "", name)
      if ($2 > 0) name = name ", subdivided " ($2 == 1 ? "once" : $2 == 2 ? "twice" : $2 " times")
      printf "| %s", name
      n = split("faces sites distances_ms all_kept_ms removal_ms diagram_ms diagram_over_distances windows_kept " \
                "windows_at_once ratio_of_windows all_kept_mb removal_mb diagram_mb arcs vertices " \
                "naive_ms naive_over_diagram", names, " ")
      for (i = 1; i <= n; ++i) printf " | %s", value(names[i])
      print " |"
      if (value("sites") == 30)
        ratios = ratios sprintf("- %s: %s times fewer windows at once; " \
                                "diagram in %s times the time of the distances.\n", \
                                name, value("ratio_of_windows"), value("diagram_over_distances"))
    }
    END { printf "\nWith 30 sites:\n%s", ratios }' "$1"
}

if [ "$standard" = yes ]; then
  csv="$build/against_shortest_path.csv"
  "$program" --kernel "$kernel" --repetitions "$repetitions" --flags "$flags" \
    "$meshes/bunny00.off" "$meshes/armadillo.off" "$meshes/refined_elephant.off" | tee "$csv" >&2
  # Only ours: the original needs more than 8 GB for bunny00 subdivided once.
  for k in 1 2; do
    "$program" --kernel "$kernel" --repetitions "$repetitions" --no-header --only ours --subdivide "$k" \
      "$meshes/bunny00.off" | tee -a "$csv" >&2
  done
  markdown "$csv" | tee "${csv%.csv}.md"
fi

if [ "$all" = yes ]; then
  csv="$build/against_shortest_path_all.csv"
  # The program reports files without a triangle mesh, or with several surfaces, on standard error and skips them.
  find "$meshes" -maxdepth 1 -type f \( -name '*.off' -o -name '*.ply' -o -name '*.stl' \) \
    | LC_ALL=C sort > "$build/list.txt"
  "$program" --kernel "$kernel" --repetitions "$all_repetitions" --flags "$flags" --minimum-faces 5000 \
    --time-limit 600 --list "$build/list.txt" 2> "$build/all_meshes.log" | tee "$csv" >&2 \
    || echo "some runs failed, see $build/all_meshes.log" >&2
  markdown "$csv" | tee "${csv%.csv}.md"
fi

if [ "$paths" = yes ]; then
  csv="$build/paths_against_shortest_path.csv"
  files=()
  for name in $paths_meshes; do
    files+=("$meshes/$name.off")
  done
  # Each run is limited to 8 GB.
  "$paths_program" --kernel "$kernel" --repetitions "$paths_repetitions" --flags "$flags" --memory-limit 8192 \
    "${files[@]}" | tee "$csv" >&2
  # Of the subdivided meshes, the original completes only armadillo in 8 GB. It runs out of memory with bunny00 and
  # refined_elephant, which have more faces.
  case " $paths_meshes " in
    *" armadillo "*)
      "$paths_program" --kernel "$kernel" --repetitions "$paths_repetitions" --no-header --memory-limit 8192 \
        --subdivide 1 "$meshes/armadillo.off" | tee -a "$csv" >&2 ;;
  esac
  markdown_of_paths "$csv" | tee "${csv%.csv}.md"
fi

if [ "$voronoi" = yes ]; then
  csv="$build/voronoi.csv"
  "$voronoi_program" --repetitions "$voronoi_repetitions" --flags "$flags" \
    "$meshes/bunny00.off" "$meshes/armadillo.off" | tee "$csv" >&2
  # A mesh with more than a million faces.
  "$voronoi_program" --repetitions 1 --no-header --subdivide 2 "$meshes/bunny00.off" | tee -a "$csv" >&2
  # The naive method: one object of Surface_mesh_shortest_path for each site.
  "$voronoi_program" --repetitions 1 --no-header --sites 10 --naive 10 "$meshes/elephant.off" "$meshes/armadillo.off" \
    | tee -a "$csv" >&2
  markdown_of_voronoi "$csv" | tee "${csv%.csv}.md"
fi

if [ "$heat" = yes ]; then
  csv="$build/against_heat_method.csv"
  "$heat_program" --kernel "$kernel" --repetitions "$heat_repetitions" --flags "$flags" \
    "$meshes/elephant.off" "$meshes/armadillo.off" "$meshes/bunny00.off" "$meshes/refined_elephant.off" | tee "$csv" >&2
  "$heat_program" --kernel "$kernel" --repetitions "$heat_repetitions" --no-header --subdivide 1 \
    "$meshes/bunny00.off" | tee -a "$csv" >&2
fi

# ask QUESTION ARGUMENTS...: runs the program benchmark_QUESTION and writes its table to QUESTION.csv.
ask()
{
  local question="$1"
  shift
  "$programs/benchmark_$question" --repetitions "$questions_repetitions" --flags "$flags" "$@" \
    | tee "$build/$question.csv" >&2
}

if [ "$questions" = yes ]; then
  ask growth --subdivide 2 "$meshes/bunny00.off"
  "$programs/benchmark_growth" --repetitions "$questions_repetitions" --no-header --subdivide 0 \
    "$meshes/armadillo.off" "$meshes/refined_elephant.off" | tee -a "$build/growth.csv" >&2
  ask anisotropy
  ask sources "$meshes/bunny00.off"
  ask reach --subdivide 1 "$meshes/bunny00.off"
  ask rules "$meshes/elephant.off" "$meshes/armadillo.off" "$meshes/bunny00.off"
  ask instruction_sets "$meshes/bunny00.off" "$meshes/armadillo.off" "$meshes/refined_elephant.off"
  ask schedulers "$meshes/bunny00.off" "$meshes/armadillo.off"
  # All meshes of the data, and subdivided ones. The program skips files without a triangle mesh.
  find "$meshes" -maxdepth 1 -type f -name '*.off' | LC_ALL=C sort > "$build/list.txt"
  ask flat_vertices --minimum-faces 1000 --list "$build/list.txt" 2> "$build/flat_vertices.log"
  for k in 1 2; do
    "$programs/benchmark_flat_vertices" --repetitions "$questions_repetitions" --no-header --subdivide "$k" \
      "$meshes/elephant.off" "$meshes/fandisk.off" "$meshes/armadillo.off" "$meshes/bunny00.off" \
      | tee -a "$build/flat_vertices.csv" >&2
  done
  ask face_queries "$meshes/bunny00.off"
  ask isolines "$meshes/bunny00.off" "$meshes/armadillo.off"
  "$programs/benchmark_isolines" --repetitions 3 --no-header --subdivide 1 "$meshes/bunny00.off" \
    | tee -a "$build/isolines.csv" >&2
  find "$meshes" -maxdepth 1 -type f -name '*.off' | LC_ALL=C sort > "$build/list.txt"
  ask curves --minimum-faces 5000 --list "$build/list.txt"
  ask directions --subdivide 1 "$meshes/bunny00.off" "$meshes/armadillo.off" "$meshes/refined_elephant.off"
  ask obstacles --subdivide 1 "$meshes/bunny00.off" "$meshes/armadillo.off" "$meshes/refined_elephant.off"
  ask small_component "$meshes/bunny00.off" "$meshes/refined_elephant.off"
  # These measure wall-clock time: the machine must be idle.
  ask threads --subdivide 2 "$meshes/bunny00.off"
  more_threads() {
    "$programs/benchmark_threads" --no-header "$@" | tee -a "$build/threads.csv" >&2
  }
  more_threads --repetitions "$questions_repetitions" --subdivide 1 "$meshes/refined_elephant.off"
  more_threads --repetitions 25 --subdivide 0 "$meshes/ChineseDragon-10kv.off" "$meshes/diplodocus.off" \
    "$meshes/armadillo.off"
  more_threads --repetitions 101 --subdivide 0 "$meshes/elephant.off" "$meshes/sphere.off"
  ask phases --subdivide 2 "$meshes/bunny00.off"
  "$programs/benchmark_uses_of_diagrams" --repetitions 5 --flags "$flags" "$meshes/bunny00.off" \
    "$meshes/armadillo.off" "$meshes/refined_elephant.off" | tee "$build/uses_of_diagrams.csv" >&2
  ask matrix --rows 256 "$meshes/bunny00.off"
  # Each mesh in a process of its own: the memory is the peak of the process.
  store() {
    "$programs/benchmark_matrix_store" --repetitions 5 --flags "$flags" --rows 16 --folder "$build/matrix_store" "$@"
  }
  store --subdivide 1 "$meshes/elephant.off" | tee "$build/matrix_store.csv" >&2
  store --no-header --subdivide 2 "$meshes/bunny00.off" | tee -a "$build/matrix_store.csv" >&2
  rows() {
    "$programs/benchmark_rows" --repetitions 3 --flags "$flags" "$@"
  }
  rows --rows 40 "$meshes/bunny00.off" "$meshes/armadillo.off" "$meshes/elephant.off" | tee "$build/rows.csv" >&2
  "$programs/benchmark_rows" --repetitions 1 --flags "$flags" --brain 1 | tee "$build/brain.csv" >&2
  rows --rows 12 --interleave 2 "$meshes/bunny00.off" | tee "$build/interleaved_rows.csv" >&2
  rows --no-header --rows 12 --interleave 4 "$meshes/bunny00.off" | tee -a "$build/interleaved_rows.csv" >&2
fi

if [ "$python" = yes ]; then
  "${PYTHON:-python3}" "$here/benchmark_python.py" --flags "$flags; module of setup.py" --repetitions "$questions_repetitions" "$programs/benchmark_python" \
    "$meshes/bunny00.off" | tee "$build/python.csv" >&2
fi

if [ "$compile" = yes ]; then
  "$here/measure_compile_times.sh" | tee "$build/compile_times.csv" >&2
fi

if [ "$certify" = yes ]; then
  find "$meshes" -maxdepth 1 -type f \( -name '*.off' -o -name '*.ply' -o -name '*.stl' \) \
    | LC_ALL=C sort > "$build/list.txt"
  "$programs/benchmark_certification" --flags "$flags" --memory-limit 8192 --list "$build/list.txt" \
    | tee "$build/certified_meshes.csv" || echo "some meshes are not certified, see $build/certified_meshes.csv" >&2
fi

if [ "$remesh" = yes ]; then
  find "$meshes" -maxdepth 1 -type f \( -name '*.off' -o -name '*.ply' -o -name '*.stl' \) \
    | LC_ALL=C sort > "$build/list.txt"
  "$programs/benchmark_remeshing" --flags "$flags" --list "$build/list.txt" 2> "$build/remeshing.log" \
    | tee "$build/remeshing.csv" || echo "some meshes are not remeshed, see $build/remeshing.csv" >&2
fi

# Only these two groups have plots.
[ "$all$questions" != nono ] || exit 0
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import matplotlib' 2> /dev/null; then
    "$python" "$here/plot_benchmark.py" "$build" "$build/plots"
    exit 0
  fi
done
echo "No plots: python3 has no matplotlib (Debian: apt-get install python3-matplotlib)" >&2
