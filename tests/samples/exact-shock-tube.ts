/** The exact solution of Sod's shock tube with gamma = 1.4 (Toro, "Riemann Solvers", chapter 4). */

const gamma = 1.4;

export interface State {
  density: number;
  velocity: number;
  pressure: number;
}

const left: State = { density: 1, velocity: 0, pressure: 1 };
const right: State = { density: 0.125, velocity: 0, pressure: 0.1 };

const soundOf = (state: State) => Math.sqrt((gamma * state.pressure) / state.density);

/** By how much a wave into `side` changes the velocity when it brings the pressure to `pressure`. */
function velocityChange(side: State, pressure: number): number {
  if (pressure > side.pressure) {
    const a = 2 / ((gamma + 1) * side.density);
    const b = ((gamma - 1) / (gamma + 1)) * side.pressure;
    return (pressure - side.pressure) * Math.sqrt(a / (pressure + b));
  }
  return ((2 * soundOf(side)) / (gamma - 1)) * ((pressure / side.pressure) ** ((gamma - 1) / (2 * gamma)) - 1);
}

/** The pressure between the two waves, by bisection. */
function middlePressure(): number {
  let [low, high] = [right.pressure, left.pressure];
  for (let i = 0; i < 60; ++i) {
    const middle = (low + high) / 2;
    const excess = velocityChange(left, middle) + velocityChange(right, middle) + right.velocity - left.velocity;
    [low, high] = excess < 0 ? [middle, high] : [low, middle];
  }
  return (low + high) / 2;
}

/** The state at `speed` = (x - x of the membrane) / time: rarefaction to the left, contact, shock to the right. */
export function exactShockTube(speed: number): State {
  const pressure = middlePressure();
  const velocity = velocityChange(right, pressure);
  const ratio = (gamma - 1) / (gamma + 1);
  const shock =
    soundOf(right) * Math.sqrt(((gamma + 1) / (2 * gamma)) * (pressure / right.pressure) + (gamma - 1) / (2 * gamma));
  if (speed > shock) return right;
  if (speed > velocity) {
    const compression = pressure / right.pressure;
    return { density: (right.density * (compression + ratio)) / (ratio * compression + 1), velocity, pressure };
  }
  const expanded = { density: (pressure / left.pressure) ** (1 / gamma) * left.density, velocity, pressure };
  if (speed > velocity - soundOf(expanded)) return expanded;
  if (speed < -soundOf(left)) return left;
  const inFan = (2 / (gamma + 1)) * (soundOf(left) + speed);
  const sound = soundOf(left) - ((gamma - 1) / 2) * inFan;
  const density = left.density * (sound / soundOf(left)) ** (2 / (gamma - 1));
  return { density, velocity: inFan, pressure: (density * sound * sound) / gamma };
}
