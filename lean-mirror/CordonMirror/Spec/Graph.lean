import CordonMirror.Spec.DroneMap

/-! Undirected communication graphs. -/

namespace CordonMirror

/-- Rust: spec/src/graph.rs Graph -/
structure Graph where
  count : Nat
  linked : Nat → Nat → Bool

/-- Rust: spec/src/graph.rs neighbourhood, filtered by `linked` as its callers do. -/
def neighbours (g : Graph) (i : Nat) : List Nat :=
  List.filter (fun j => g.linked i j) (lambda g.count (fun j => j))

/-- Rust: spec/src/graph.rs Path -/
def path (N : Nat) : Graph :=
  Graph.mk N (fun i j =>
    decide (i + 1 = j ∧ j < N) || decide (j + 1 = i ∧ i < N))

/-- Rust: spec/src/graph.rs Edges -/
def edge_graph (N : Nat) (edges : List (Nat × Nat)) : Graph :=
  Graph.mk N (fun i j =>
    decide (i ≠ j) &&
      edges.any (fun e =>
        decide (e.1 = i ∧ e.2 = j) || decide (e.1 = j ∧ e.2 = i)))

end CordonMirror
