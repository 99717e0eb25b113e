// Distances, their matrices, and the module itself, in one unit: the headers take most of the time of small ones.

#include "distances.cpp"
#include "module.cpp"
#include "stores.cpp"
