#!/usr/bin/env bash
# What pages for browsers contain of --walls and --avoid.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
needs_pages
if ! command -v node > /dev/null; then
  echo "SKIPPED: there is no Node.js"
  exit 77
fi

# square <n>: the unit square in square.off, with n^2 squares of two faces, n even; in the middle a wall from below, of
# half the height, and to avoid the faces of the square in the corner above on the right
square() {
  awk -v n="$1" 'BEGIN { half = n / 2; print "OFF\n" (n + 1)^2, 2 * n^2, 0
    for(i = 0; i <= n; ++i) for(j = 0; j <= n; ++j) print i / n, j / n, 0
    for(i = 0; i < n; ++i) for(j = 0; j < n; ++j) { v = (n + 1) * i + j
      print 3, v, v + n + 1, v + n + 2; print 3, v, v + n + 2, v + 1 }
    for(j = 0; j < half; ++j) print (n + 1) * half + j, (n + 1) * half + j + 1 > "walls.txt"
    print 2 * n^2 - 2, 2 * n^2 - 1 > "avoid.txt" }' > square.off
}

# A surface of few faces is refined. One of many faces is drawn as it is, but divided along the wall.
for n in 4 80; do
  square $n
  is_silent distances square.off --source 0 --walls walls.txt --avoid avoid.txt --quiet --html distances.html
  corner=$(awk -v n=$n 'BEGIN { print 1 - 1 / n }')
  node "$here/page_obstacles.js" distances.html 0.5 0.5 "$corner"
  last=$(((n + 1) * n)) # below on the right
  is_silent path square.off --source 0 --target $last --walls walls.txt --avoid avoid.txt --quiet --html path.html
  node "$here/page_obstacles.js" path.html 0.5 0.5 "$corner"
  contains path.html '"role":"path"'
  # up to the other border: what is behind the wall is not reached, nor is the wall from behind
  awk -v n=$n 'BEGIN { for(j = 0; j < n; ++j) print (n + 1) * n / 2 + j, (n + 1) * n / 2 + j + 1 }' > rooms.txt
  is_silent distances square.off --source 0 --walls rooms.txt --avoid avoid.txt --quiet --html rooms.html
  node "$here/page_obstacles.js" rooms.html 0.5 1 "$corner"
done

# A diagram, whose cells end at the faces, and at the wall. Without faces or walls, the page names none.
square 80
is_silent voronoi square.off --site 0 --avoid avoid.txt --quiet --html cells.html
node "$here/page_obstacles.js" cells.html 0.5 0 0.9875
for n in 4 80; do
  square $n
  is_silent voronoi square.off --site 0 --walls walls.txt --avoid avoid.txt --quiet --html cells.html
  node "$here/page_obstacles.js" cells.html 0.5 0.5 "$(awk -v n=$n 'BEGIN { print 1 - 1 / n }')"
done
square 4
is_silent voronoi square.off --site 0 --avoid avoid.txt --quiet --html cells.html
node "$here/page_obstacles.js" cells.html 0.5 0 0.75
is_silent distances square.off --source 0 --html free.html
equals "$(grep -c '"avoided":\|"walls":\|"role":"wall"' free.html)" 0
no_remains
