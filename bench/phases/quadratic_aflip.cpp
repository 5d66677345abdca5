#include "phases.hpp"

void bench::add_quadratic_aflip() {
  add_rows<mote::shape::QuadraticBSpline, mote::transfer::AffineFlip>("quadratic/aflip");
}
