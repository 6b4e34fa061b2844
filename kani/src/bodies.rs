//! The bodies that harnesses about theorems share.

use cordon_spec::theorems::{Form, Theorem, Verdict};

use crate::bounds::Bounds;
use crate::line::{Line, same};
use crate::source::{Case, Source, Witness};

/// Draws a line that meets the theorem's hypothesis (sharp form).
pub fn meeting<const N: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    bounds: &Bounds,
) -> Option<Line<N>> {
    let line = Line::<N>::draw(source, bounds)?;
    let hypothesis = theorem.hypothesis(Form::Sharp);
    source.assume(hypothesis.met_by(&line.setting, line.start()).is_true())?;
    Some(line)
}

/// The induction step: from any placement that meets the theorem's hypothesis (sharp form), one
/// protocol step leads to one whose start set contains it and of which the conclusion holds. So
/// both hold for every k, while the numerators stay in the domain.
///
/// Witness: a drone has moved.
pub fn preserved<const N: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    bounds: &Bounds,
) -> Case {
    let line = meeting::<N, S>(source, theorem, bounds)?;
    let next = line.next();
    let verdict = theorem.conclusion(Form::Sharp, &line.setting, &[next]);
    assert!(verdict == Verdict::Holds, "the conclusion holds after a step");
    let kept = theorem.hypothesis(Form::Sharp).starts.contains(&line.setting, &next);
    assert!(kept.is_true(), "the start set contains the placement after a step");
    Some(Witness(!same(line.start(), &next)))
}

/// The run X^0, ..., X^{K-1} from any start that meets the hypothesis (sharp form): the
/// conclusion about every step of it that the run is long enough for.
///
/// Witness: some conclusion holds and is not vacuous.
pub fn along_a_run<const N: usize, const K: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    bounds: &Bounds,
) -> Case {
    let line = meeting::<N, S>(source, theorem, bounds)?;
    let run = line.run::<K>();
    let span = theorem.span(Form::Sharp, N);
    let mut seen = false;
    for k in 0..K - span {
        let verdict = theorem.conclusion(Form::Sharp, &line.setting, &run[k..=k + span]);
        assert!(
            matches!(verdict, Verdict::Holds | Verdict::Vacuous),
            "the conclusion holds about a step"
        );
        seen |= verdict == Verdict::Holds;
    }
    Some(Witness(seen))
}
