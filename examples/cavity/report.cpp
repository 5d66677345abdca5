#include "report.hpp"

#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <mote/core/version.hpp>
#include <mote/transfer/affine_flip.hpp>
#include <mote/transfer/flip.hpp>
#include <mote/transfer/fmpm.hpp>
#include <mote/transfer/xpic.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

namespace cavity {

namespace {

using json = nlohmann::ordered_json;

/// The order that runs, given or not; null for transfers without one.
json order(const Options& o) {
  if (o.transfer == Transfer::xpic) return o.order.value_or(mote::transfer::Xpic{}.order);
  if (o.transfer == Transfer::fmpm) return o.order.value_or(mote::transfer::Fmpm{}.order);
  if (o.transfer == Transfer::aflip) return o.order.value_or(mote::transfer::AffineFlip{}.order);
  return nullptr;
}

/// The blend that runs, given or not; null for transfers without one.
json blend(const Options& o) {
  if (o.transfer == Transfer::flip) return o.flip_blend.value_or(mote::transfer::Flip{}.blend);
  if (o.transfer == Transfer::aflip) return o.flip_blend.value_or(mote::transfer::AffineFlip{}.blend);
  return nullptr;
}

json configuration(const Options& o) {
  return {{"preset", o.preset},
          {"speed_m_s", o.speed},
          {"until_ns", o.until},
          {"radius_um", o.radius},
          {"centre_z_um", o.centre_z},
          {"yield_mpa", o.yield},
          {"hardening_mpa", o.hardening},
          {"spacing_um", o.spacing},
          {"per_axis", o.per_axis},
          {"fill", to_string(o.fill)},
          {"jitter", o.jitter},
          {"seed", o.seed},
          {"shape", to_string(o.shape)},
          {"transfer", to_string(o.transfer)},
          {"flip_blend", blend(o)},
          {"order", order(o)},
          {"update", to_string(o.update)},
          {"courant", o.courant},
          {"domain", to_string(o.domain)},
          {"precision", to_string(o.precision)},
          {"threads", o.threads},
          {"sleep", o.sleep.value_or(true) ? "on" : "off"},
          {"sleep_tolerance", o.sleep.value_or(true) ? json(o.sleep_tolerance) : json(nullptr)},
          {"conductivity_w_m_k", o.conductivity},
          {"sample_ns", o.sample},
          {"frames", o.frames},
          {"out", o.out}};
}

/// The numbers that one compares between runs, in the units of history.csv; a number that is nan becomes null.
json key_numbers(const mote::observe::Sample& s) {
  return {{"time_ns", 1e9 * s.time},
          {"vz_min_m_s", s.v.min},
          {"vz_max_m_s", s.v.max},
          {"vz_low_m_s", s.v.low},
          {"vz_high_m_s", s.v.high},
          {"p_min_mpa", 1e-6 * s.pressure.min},
          {"p_max_mpa", 1e-6 * s.pressure.max},
          {"t_max_k", s.t_max},
          {"cavity_volume_um3", 1e18 * s.cavity.volume},
          {"cavity_width_um", 1e6 * s.cavity.width},
          {"cavity_height_um", 1e6 * s.cavity.height},
          {"kinetic_j", s.kinetic},
          {"elastic_j", s.elastic},
          {"plastic_j", s.plastic},
          {"transfer_loss_j", s.transfer_loss},
          {"wall_loss_j", s.wall_loss},
          {"energy_error", s.energy_error},
          {"mass_kg", s.mass},
          {"momentum_z_kg_m_s", s.momentum},
          {"wall_impulse_z_n_s", s.wall_impulse}};
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);  // Linux counts KiB
}

double ns_per_particle_step(const Result& r) {
  return r.steps == 0 ? 0 : 1e9 * r.step_seconds * r.threads / (double(r.particles) * double(r.steps));
}

/// Particles of the run, were the ball cut exactly.
double estimate_particles(const Options& o) {
  const double ball = 4 / 3.0 * std::numbers::pi * std::pow(o.radius, 3);
  const double volume = 4 * half_width * half_width * height - ball;
  return volume * std::pow(o.per_axis / o.spacing, 3) / (o.domain == Domain::quarter ? 4 : 1);
}

/// Steps of the run if the fastest material moves at four times the launch speed; they land on the samples.
double estimate_steps(const Options& o) {
  const double sound = 6437, um_per_ns = 1e-3;
  const double dt = o.courant * o.spacing / ((sound + 4 * std::abs(o.speed)) * um_per_ns);
  const double samples = o.until / o.sample;
  return samples < 1 ? std::ceil(o.until / dt) : std::ceil(samples * std::ceil(o.sample / dt));
}

double estimate_whole_body(const Options& o) { return estimate_particles(o) * (o.domain == Domain::quarter ? 4 : 1); }

/// Memory: the program, columns, what sort and grid add to them, and a frame, which is of the whole body.
double estimate_bytes(const Options& o, const Combination& c) {
  const double program = 10e6, sort_and_grid = 60, frame = o.frames > 0 ? 70 : 0;
  return program + estimate_particles(o) * (c.bytes_per_particle + sort_and_grid) + estimate_whole_body(o) * frame;
}

/// Files: a particle takes 86 bytes of a frame in base64, a node 38.
double estimate_file_bytes(const Options& o) {
  const double nodes = 4 * half_width * half_width * height / std::pow(o.spacing, 3);
  return o.frames * (86 * estimate_whole_body(o) + 38 * nodes) + 500 * o.until / o.sample;
}

}  // namespace

std::string plan(const Options& o, const Combination& c) {
  std::ostringstream out;
  const json all = configuration(o);
  for (const auto& [key, value] : all.items())
    out << std::left << std::setw(20) << key << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
  out << std::fixed << std::setprecision(0);
  out << "\nestimates\n";
  out << std::left << std::setw(20) << "particles" << estimate_particles(o) << '\n';
  out << std::setw(20) << "steps" << estimate_steps(o) << '\n';
  out << std::setw(20) << "bytes_per_particle" << c.bytes_per_particle << '\n';
  out << std::setw(20) << "memory_mb" << 1e-6 * estimate_bytes(o, c) << '\n';
  out << std::setw(20) << "files_mb" << 1e-6 * estimate_file_bytes(o) << '\n';
  out << "\nDry run: nothing was computed or written.\n";
  return out.str();
}

void write_summary(const Options& o, const Result& r, double wall_seconds) {
  const json summary = {{"version", mote::version},
                        {"failure", r.failure.empty() ? json(nullptr) : json(r.failure)},
                        {"configuration", configuration(o)},
                        {"particles", r.particles},
                        {"steps", r.steps},
                        {"threads", r.threads},
                        {"wall_seconds", wall_seconds},
                        {"step_seconds", r.step_seconds},
                        {"ns_per_particle_step", ns_per_particle_step(r)},
                        {"peak_memory_bytes", std::llround(peak_memory_bytes())},
                        {"initial", key_numbers(r.first)},
                        {"final", key_numbers(r.last)}};
  mote::observe::OutputFile file{std::filesystem::path(o.out) / "summary.json"};
  file.write(summary.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
  file.close();
}

std::string closing_words(const Options& o, const Result& r, double wall_seconds) {
  std::ostringstream out;
  out << std::setprecision(3) << r.particles << " particles, " << r.steps << " steps, " << r.threads
      << (r.threads == 1 ? " thread: " : " threads: ") << wall_seconds << " s, of which " << r.step_seconds
      << " s in steps (" << ns_per_particle_step(r) << " ns per particle and step and thread); results in " << o.out
      << '\n';
  return out.str();
}

}  // namespace cavity
