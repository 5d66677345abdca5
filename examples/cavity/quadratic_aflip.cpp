#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> quadratic_aflip{
    combination<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl, double>(Shape::quadratic, Transfer::aflip,
                                                                                    Update::usl),
    combination<shape::QuadraticBSpline, transfer::AffineFlip, update::Musl, double>(Shape::quadratic, Transfer::aflip,
                                                                                     Update::musl)};

}  // namespace cavity
