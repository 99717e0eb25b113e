// The figures of the thesis for its variants of the propagation: tables 4.1 to 4.5, and for the Armadillo appendix C.
//
// The thesis measured on one core of an Intel Core i7-3770 with 3.40 GHz, from the first vertex of each model, with a
// threshold of 1e-6 for comparisons of distances (section 4.5). Its models are not the meshes of CGAL: the Bunny has
// 144,000 faces and the Armadillo 345,000. So only ratios to its VTP can be compared with ratios of this package. Its
// peak of memory is that of windows, in MB; ours is a number of windows.

#ifndef THESIS_TABLES_H
#define THESIS_TABLES_H

#include <array>
#include <cstddef>
#include <string>

namespace thesis {

// A run of a variant on a model. The time is 0 if the thesis ran out of memory.
struct Run
{
  double seconds;
  std::size_t windows; // "window propagations"
  double megabytes;    // "peak memory"
};

// The variants, in the order of appendix C.
enum Variant : std::size_t { EXHAUSTIVE, TRIMMING, CH, MMP, FTP, OPVTP, VTP, NUMBER_OF_VARIANTS };

struct Model
{
  const char* name;
  std::size_t faces; // in thousands, as the thesis rounds them
  std::array<Run, NUMBER_OF_VARIANTS> runs;
};

// The table of section 4 that compares a variant with VTP; that of VTP is empty.
struct Comparison
{
  Variant variant;
  const char* name;
  const char* table;
};

inline const std::array<Comparison, 6>& comparisons()
{
  static const std::array<Comparison, 6> all{{{EXHAUSTIVE, "VTP-Exhaustive", "4.1"},
                                              {TRIMMING, "VTP-Trimming", "4.2"},
                                              {CH, "VTP-CH", "4.3"},
                                              {MMP, "VTP-MMP", "4.3"},
                                              {FTP, "FTP", "4.4"},
                                              {OPVTP, "OPVTP", "4.5"}}};
  return all;
}

inline const std::array<Model, 6>& models()
{
  static const std::array<Model, 6> all{
    {{"Bunny",
      144,
      {{{4.557, 4801056, 1.22},
        {0.872, 4686252, 1.146},
        {2.672, 12491178, 1.71},
        {1.304, 6454800, 340.45},
        {1.044, 4755872, 1.20},
        {0.908, 4875712, 1.22},
        {0.78, 4943670, 1.24}}}},
     {"Armadillo",
      345,
      {{{5.196, 19193615, 2.03},
        {1.829, 7596092, 1.396},
        {4.692, 19584534, 2.01},
        {2.206, 10258285, 538.32},
        {2.141, 7745552, 1.399},
        {1.975, 7884201, 1.401},
        {1.628, 8084456, 1.458}}}},
     {"Rocker Arm",
      482,
      {{{36.586, 24289066, 3.43},
        {4.655, 24380006, 3.49},
        {15.449, 69208037, 5.32},
        {6.954, 33947674, 1797.18},
        {4.84, 25013422, 3.68},
        {5.173, 25723669, 3.71},
        {4.13, 25654638, 3.70}}}},
     {"Asian Dragon",
      1400,
      {{{49.954, 46926451, 4.036},
        {13.763, 46316630, 4.017},
        {29.492, 109311094, 5.253},
        {15.388, 61995300, 3354.04},
        {13.223, 46525313, 4.10},
        {11.42, 47573341, 4.20},
        {9.495, 48217896, 4.373}}}},
     {"Neptune",
      4008,
      {{{665.847, 239054124, 15.62},
        {58.49, 239375390, 15.962},
        {158.912, 606937112, 17.65},
        {60.297, 278925270, 14221.35},
        {64.113, 243102435, 15.90},
        {60.192, 244586129, 16.19},
        {47.629, 246364008, 16.38}}}},
     {"Lucy",
      14464,
      {{{16559, 2703707866, 66.096},
        {615.215, 2733324263, 66.848},
        {1809.91, 6859484793, 78.31},
        {0, 0, 0},
        {617.343, 2668122127, 67.81},
        {608.414, 2734517299, 68.01},
        {549.934, 2808823718, 69.42}}}}}};
  return all;
}

} // namespace thesis

#endif // THESIS_TABLES_H
