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
    let x20 = v[2] * parameters[1];
    let x22 = parameters[1] * cos12;
    let x24 = cos12 * (parameters[0] - parameters[1]);
    let x28 = v[0] * (x20 - v[0] * x24) - parameters[4] * (parameters[2] * parameters[3]);
    let x34 = v[1] * (sin12 * (v[0] * (2.0 * x24) - x20));
    let x38 = 1.0 / (parameters[0] * (sin12 * sin12) + parameters[1] * (cos12 * cos12));
    let x39 = x22 * x38;
    let x49 = (sin12 * (parameters[1] * (v[0] * v[1])) + x34 * x39) / (parameters[1] - x22 * x39);
    [-(x34 * x38 + x39 * x49), -(sin12 * x28 / parameters[0]), x49]
}
