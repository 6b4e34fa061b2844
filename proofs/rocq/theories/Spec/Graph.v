(* Undirected communication graphs. *)
From Coq Require Import Arith Bool List.

(* Rust: spec/src/graph.rs Graph.  The drones are 0 .. graph_count - 1. *)
Record Graph : Type := mkGraph {
  graph_count : nat;
  linked : nat -> nat -> bool;
  linked_sym : forall i j, linked i j = linked j i
}.

(* Rust: spec/src/graph.rs neighbourhood, filtered by `linked` as its callers do. *)
Definition neighbours (g : Graph) (i : nat) : list nat :=
  filter (linked g i) (seq 0 (graph_count g)).

Definition path_linked (N i j : nat) : bool :=
  ((i + 1 =? j) && (j <? N)) || ((j + 1 =? i) && (i <? N)).

Lemma path_linked_sym : forall N i j, path_linked N i j = path_linked N j i.
Proof. intros N i j; unfold path_linked; apply orb_comm. Qed.

(* Rust: spec/src/graph.rs Path *)
Definition path (N : nat) : Graph := mkGraph N (path_linked N) (path_linked_sym N).

Definition is_edge (i j : nat) (e : nat * nat) : bool :=
  ((fst e =? i) && (snd e =? j)) || ((fst e =? j) && (snd e =? i)).

Definition edge_linked (edges : list (nat * nat)) (i j : nat) : bool :=
  negb (i =? j) && existsb (is_edge i j) edges.

Lemma edge_linked_sym : forall edges i j, edge_linked edges i j = edge_linked edges j i.
Proof.
  intros edges i j; unfold edge_linked; rewrite (Nat.eqb_sym j i); f_equal.
  induction edges as [|e edges IH]; [reflexivity|]; simpl; rewrite IH; f_equal.
  unfold is_edge; apply orb_comm.
Qed.

(* Rust: spec/src/graph.rs Edges *)
Definition edge_graph (N : nat) (edges : list (nat * nat)) : Graph :=
  mkGraph N (edge_linked edges) (edge_linked_sym edges).
