#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 4> conducting{
    combination<shape::Linear, transfer::Flip, update::Musl, double, true>(Shape::linear, Transfer::flip, Update::musl),
    combination<shape::QuadraticBSpline, transfer::Flip, update::Usl, double, true>(Shape::quadratic, Transfer::flip,
                                                                                    Update::usl),
    combination<shape::QuadraticBSpline, transfer::Apic, update::Usl, double, true>(Shape::quadratic, Transfer::apic,
                                                                                    Update::usl),
    combination<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl, double, true>(
        Shape::quadratic, Transfer::aflip, Update::usl)};

}  // namespace cavity
