/// The accelerations of `heavy_top`, derived from its Lagrangian.
///
/// - `q`, the coordinates; `v`, their velocities; the result, their accelerations:
///   0: `\phi`
///   1: `\theta`
///   2: `\psi`
/// - `parameters`:
///   0: `\lambda_1`
///   1: `\lambda_3`
///   2: `M`
///   3: `g`
///   4: `R`
///
/// Where the mass matrix is singular the result is not finite.
pub fn accelerations(
    _time: f64,
    q: &[f64; 3],
    v: &[f64; 3],
    parameters: &[f64; 5],
) -> [f64; 3] {
    let (sin12, cos12) = q[1].sin_cos();
    let x17 = v[2] * parameters[1];
    let x24 = v[0] * (x17 - v[0] * (cos12 * (parameters[0] - parameters[1]))) - parameters[4] * (parameters[2] * parameters[3]);
    let x37 = v[1] * (sin12 * (x17 + v[0] * (cos12 * (parameters[1] + -2.0 * parameters[0]))));
    let x39 = x37 / (parameters[0] * (sin12 * sin12));
    [x39, -(sin12 * x24 / parameters[0]), sin12 * (v[0] * v[1]) - cos12 * x39]
}
