//! The words about the theorems, before their statements.

use cordon_core::theorems::{self, words};
use cordon_spec::theorems::{Form, Theorem};

/// The theories of the theorems with, for each line `%% 7.2`, the paper's form, the sharp form
/// that follows and the erratum as comments.
pub(super) fn with_words(theories: &str) -> String {
    let mut text = String::new();
    for line in theories.lines() {
        let number = line.trim_start().strip_prefix("%% ");
        match Theorem::ALL.into_iter().find(|t| number == Some(t.number())) {
            Some(theorem) => comment(theorem, &mut text),
            None => {
                text.push_str(line);
                text.push('\n');
            }
        }
    }
    text
}

fn comment(theorem: Theorem, text: &mut String) {
    let t = words(theorem);
    wrapped(&format!("{} {}.", theorem.number(), t.name), text);
    for (label, form) in [("Paper", Form::Paper), ("Sharp", Form::Sharp)] {
        let h = theorem.hypothesis(form);
        let (weights, starts) = (theorems::weights(h.weights), theorems::starts(h.starts));
        wrapped(&format!("{label}: if {weights}; {starts} then {}.", t.conclusion(form)), text);
    }
    if let Some(erratum) = t.erratum {
        wrapped(&format!("Erratum: {erratum}."), text);
    }
}

/// Widest comment line.
const WIDTH: usize = 90;

fn wrapped(words: &str, text: &mut String) {
    let mut line = String::from("  %");
    for word in words.split_whitespace() {
        if line.len() + 1 + word.len() > WIDTH && line.len() > 3 {
            text.push_str(&line);
            line = String::from("\n  %  ");
        }
        line.push(' ');
        line.push_str(word);
    }
    text.push_str(&line);
    text.push('\n');
}
