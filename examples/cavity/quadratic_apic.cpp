#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> quadratic_apic{
    combination<shape::QuadraticBSpline, transfer::Apic, update::Usl, double>(Shape::quadratic, Transfer::apic,
                                                                              Update::usl),
    combination<shape::QuadraticBSpline, transfer::Apic, update::Musl, double>(Shape::quadratic, Transfer::apic,
                                                                               Update::musl)};

}  // namespace cavity
