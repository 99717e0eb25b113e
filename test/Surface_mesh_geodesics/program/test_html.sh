#!/usr/bin/env bash
# Pages for browsers, written by the subcommands distances, path and voronoi with --html.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

needs_pages

is_silent distances "$grid" --source 0 --html distances.html -o distances.csv
is_silent path "$grid" --source 0 --target 15 --html path.html
is_silent voronoi "$grid" --site 0,15 -o voronoi.html # the format follows from the ending too
for page in distances path voronoi; do
  equals "$(line $page.html 1)" "<!DOCTYPE html>"
  equals "$(tail -n 1 $page.html)" "</html>"
  # self-contained, with the license of three.js
  equals "$(grep -c -i -E '<(script|img|iframe)[^>]+src=|<link|@import' $page.html)" 0
  contains $page.html "three.js authors"
  contains $page.html "Permission is hereby granted, free of charge"
  contains $page.html "The above copyright notice and this permission notice shall be included"
  equals "$(grep -c '@[A-Za-z_.]*@' $page.html)" 0 # no mark of the template
done

# The colors of cells are those in PLY files.
is_silent voronoi "$grid" --site all -o cells.ply --html CELLS.HTML
colors=$(grep -o '"cellColors":\[[^]]*\]' CELLS.HTML | grep -o '#[0-9a-f]*')
equals "$(echo "$colors" | wc -l)" 16
equals "$colors" "$(awk '$1 == "comment" { printf "#%02x%02x%02x\n", $5, $6, $7 }' cells.ply)"

# A file name is escaped in HTML.
cp "$grid" '<i>&"x".off'
is_silent distances '<i>&"x".off' --source 0 --html name.html
equals "$(grep -c '<i>&"x"' name.html)" 0
contains name.html '\u003ci\u003e\u0026\u0022x\u0022.off: 16 vertices, 18 faces'

# The page of a scan with 75,000 faces has less than ten million bytes.
awk 'BEGIN { n = 194; print "OFF\n" (n + 1)^2, 2 * n^2, 0
  for(i = 0; i <= n; ++i) for(j = 0; j <= n; ++j) print i, j, sin(i / 9) * cos(j / 9)
  for(i = 0; i < n; ++i) for(j = 0; j < n; ++j) { v = (n + 1) * i + j
    print 3, v, v + n + 1, v + n + 2; print 3, v, v + n + 2, v + 1 } }' > large.off
is_silent distances large.off --source 0 --html large.html
is_silent voronoi large.off --site-random 50 --quiet --html large_cells.html
[ "$(wc -c < large.html)" -lt 10000000 ]
[ "$(wc -c < large_cells.html)" -lt 10000000 ]

rejects 2 "the name 'x.txt' does not end with .html" distances "$grid" --source 0 --html x.txt
rejects 4 "cannot be written" distances "$grid" --source 0 --html nowhere/x.html
no_remains
