#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 1> cubic_apic_float{
    combination<shape::CubicBSpline, transfer::Apic, update::Usl, float>(Shape::cubic, Transfer::apic, Update::usl)};

}  // namespace cavity
