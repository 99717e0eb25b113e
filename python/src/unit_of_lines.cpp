// Diagrams and paths in one unit.

#include "diagrams.cpp"
#include "paths.cpp"
