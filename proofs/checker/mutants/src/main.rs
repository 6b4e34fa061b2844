//! `mutants SOURCES DESTINATION LIST`: writes the sources anew with every mutant in them, and a list of the mutants.
//!
//! Where `MUTANT` names a number at run time, that one change is in force: another operator, a negation left out, an
//! arm or a guard of a match decided, a condition that is needed taken as met, a body that returns at once. So hundreds
//! of mutants take one build.

use std::error::Error;
use std::fs;
use std::path::Path;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Arm, BinOp, Block, Expr, ImplItemFn, ItemConst, ItemFn, Macro, Pat, ReturnType, Signature,
    Token, UnOp,
};

/// What is appended to the root of the crate. The first test that fails, and the first panic, ends the program.
const SWITCH: &str = "
/// Whether that mutant is in force.
pub fn mutant(number: u32) -> bool {
    static CHOSEN: std::sync::OnceLock<Option<u32>> = std::sync::OnceLock::new();
    *CHOSEN.get_or_init(|| {
        let chosen = std::env::var(\"MUTANT\").ok()?.parse().ok();
        std::panic::set_hook(Box::new(|_| std::process::exit(101)));
        chosen
    }) == Some(number)
}
";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [from, to, list] = arguments.as_slice() else {
        return Err("usage: mutants SOURCES DESTINATION LIST".into());
    };
    let mut mutator = Mutator::default();
    mutator.folder(Path::new(from), Path::new(to))?;
    fs::write(list, mutator.list.join("\n") + "\n")?;
    Ok(())
}

#[derive(Default)]
struct Mutator {
    /// `file: change in function`, a line each.
    list: Vec<String>,
    file: String,
    functions: Vec<String>,
}

impl Mutator {
    fn folder(&mut self, from: &Path, to: &Path) -> Result<(), Box<dyn Error>> {
        fs::create_dir_all(to)?;
        let mut paths = fs::read_dir(from)?
            .map(|e| Ok(e?.path()))
            .collect::<Result<Vec<_>, std::io::Error>>()?;
        paths.sort();
        for path in paths {
            let name = path.file_name().and_then(|n| n.to_str()).unwrap_or_default();
            if path.is_dir() {
                self.folder(&path, &to.join(name))?;
                continue;
            }
            let text = fs::read_to_string(&path)?;
            // The program is tested as it is.
            let text = if name == "main.rs" { text } else { self.file(name, &text)? };
            fs::write(to.join(name), text)?;
        }
        Ok(())
    }

    fn file(&mut self, name: &str, text: &str) -> syn::Result<String> {
        let mut file = syn::parse_file(text)?;
        name.clone_into(&mut self.file);
        self.visit_file_mut(&mut file);
        let is_root = name == "lib.rs";
        Ok(file.into_token_stream().to_string() + if is_root { SWITCH } else { "" })
    }

    /// Whether one more mutant is in force, as code.
    fn switch(&mut self, change: &str) -> TokenStream {
        let function = self.functions.last().map_or("", String::as_str);
        self.list.push(format!("{}: {change} in {function}", self.file));
        let number = Literal::usize_unsuffixed(self.list.len());
        quote!(crate::mutant(#number))
    }

    /// Puts another value at the beginning of a body, for each that is easily had.
    fn body(&mut self, signature: &Signature, block: &mut Block) {
        let returned = match &signature.output {
            ReturnType::Default => String::new(),
            ReturnType::Type(_, t) => t.to_token_stream().to_string().replace(' ', ""),
        };
        let values: &[&str] = match returned.as_str() {
            "" => &["()"],
            "bool" => &["true", "false"],
            "u8" | "u64" | "usize" => &["0", "1"],
            "String" => &["String::new()"],
            "fmt::Result" | "Result<()>" => &["Ok(())"],
            "Result<bool>" => &["Ok(true)", "Ok(false)"],
            "Result<String>" => &["Ok(String::new())"],
            "Result<Shown>" => &["Ok((String::new(), 1))"],
            "Result<Poly>" => &["Ok(Poly::default())"],
            "Nodes<'c>" => &["Nodes::new()"],
            _ if returned.starts_with("Option<") => &["None"],
            _ if returned.starts_with("Vec<") => &["Vec::new()"],
            _ if returned.starts_with("Result<Vec<") => &["Ok(Vec::new())"],
            _ => &[],
        };
        let mut early = TokenStream::new();
        for value in values {
            let on = self.switch(&format!("replace body with {value}"));
            let value: TokenStream = value.parse().unwrap_or_default();
            early.extend(quote!(if #on { return #value; }));
        }
        let rest = &block.stmts;
        if let Ok(changed) = syn::parse2(quote!({ #early #(#rest)* })) {
            *block = changed;
        }
    }

    /// Lets an arm be passed over, or taken whatever its guard says.
    fn arm(&mut self, arm: &mut Arm, before: &Arm, may_go: bool) {
        let pattern = arm.pat.to_token_stream();
        match (&mut arm.guard, &before.guard) {
            (Some((_, guard)), Some((_, original))) if !binds(original) => {
                let taken = self.switch(&format!("replace guard of `{pattern}` with true"));
                let passed = self.switch(&format!("replace guard of `{pattern}` with false"));
                **guard = Expr::Verbatim(quote!((#taken || (!#passed && #guard))));
            }
            (None, _) if may_go => {
                let on = self.switch(&format!("delete arm `{pattern}`"));
                let guard = Expr::Verbatim(quote!((!#on)));
                arm.guard = Some((Default::default(), Box::new(guard)));
            }
            _ => {}
        }
    }
}

impl VisitMut for Mutator {
    fn visit_item_const_mut(&mut self, _: &mut ItemConst) {}

    fn visit_pat_mut(&mut self, _: &mut Pat) {}

    fn visit_item_fn_mut(&mut self, f: &mut ItemFn) {
        self.functions.push(f.sig.ident.to_string());
        visit_mut::visit_item_fn_mut(self, f);
        self.body(&f.sig, &mut f.block);
        self.functions.pop();
    }

    fn visit_impl_item_fn_mut(&mut self, f: &mut ImplItemFn) {
        self.functions.push(f.sig.ident.to_string());
        visit_mut::visit_impl_item_fn_mut(self, f);
        self.body(&f.sig, &mut f.block);
        self.functions.pop();
    }

    /// What is needed is changed, or taken as met.
    fn visit_macro_mut(&mut self, m: &mut Macro) {
        let parser = Punctuated::<Expr, Token![,]>::parse_terminated;
        let (true, Ok(mut parts)) = (m.path.is_ident("ensure"), parser.parse2(m.tokens.clone()))
        else {
            return;
        };
        if let Some(holds) = parts.first_mut() {
            self.visit_expr_mut(holds);
            let on = self.switch("replace what is needed with true");
            *holds = Expr::Verbatim(quote!((#on || #holds)));
        }
        m.tokens = parts.into_token_stream();
    }

    fn visit_expr_mut(&mut self, e: &mut Expr) {
        let before = e.clone();
        visit_mut::visit_expr_mut(self, e);
        match before {
            Expr::Binary(b) if !binds(&b.left) && !binds(&b.right) && !appends(&b.op, &b.right) => {
                for other in others(&b.op) {
                    let on =
                        self.switch(&format!("replace {} with {other}", b.op.to_token_stream()));
                    let op: TokenStream = other.parse().unwrap_or_default();
                    let (left, right) = (&b.left, &b.right);
                    *e = Expr::Verbatim(quote!((if #on { (#left) #op (#right) } else { #e })));
                }
            }
            Expr::Unary(u) if matches!(u.op, UnOp::Not(_) | UnOp::Neg(_)) => {
                let on = self.switch(&format!("delete {}", u.op.to_token_stream()));
                let inside = &u.expr;
                *e = Expr::Verbatim(quote!((if #on { #inside } else { #e })));
            }
            Expr::Match(original) => {
                let Expr::Match(m) = e else { return };
                let may_go = original.arms.iter().any(takes_all);
                let most = m.arms.len().saturating_sub(1);
                for (n, (arm, before)) in m.arms.iter_mut().zip(&original.arms).enumerate() {
                    self.arm(arm, before, may_go && n < most);
                }
            }
            _ => {}
        }
    }
}

/// The operators in the place of one.
fn others(op: &BinOp) -> &'static [&'static str] {
    match op {
        BinOp::Eq(_) => &["!="],
        BinOp::Ne(_) => &["=="],
        BinOp::And(_) => &["||"],
        BinOp::Or(_) => &["&&"],
        BinOp::Lt(_) => &["==", ">", "<="],
        BinOp::Gt(_) => &["==", "<", ">="],
        BinOp::Le(_) => &["==", ">", "<"],
        BinOp::Ge(_) => &["==", "<", ">"],
        BinOp::Add(_) => &["-", "*"],
        BinOp::Sub(_) | BinOp::Mul(_) => &["+"],
        BinOp::Div(_) | BinOp::Rem(_) => &["*"],
        BinOp::AddAssign(_) => &["-=", "*="],
        BinOp::SubAssign(_) => &["+="],
        BinOp::BitOrAssign(_) => &["&="],
        _ => &[],
    }
}

/// Whether text is appended: there is no other operator.
fn appends(op: &BinOp, right: &Expr) -> bool {
    matches!((op, right), (BinOp::AddAssign(_), Expr::Reference(_)))
}

/// Whether it binds names by `let`, which stand for nothing elsewhere.
fn binds(e: &Expr) -> bool {
    match e {
        Expr::Let(_) => true,
        Expr::Binary(b) => binds(&b.left) || binds(&b.right),
        _ => false,
    }
}

/// Whether an arm takes what the others leave.
fn takes_all(arm: &Arm) -> bool {
    let small = |name: String| name.starts_with(char::is_lowercase);
    arm.guard.is_none()
        && match &arm.pat {
            Pat::Wild(_) => true,
            Pat::Ident(name) => name.subpat.is_none() && small(name.ident.to_string()),
            _ => false,
        }
}
