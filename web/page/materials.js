// What can be said of a material, and how its sliders go. The checks that count are the program's own.

const stress = (key, symbol, name, low, high, start) => ({ key, symbol, name, unit: 'Pa', log: true, low, high, start });
const plain = (key, symbol, name, low, high, start) => ({ key, symbol, name, unit: '', log: false, low, high, start });
const ratio = (key, symbol, name, low, high, start) => ({ ...plain(key, symbol, name, low, high, start), log: true });

export const models = {
  'von-mises': {
    title: 'Metal or polymer', says: 'solid, flows without hardening',
    parameters: [stress('E_Pa', 'E', "Young's modulus", 1e6, 1e12, 10e9),
      stress('sigma_y_Pa', 'σ_y', 'yield stress', 1e4, 2e10, 100e6), plain('nu', 'ν', "Poisson's ratio", 0, 0.45, 0.3)],
    beside: ['hertz', 'similarity'],
  },
  ludwik: { // flow stress sigma_y + K eps^(1/n)
    title: 'Metal that hardens', says: 'gets stronger where it is strained', card: 'von-mises', fixed: { 'hardening.kind': 'ludwik' },
    parameters: [stress('E_Pa', 'E', "Young's modulus", 1e6, 1e12, 70e9),
      stress('sigma_y_Pa', 'σ_y', 'yield stress, where it begins', 1e4, 2e10, 100e6),
      { ...stress('K_Pa', 'K', 'what a strain of 1 adds to it', 1e4, 2e11, 200e6), card: 'hardening.K_Pa' },
      { ...plain('inverse_n', '1/n', 'hardening exponent', 0.1, 1, 0.4), card: 'hardening.inverse_n' },
      plain('nu', 'ν', "Poisson's ratio", 0, 0.45, 0.3)],
    beside: ['hertz', 'jackson-green'],
  },
  vmdc: {
    title: 'Porous granule', says: 'compacts while it is pressed',
    parameters: [stress('sigma_y_Pa', 'σ_y', 'compressive strength, as it is', 1e4, 2e9, 150e6),
      ratio('E_bar', 'E/σ_y', 'stiffness over strength', 3, 1000, 100),
      plain('rho_r0', 'ρ_r0', 'relative density', 0.25, 0.98, 0.7), plain('nu', 'ν', "Poisson's ratio", 0, 0.45, 0.3),
      ratio('Gamma_bar', 'Γ/σ_y', 'shear over compressive strength', 0.2, 2, 1),
      ratio('Lambda_bar', 'Λ/σ_y', 'tensile over compressive strength', 0.0005, 0.5, 0.01)],
    more: [plain('epsilon', 'ε', 'length of the cap', 0.02, 1.2, 0.7), plain('eta', 'η', 'hardening of σ_y with density', 1, 25, 10),
      plain('xi', 'ξ', 'hardening of E', 1, 25, 7.5), plain('zeta', 'ζ', 'hardening of Γ', 1, 25, 10),
      plain('omega', 'ω', 'hardening of Λ', 1, 25, 10), plain('xi_1', 'ξ₁', "slope of Poisson's ratio", 0, 1.2, 0.4),
      plain('xi_2', 'ξ₂', 'slope of the cap', 0, 4, 1.5)],
    beside: ['hertz', 'edmans-sinka'],
  },
  rock: { // Drucker-Prager, associated
    title: 'Rock or sand', says: 'a grain whose strength grows with pressure', card: 'drucker-prager',
    parameters: [stress('E_Pa', 'E', "Young's modulus", 1e9, 1e11, 10e9),
      stress('sigma_c_Pa', 'σ_c', 'uniaxial compressive strength', 1e6, 1e9, 15e6),
      { ...plain('phi_deg', 'φ', 'friction angle', 10, 50, 25), unit: '°' }, plain('nu', 'ν', "Poisson's ratio", 0, 0.45, 0.15)],
    beside: ['hertz', 'wang'],
  },
  elastic: {
    title: 'Elastic', says: 'springs back',
    parameters: [stress('E_Pa', 'E', "Young's modulus", 1e4, 1e12, 10e9), plain('nu', 'ν', "Poisson's ratio", 0, 0.45, 0.3)],
    beside: ['hertz'],
  },
};

export const particle = [
  { key: 'radius_m', symbol: 'R', name: 'radius', unit: 'm', log: true, low: 1e-7, high: 0.1, start: 0.5e-3 },
  { key: 'density', symbol: 'ρ', name: 'density of the particle', unit: 'kg/m³', log: true, low: 50, high: 25000, start: 1500 },
];

export const allOf = (model) => [...models[model].parameters, ...(models[model].more ?? [])];
// What a card says of them: its model, and key=value lines of its parameters.
export const cardOf = (model) => models[model].card ?? model;
export const lines = (model, values) => [...Object.entries(models[model].fixed ?? {}),
  ...allOf(model).map((p) => [p.card ?? p.key, values[p.key]])].map(([key, value]) => `${key}=${value}`);
export const starting = (parameters) => Object.fromEntries(parameters.map((p) => [p.key, p.start]));

export function positionOf(p, value) {
  const f = p.log ? Math.log : (x) => x;
  return Math.round(1000 * Math.min(1, Math.max(0, (f(value) - f(p.low)) / (f(p.high) - f(p.low)))));
}
export function valueAt(p, position) {
  const u = position / 1000;
  const value = p.log ? Math.exp(Math.log(p.low) + u * Math.log(p.high / p.low)) : p.low + u * (p.high - p.low);
  return Number(value.toPrecision(3));
}

/// The kind of material of a card.
export const modelOf = (card) => (card.model === 'drucker-prager' ? 'rock' : card.model);
/// A card of the catalogue in the sliders' words.
export function fromCard(card) {
  const values = starting(allOf(card.model));
  const of = card.parameters;
  for (const key of Object.keys(values)) {
    if (key in of) values[key] = of[key];
    else if (key.endsWith('_bar')) values[key] = Number((of[key.slice(0, -4) + '_Pa'] / of.sigma_y_Pa).toPrecision(12));
  }
  return values;
}

// Three questions for those who know no parameter.
export const questions = [
  { key: 'what', text: 'What is it?', answers: [
    ['vmdc', 'A granule or tablet of powder', 'it packs denser when squeezed'],
    ['von-mises', 'A ball of metal or plastic', 'it dents and stays dented'],
    ['rock', 'A grain of rock or sand', 'hard, and its contacts crush'],
    ['elastic', 'Something that springs back', 'glass, rubber, ceramic']] },
  { key: 'hard', text: 'How hard does it feel?', answers: [
    [0, 'Crumbles between fingers', ''], [1, 'A fingernail marks it', ''], [2, 'A knife marks it', ''], [3, 'Hardly anything does', '']] },
  { key: 'fine', text: 'How fine is it?', answers: [
    [25e-6, 'Like flour', 'some hundredths of a millimetre'], [150e-6, 'Like salt', 'a third of a millimetre'],
    [0.75e-3, 'Like coarse sand', 'a millimetre or two'], [4e-3, 'Like peas', 'some millimetres']] },
];
const strengths = { vmdc: [1e6, 8e6, 40e6, 150e6], 'von-mises': [1e6, 15e6, 150e6, 1e9], rock: [5e6, 10e6, 20e6, 40e6], elastic: [1e6, 1e9, 30e9, 200e9] };
const densities = { vmdc: 1000, 'von-mises': 7800, rock: 2650, elastic: 2500 };

/// The nearest card, its stresses brought to what was answered where the catalogue has one card alone.
export function answered({ what, hard, fine }, cards) {
  const wanted = strengths[what][hard], key = { elastic: 'E_Pa', rock: 'sigma_c_Pa' }[what] ?? 'sigma_y_Pa';
  const own = cards.filter((card) => card.model === what && (what !== 'rock' || card.parameters.nu <= 0.3)); // as its pool
  const far = (card) => Math.abs(Math.log(card.parameters[key] / wanted));
  const card = own.reduce((best, one) => (far(one) < far(best) ? one : best));
  const values = fromCard(card);
  let note = `Started from the card “${card.name}”.`;
  if (own.length === 1 && far(card) > 0.1) {
    const by = wanted / card.parameters[key];
    for (const p of allOf(what)) if (p.unit === 'Pa') values[p.key] = Number((values[p.key] * by).toPrecision(6));
    note = `Started from the card “${card.name}”, its stresses times ${Number(by.toPrecision(3))}.`;
  }
  return { model: what, values, radius_m: fine, density: densities[what], note, name: card.name };
}
