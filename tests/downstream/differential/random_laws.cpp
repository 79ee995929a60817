// random_laws COUNT FOLDER: random materials of all laws in turn, each with a random path of overlaps, as law
// cards and in FOLDER/laws.json, with what the headers answer. Other ways to the same laws (eval, Python,
// LAMMPS, WebAssembly) are asked for the same numbers. RC_PARAMS=seed=N repeats them.
#include "../../unit/law/random_material.hpp"

#include <fstream>
#include <iostream>

using namespace platen::law;
using platen::law::testing::digits;
using platen::law::testing::Random;

namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// As a card has it: a number, a list of numbers or a word.
std::string card_value(const std::string& text) {
  if (text.find(',') != text.npos) return '[' + text + ']';
  return std::isalpha(static_cast<unsigned char>(text[0])) ? quoted(text) : text;
}

std::string card_text(const LawChoice& one) {
  std::string text =
      "platen = 1\nlaw = " + quoted(one.name) + "\nvariant = " + quoted(one.variant) + "\n\n[parameters]\n";
  for (const auto& [key, value] : one.parameters) text += key + " = " + card_value(value) + '\n';
  return text;
}

/// Pressed, partly released, pressed again, a few times; never apart, where hosts differ in when a contact is
/// new.
std::vector<double> random_path(double R, Random& random) {
  std::vector<double> path;
  double largest = 0;
  for (int turn = 0; turn < 3; ++turn) {
    largest = std::max(largest, R * random.log_between(1e-4, 1));
    const double low = largest * random.between(0.02, 0.95);
    for (int i = 1; i <= 8; ++i) path.push_back(largest * i / 8);
    for (int i = 1; i <= 5; ++i) path.push_back(largest + (low - largest) * i / 5);
  }
  return path;
}

template <class Of> std::string listed(const std::vector<Response>& all, const Of& of) {
  std::string text;
  for (const auto& one : all) text += (text.empty() ? "[" : ",") + digits(of(one));
  return text + ']';
}

/// One law of the list; empty where the law refuses what was drawn.
std::string random_law(const LawInfo& info, Random& random, const std::string& card) {
  LawChoice one = testing::random_material(info, random);
  const double R = random.log_between(1e-5, 1e-1);
  const std::string text = card_text(one);
  std::string parameters = "radius_m=" + digits(R);
  for (const auto& [key, value] : one.parameters) parameters += ' ' + key + '=' + value;
  one.parameters["radius_m"] = digits(R);
  Law law;
  try {
    law = make_law(one.name, one.variant, one.parameters);
  } catch (const BadParameter&) { return {}; }
  std::vector<Response> answers;
  State state;
  for (const double overlap : random_path(R, random)) {
    answers.push_back(evaluate(law, state, overlap));
    state = answers.back().state;
  }
  std::ofstream(card) << text;
  return "{\"law\": " + quoted(one.name) + ", \"variant\": " + quoted(one.variant) +
         ", \"parameters\": " + quoted(parameters) + ", \"radius_m\": " + digits(R) +
         ", \"card\": " + quoted(card) +
         ", \"overlap_m\": " + listed(answers, [](const Response& r) { return r.state.gamma; }) +
         ", \"force_N\": " + listed(answers, [](const Response& r) { return r.force; }) +
         ", \"stiffness_N_per_m\": " + listed(answers, [](const Response& r) { return r.stiffness; }) +
         ", \"contact_radius_m\": " + listed(answers, [](const Response& r) { return r.contact_radius; }) +
         ", \"mean_pressure_Pa\": " + listed(answers, [](const Response& r) { return r.mean_pressure; }) +
         ", \"dissipated_work_J\": " + listed(answers, [](const Response& r) { return r.dissipated_work; }) +
         '}';
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: random_laws COUNT FOLDER\n", 2;
  if (!std::getenv("RC_PARAMS"))
    ::setenv("RC_PARAMS", ("seed=" + std::to_string(std::random_device{}())).c_str(), 1);
  std::cout << "RC_PARAMS=" << std::getenv("RC_PARAMS") << " repeats these laws\n";
  Random random;
  const std::size_t count = std::stoul(argv[1]);
  const std::string folder = argv[2];
  std::string list;
  for (std::size_t made = 0, drawn = 0; made < count; ++drawn) {
    const auto& info = laws()[made % laws().size()];
    const std::string law = random_law(info, random, folder + '/' + std::to_string(made) + ".toml");
    if (law.empty() && drawn > 100 * count) return std::cerr << info.name << " refuses what is drawn\n", 2;
    if (law.empty()) continue;
    list += (made++ ? ",\n" : "[") + law;
  }
  std::ofstream file(folder + "/laws.json");
  file << list << "]\n";
  return file.good() ? 0 : 4;
}
