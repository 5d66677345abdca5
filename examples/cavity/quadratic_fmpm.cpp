#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> quadratic_fmpm{
    combination<shape::QuadraticBSpline, transfer::Fmpm, update::Usl, double>(Shape::quadratic, Transfer::fmpm,
                                                                              Update::usl)};

}  // namespace cavity
