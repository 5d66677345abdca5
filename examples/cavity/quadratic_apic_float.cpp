#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> quadratic_apic_float{
    combination<shape::QuadraticBSpline, transfer::Apic, update::Usl, float>(Shape::quadratic, Transfer::apic,
                                                                             Update::usl)};

}  // namespace cavity
