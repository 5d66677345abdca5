/// \file
/// The families of schemes, each compiled in a file of its own name.
#pragma once

namespace accuracy {

struct Wanted;

void linear_plain(const Wanted&);
void linear_affine(const Wanted&);
void linear_sharpened(const Wanted&);
void quadratic_plain(const Wanted&);
void quadratic_affine(const Wanted&);
void quadratic_sharpened(const Wanted&);
void cubic_plain(const Wanted&);
void cubic_affine(const Wanted&);
void cubic_sharpened(const Wanted&);
void cpgimp_plain(const Wanted&);
void cpgimp_affine(const Wanted&);
void cpgimp_sharpened(const Wanted&);

void cavity_quadratic_affine(const Wanted&);
void cavity_quadratic_plain(const Wanted&);
void cavity_linear(const Wanted&);
void cavity_cubic(const Wanted&);
void cavity_cpgimp(const Wanted&);

}  // namespace accuracy
