#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> quadratic_flip{
    combination<shape::QuadraticBSpline, transfer::Flip, update::Usl, double>(Shape::quadratic, Transfer::flip,
                                                                              Update::usl),
    combination<shape::QuadraticBSpline, transfer::Flip, update::Musl, double>(Shape::quadratic, Transfer::flip,
                                                                               Update::musl)};

}  // namespace cavity
