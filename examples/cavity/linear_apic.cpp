#include "scene.hpp"

namespace cavity {

namespace shape = mote::shape;
namespace transfer = mote::transfer;
namespace update = mote::update;

const std::array<Combination, 2> linear_apic{
    combination<shape::Linear, transfer::Apic, update::Usl, double>(Shape::linear, Transfer::apic, Update::usl),
    combination<shape::Linear, transfer::Apic, update::Musl, double>(Shape::linear, Transfer::apic, Update::musl)};

}  // namespace cavity
