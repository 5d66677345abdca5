#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> quadratic_aflip_float{
    combination<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl, float>(Shape::quadratic, Transfer::aflip,
                                                                                   Update::usl)};

}  // namespace cavity
