//! A chain of n pendulums: what its equations of motion cost, counted.

use onshell::mechanics::System;
use onshell::systems::Pendulum;
use proptest::prelude::*;

use crate::support::{agree, by_hessian, config, state};

fn chain<const N: usize>() -> System {
    System::new(&Pendulum::<N>::new()).unwrap()
}

#[test]
fn the_operations_grow_as_the_entries_of_the_mass_matrix() {
    let [eight, sixteen, thirty_two] =
        [chain::<8>(), chain::<16>(), chain::<32>()].map(|chain| chain.operations_before_solving() as f64);
    assert!(sixteen / eight < 4.6 && thirty_two / sixteen < 4.6, "{eight} {sixteen} {thirty_two}");
    // the twin: with the elimination they grow faster, beyond the same bound
    let with_solving = [chain::<16>(), chain::<32>()].map(|chain| chain.operations() as f64);
    assert!(with_solving[1] / with_solving[0] > 4.6, "{with_solving:?}");
}

proptest! {
    #![proptest_config(config(8))]

    #[test]
    fn a_chain_moves_as_the_plain_hessian_says(at in state::<6, 3>()) {
        let plain = by_hessian::<_, 6, 3, 13>(&Pendulum::<6>::new(), &at);
        let system = chain::<6>();
        let mut accelerator = system.acceleration_evaluator(&at.parameters);
        let fast = accelerator.accelerations(at.time, &at.q, &at.v).unwrap();
        prop_assert!(agree(&plain, fast, 1e-11), "{plain:?} {fast:?}");
        // the twin: the last two links exchanged
        let mut exchanged = fast.to_vec();
        exchanged.swap(4, 5);
        prop_assert!(!agree(&plain, &exchanged, 1e-9));
    }
}
