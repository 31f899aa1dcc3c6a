//! No function is longer than a reader can hold, unless a reason stands beside it.

use crate::source::{Token, files, tokens};
use std::collections::BTreeSet;

/// Most lines of code of a function, its signature included; comments and empty lines are none.
const LINES: usize = 80;

/// Most branches: `if`, `while`, `for`, `else` of a `let`, arms of a `match`, `&&`, `||` and `?`.
const BRANCHES: usize = 20;

/// What stands above a function that may be longer, with why.
const REASON: &str = "// long: ";

/// A function and its size.
#[derive(Debug)]
struct Function {
    name: String,
    /// Line of its `fn`, counted from 1.
    line: usize,
    lines: usize,
    branches: usize,
}

impl Function {
    fn is_long(&self) -> bool {
        self.lines > LINES || self.branches > BRANCHES
    }
}

/// Every function of a file, those within functions and impls included.
fn functions(text: &str) -> Vec<Function> {
    let tokens = tokens(text);
    let names = tokens.windows(2).enumerate();
    let named = |(at, pair): (usize, &[Token])| {
        let word = pair[1]
            .text
            .starts_with(|c: char| c.is_alphabetic() || c == '_');
        (pair[0].text == "fn" && word).then_some(at)
    };
    names
        .filter_map(named)
        .filter_map(|at| {
            let own = &tokens[at..=end(&tokens, at)?];
            let lines: BTreeSet<usize> = own.iter().flat_map(|t| t.lines[0]..=t.lines[1]).collect();
            Some(Function {
                name: own[1].text.clone(),
                line: own[0].lines[0],
                lines: lines.len(),
                branches: (0..own.len()).filter(|&i| is_branch(own, i)).count(),
            })
        })
        .collect()
}

/// Index of the brace that ends the function whose `fn` is at `start`; `None` without a body.
fn end(tokens: &[Token], start: usize) -> Option<usize> {
    let (mut round, mut curly) = (0_i32, 0_i32);
    for (at, token) in tokens.iter().enumerate().skip(start) {
        match token.text.as_str() {
            "(" | "[" => round += 1,
            ")" | "]" => round -= 1,
            ";" if round == 0 && curly == 0 => return None,
            "{" => curly += 1,
            "}" => {
                curly -= 1;
                if curly == 0 {
                    return Some(at);
                }
            }
            _ => {}
        }
    }
    None
}

fn is_branch(tokens: &[Token], at: usize) -> bool {
    let before = at.checked_sub(1).map_or("", |i| tokens[i].text.as_str());
    // what ends an operand: a name, a number, a literal, or something closed
    let word = before.starts_with(|c: char| c.is_alphanumeric() || c == '_' || c == '"');
    let verb = ["return", "move", "in", "match", "if", "else", "while"].contains(&before);
    let operand = (word && !verb) || [")", "]", "}", "?", "'"].contains(&before);
    match tokens[at].text.as_str() {
        "if" | "while" | "=>" => true,
        // not `for<'a>`, nor `impl A for B`
        "for" => tokens.get(at + 1).is_some_and(|next| next.text != "<") && (verb || !word),
        "else" => before != "}",
        "&&" | "||" | "?" => operand,
        _ => false,
    }
}

/// The lines right above a line, up to one that is neither a comment nor an attribute.
fn above(text: &str, line: usize) -> Vec<&str> {
    let lines: Vec<&str> = text.lines().take(line - 1).map(str::trim).collect();
    let beside = |line: &&&str| line.starts_with("//") || line.starts_with("#[");
    lines.iter().rev().take_while(beside).copied().collect()
}

/// What is wrong with the functions of a file, one sentence each.
fn violations(file: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for function in functions(text) {
        let Function {
            name,
            line,
            lines,
            branches,
        } = &function;
        let above = above(text, *line);
        let reason = above.iter().find_map(|line| line.strip_prefix(REASON));
        let given = reason.is_some_and(|why| why.split_whitespace().count() >= 3);
        let size = format!("{file}: {name} has {lines} lines of code and {branches} branches");
        match (function.is_long(), given) {
            (true, false) => found.push(format!("{size}, and no `{REASON}why` right above it")),
            (false, _) if reason.is_some() => {
                found.push(format!("{size}, and a reason to be long"))
            }
            _ => {}
        }
    }
    found
}

#[test]
fn no_function_is_long_without_a_reason_beside_it() {
    let mut found = Vec::new();
    let mut seen = 0;
    for (file, text) in files("src") {
        seen += functions(&text).len();
        if file.ends_with("/tests.rs") {
            continue;
        }
        found.extend(violations(&file, &text));
    }
    assert!(seen > 2000, "only {seen} functions were read");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A function with a body of so many lines, each of which is `line`.
fn planted(lines: usize, line: &str) -> String {
    format!("{{\n{}}}", format!("    {line}\n").repeat(lines))
}

#[test]
fn planted_long_functions_are_seen() {
    let long = planted(LINES - 1, "f();");
    let short = planted(LINES - 2, "f();\n    // a comment\n");
    let branched = planted(BRANCHES / 2 + 1, "if a && b { c() }");
    let straight = planted(BRANCHES / 2, "if a && b { c() }");
    for (text, wanted) in [
        (format!("fn f() {long}"), 1),
        (format!("fn f() {short}"), 0),
        (format!("fn f() {branched}"), 1),
        (format!("fn f() {straight}"), 0),
        (
            format!("impl A {{ pub const fn f(x: [u8; 3]) -> u8 {long} }}"),
            1,
        ),
        (
            format!("// long: one list, read from above\nfn f() {long}"),
            0,
        ),
        (
            format!("// long: one list, read from above\n/// Words.\n#[cold]\nfn f() {long}"),
            0,
        ),
        (format!("// long:\nfn f() {long}"), 1),
        (format!("// long: because\nfn f() {long}"), 1),
        (
            format!("// long: one list, read from above\n\nfn f() {long}"),
            1,
        ),
        (
            format!("// long: one list, read from above\nfn f() {short}"),
            1,
        ),
        (
            format!("fn f() {short}\n#[cfg(test)]\nmod tests {{ fn g() {long} }}"),
            0,
        ),
        (format!("trait A {{ fn f(); fn g() {long} }}"), 1),
    ] {
        let found = violations("planted.rs", &text);
        assert_eq!(found.len(), wanted, "{text}: {found:?}");
    }
}

#[test]
fn branches_are_counted_as_a_reader_would() {
    for (body, wanted) in [
        ("if a { b } else if c { d } else { e }", 2),
        ("match a { 1 => b, 2 | 3 => c, _ => d }", 3),
        ("a && b || c", 2),
        ("a.map(|| b).or_else(|| c)", 0),
        ("f(&&a, |&&b| b)", 0),
        ("a?.b()?; fn g<T: ?Sized>() {}", 2),
        ("let Some(a) = b else { return };", 1),
        ("for a in b { while c {} }", 2),
        ("let f: for<'a> fn(&'a str) = g;", 0),
        ("// if a && b\n\"if a && b\"", 0),
    ] {
        let found = functions(&format!("fn f() {{ {body} }}"));
        assert_eq!(found[0].branches, wanted, "{body}");
    }
}
