//! Every function of the spec has a harness, or stands in `exceptions.tsv` with the reason.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use cordon_kani::all;
use syn::visit::{self, Visit};

/// Collects the paths of functions: `coverage::exec_cvg`, `theorems::Theorem::span`. A method of
/// a trait that is implemented for a type of elsewhere goes by the trait's name.
struct Functions {
    at: Vec<String>,
    own: BTreeSet<String>,
    found: BTreeSet<String>,
}

impl Functions {
    fn add(&mut self, name: &syn::Ident) {
        let mut path = self.at.clone();
        path.push(name.to_string());
        self.found.insert(path.join("::"));
    }

    fn within(&mut self, name: &str, visit: impl FnOnce(&mut Self)) {
        self.at.push(name.to_owned());
        visit(self);
        self.at.pop();
    }
}

/// Whether only the contracts know the function.
fn is_logic(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("logic"))
}

fn last(path: &syn::Path) -> String {
    path.segments.last().unwrap().ident.to_string()
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.add(&item.sig.ident);
        visit::visit_item_fn(self, item);
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        self.within(&item.ident.to_string(), |s| visit::visit_item_trait(s, item));
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if is_logic(&item.attrs) {
            return;
        }
        self.add(&item.sig.ident);
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let of = match &*item.self_ty {
            syn::Type::Path(path) if self.own.contains(&last(&path.path)) => last(&path.path),
            _ => last(&item.trait_.as_ref().expect("an own type, or a trait").1),
        };
        self.within(&of, |s| visit::visit_item_impl(s, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if is_logic(&item.attrs) {
            return;
        }
        self.add(&item.sig.ident);
        visit::visit_impl_item_fn(self, item);
    }
}

fn functions_below(folder: &Path, module: &[String], found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
        // The logic of the contracts, which no build has.
        if stem == "model" {
            continue;
        }
        let below = |name: &str| [module, &[name.to_owned()]].concat();
        if path.is_dir() {
            functions_below(&path, &below(&stem), found);
            continue;
        }
        let at =
            if matches!(stem.as_str(), "lib" | "mod") { module.to_vec() } else { below(&stem) };
        let file = syn::parse_file(&fs::read_to_string(&path).unwrap()).unwrap();
        let own = file.items.iter().filter_map(|item| match item {
            syn::Item::Struct(s) => Some(s.ident.to_string()),
            syn::Item::Enum(e) => Some(e.ident.to_string()),
            _ => None,
        });
        let own = own.collect();
        let mut functions = Functions { at, own, found: BTreeSet::new() };
        functions.visit_file(&file);
        found.extend(functions.found);
    }
}

fn spec() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../spec/src");
    functions_below(&folder, &[], &mut found);
    found
}

fn exceptions() -> BTreeMap<String, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("exceptions.tsv");
    let text = fs::read_to_string(path).unwrap();
    let rows = text.lines().skip(1).map(|line| {
        let (function, reason) = line.split_once('\t').expect("function and reason");
        assert!(!reason.trim().is_empty(), "{function} has no reason");
        (function.to_owned(), reason.to_owned())
    });
    rows.collect()
}

#[test]
fn every_function_of_the_spec_has_a_harness_or_a_reason() {
    let (spec, exceptions) = (spec(), exceptions());
    assert!(spec.len() > 80, "{} functions", spec.len());
    let executed: BTreeSet<_> = all().flat_map(|h| h.functions).map(|f| (*f).to_owned()).collect();
    let mut problems = Vec::new();
    for function in &spec {
        match (executed.contains(function), exceptions.contains_key(function)) {
            (false, false) => problems.push(format!("`{function}` has neither harness nor reason")),
            (true, true) => problems.push(format!("`{function}` has a harness: no exception")),
            _ => {}
        }
    }
    for function in executed.iter().chain(exceptions.keys()).filter(|f| !spec.contains(*f)) {
        problems.push(format!("the spec has no `{function}`"));
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn functions_are_found_where_they_are() {
    let found = spec();
    for function in [
        "coverage::exec_cvg",
        "drone_map::DroneMap::lambda",
        "graph::Edges::linked",
        "theorems::Theorem::span",
        "theorems::hypothesis::below_critical",
        "theorems::Setting::from",
        "scalar::Scalar::from_index",
    ] {
        assert!(found.contains(function), "`{function}` was not found among {found:?}");
    }
}
