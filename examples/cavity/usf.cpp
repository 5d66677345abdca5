#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 3> usf{
    combination<shape::Linear, transfer::Flip, update::Usf, double>(Shape::linear, Transfer::flip, Update::usf),
    combination<shape::QuadraticBSpline, transfer::Flip, update::Usf, double>(Shape::quadratic, Transfer::flip,
                                                                              Update::usf),
    combination<shape::QuadraticBSpline, transfer::Apic, update::Usf, double>(Shape::quadratic, Transfer::apic,
                                                                              Update::usf)};

}  // namespace cavity
