#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> cubic_apic{
    combination<shape::CubicBSpline, transfer::Apic, update::Usl, double>(Shape::cubic, Transfer::apic, Update::usl),
    combination<shape::CubicBSpline, transfer::Apic, update::Musl, double>(Shape::cubic, Transfer::apic, Update::musl)};

}  // namespace cavity
