//! The replay page in a real browser: headless Chromium, without a network.
//!
//! Where no Chromium is installed the tests say that they were not run;
//! CORDON_REQUIRE_TOOLS=1 makes that a failure.
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::run;

/// The browser's program; `None` where there is none.
fn browser() -> Option<&'static str> {
    let works = |name: &&str| {
        Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success())
    };
    let found = ["chromium", "chromium-browser", "google-chrome"].into_iter().find(works);
    if found.is_none() {
        let required = std::env::var("CORDON_REQUIRE_TOOLS").is_ok_and(|v| v == "1");
        assert!(!required, "chromium is not installed, and CORDON_REQUIRE_TOOLS=1");
        eprintln!("not run: chromium is not installed");
    }
    found
}

/// Opens a page with these flags; what the browser prints on stdout.
fn open(browser: &str, page: &Path, hash: &str, flags: &[&str]) -> String {
    let profile = tempfile::tempdir().unwrap();
    let out = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"])
        .args(["--disable-component-update", "--no-first-run", "--virtual-time-budget=4000"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .args(flags)
        .arg(format!("file://{}#{hash}", page.display()))
        .output()
        .unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).unwrap()
}

/// The text of an element with this id, in a dumped document.
fn text_of(dom: &str, id: &str) -> String {
    let from = dom.find(&format!("id=\"{id}\"")).unwrap_or_else(|| panic!("no {id}"));
    let rest = &dom[from..];
    let rest = &rest[rest.find('>').unwrap() + 1..];
    rest[..rest.find('<').unwrap()].to_owned()
}

/// A page of the run with eps = 0.7, in a folder of its own.
fn unstable_page() -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    let file = page.display().to_string();
    let (code, out, _) =
        run(&["replay", "scenarios/paper-unstable.toml", "--duration", "15", "--out", &file]);
    assert_eq!((code, out), (0, format!("{file}\n")));
    (folder, page)
}

#[test]
fn the_page_is_one_file_that_loads_nothing() {
    let (_folder, page) = unstable_page();
    let html = fs::read_to_string(page).unwrap();
    for outside in ["http:", "https:", "src=", "@import", "url(", "<link", "fetch(", "XMLHttp"] {
        assert!(!html.contains(outside), "{outside}");
    }
    assert!(!html.contains("@RUN@") && !html.contains("@SCRIPT@"));
}

#[test]
fn a_title_cannot_break_out_of_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let (scenario, page) = (folder.path().join("s.toml"), folder.path().join("p.html"));
    let text = "title = \"</script><b>@RUN@ & 'x'\"\nstart = [0, 1, 12]\nweight = \"1/3\"\n[flight]\nduration = 1\n";
    fs::write(&scenario, text).unwrap();
    let (code, ..) =
        run(&["replay", &scenario.display().to_string(), "--out", &page.display().to_string()]);
    assert_eq!(code, 0);
    let html = fs::read_to_string(page).unwrap();
    assert!(html.contains("<title>&lt;/script&gt;&lt;b&gt;@RUN@ &amp; 'x'</title>"));
    assert_eq!(html.matches("</script>").count(), 2);
}

#[test]
fn the_page_shows_the_run_at_any_time() {
    let Some(browser) = browser() else { return };
    let (_folder, page) = unstable_page();
    let at = |t: &str| {
        let dom = open(browser, &page, &format!("t={t}"), &["--dump-dom"]);
        (text_of(&dom, "status"), dom)
    };
    let (status, dom) = at("0");
    assert!(
        status.starts_with("t = 0.00 s of 15.00 s; smallest gap 10.000 m (drones 0 and 1)"),
        "{status}"
    );
    assert!(
        status.ends_with("in order; height 0.00 m of 1.00 m; collisions so far: 0"),
        "{status}"
    );
    assert!(dom.contains("12.591 s: drones 1 and 2 collide"));
    assert!(text_of(&dom, "setup").contains("eps = 7/10, an update every 14 ticks of 1/20 s"));
    let (status, _) = at("12.65");
    assert!(
        status.contains("out of order: drones 1, 2; height 0.96 m of 1.00 m; collisions so far: 1"),
        "{status}"
    );
}

/// Buttons, slider and keys, pressed by a script that is put at the page's end.
#[test]
fn the_page_is_moved_by_hand() {
    let Some(browser) = browser() else { return };
    let (folder, page) = unstable_page();
    let key = |k: &str, shift: bool| {
        format!(
            "document.dispatchEvent(new KeyboardEvent('keydown', {{key: '{k}', shiftKey: {shift}, bubbles: true}}));"
        )
    };
    let time = |presses: String| -> (f64, String) {
        let html = fs::read_to_string(&page).unwrap();
        let moved = html.replace("</body>", &format!("<script>{presses}</script></body>"));
        let path = folder.path().join("moved.html");
        fs::write(&path, moved).unwrap();
        let dom = open(browser, &path, "", &["--dump-dom"]);
        let status = text_of(&dom, "status");
        let t = status.strip_prefix("t = ").and_then(|s| s.split(' ').next()).unwrap();
        (t.parse().unwrap(), dom)
    };
    let keys = [("ArrowRight", false), ("ArrowRight", false), ("ArrowRight", true)];
    let pressed: String = keys.iter().map(|(k, shift)| key(k, *shift)).collect();
    assert_eq!(time(pressed).0, 1.1);
    assert_eq!(time(key("End", false)).0, 15.0);
    assert_eq!(time(key("End", false) + &key("Home", false)).0, 0.0);
    assert_eq!(time(key("n", false)).0, 12.59);
    assert_eq!(time(key("End", false) + &key("n", false)).0, 15.0);
    let scrub = "const s = document.getElementById('time'); s.value = 7.5; s.dispatchEvent(new Event('input'));";
    assert_eq!(time(scrub.to_owned()).0, 7.5);
    let (t, dom) = time("document.getElementById('play').click();".to_owned());
    assert!(t > 0.5, "it plays: {t}");
    assert_eq!(text_of(&dom, "play"), "Pause");
    // On a button the space key is that button's, whichever it is.
    let on_button = "document.getElementById('theme').dispatchEvent(new KeyboardEvent('keydown', {key: ' ', bubbles: true}));";
    let (_, dom) = time(on_button.to_owned());
    assert_eq!(text_of(&dom, "play"), "Play", "the space key on another button plays nothing");
    let (t, dom) = time(key(" ", false) + &key(" ", false));
    assert!(t < 0.2 && text_of(&dom, "play") == "Play", "it pauses: {t}");
    let quick = key("+", false) + &key("+", false) + &key("+", false);
    let (fast, _) = time(quick + "document.getElementById('play').click();");
    assert!(fast > t + 5.0, "ten times as fast: {fast}");
    let (_, dom) = time(key("d", false));
    assert!(dom.contains("data-theme=\"dark\"") || dom.contains("data-theme=\"light\""));
}

/// A planar run: the plane in place of the line, distances in place of gaps; and the take-off.
#[test]
fn the_page_shows_the_plane_and_the_height() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let text = |path: &Path| path.display().to_string();
    let (run_file, page) = (at("run.csv"), at("page.html"));
    let start: Vec<String> = (0..16).map(|i| format!("{},{}", i % 4 * 10, i / 4 * 10)).collect();
    let (start, out) = (start.join(","), text(&run_file));
    let flags =
        ["cosim", "--protocol", "scenarios/own/grid.toml", "--eps", "1/5", "--start", &start];
    assert_eq!(run(&[&flags[..], &["--period", "4", "--out", &out]].concat()).0, 0);
    assert_eq!(run(&["replay", &out, "--out", &text(&page)]).0, 0);
    let dom = open(browser, &page, "t=6", &["--dump-dom"]);
    let status = text_of(&dom, "status");
    let expected = "t = 6.00 s of 25.00 s; smallest distance 4.360 m (drones 0 and 1); none touch; \
                    height 0.70 m of 1.00 m; collisions so far: 0";
    assert_eq!(status, expected);
    for words in ["Distance of the nearest two over time</h2>", "Collisions</h2>", ">touching<"] {
        assert!(dom.contains(words), "{words}");
    }
    assert!(!dom.contains("id=\"from-the-side\" aria-label=\"Drones from the side\" hidden"));
    let dom = open(browser, &page, "t=25", &["--dump-dom"]);
    let status = text_of(&dom, "status");
    assert!(status.contains("; touching: drones 0, 1, 2, 3, 4, 5, 6, 7, .."), "{status}");
    // Positions alone, without a companion: nothing is said of heights.
    fs::remove_file(at("run.csv.json")).unwrap();
    assert_eq!(run(&["replay", &out, "--out", &text(&page)]).0, 0);
    let dom = open(browser, &page, "t=6", &["--dump-dom"]);
    assert_eq!(text_of(&dom, "status"), expected.replace("height 0.70 m of 1.00 m; ", ""));
}

/// Every picture, control and list has a name; the slider says seconds; and at 400 px nothing is
/// wider than the page.
#[test]
fn the_page_can_be_used_without_seeing_it() {
    let Some(browser) = browser() else { return };
    let (folder, page) = unstable_page();
    let asked = "const named = (e) => e.getAttribute('aria-label') || e.textContent.trim() || e.closest('label');\
        const all = [...document.querySelectorAll('canvas:not([aria-hidden]), button, select, input, section, output, ol, ul')];\
        const unnamed = all.filter((e) => !named(e)).map((e) => e.outerHTML);\
        const frame = document.createElement('p'); frame.id = 'found';\
        document.body.append(frame);\
        document.body.style.width = '400px';\
        dispatchEvent(new Event('resize'));\
        const wide = [...document.querySelectorAll('body *')].filter((e) => e.getBoundingClientRect().right > document.body.getBoundingClientRect().right + 1);\
        frame.textContent = `${all.length} looked at; unnamed: ${unnamed.join()}; time: ${document.getElementById('time').getAttribute('aria-valuetext')}; wide: ${wide.map((e) => e.tagName).join()}.`;";
    let html = fs::read_to_string(&page).unwrap();
    let path = folder.path().join("asked.html");
    let script = format!("<script>{asked}</script></body>");
    fs::write(&path, html.replace("</body>", &script)).unwrap();
    let dom = open(browser, &path, "t=3", &["--dump-dom"]);
    let found = text_of(&dom, "found");
    let (count, rest) = found.split_once(" looked at; ").unwrap();
    assert!(count.parse::<usize>().unwrap() > 25, "{count}");
    assert_eq!(rest, "unnamed: ; time: 3.00 s; wide: .");
}

/// At 25 s the run has broken loose: what leaves the pictures is said, not drawn at their edges.
#[test]
fn what_leaves_the_scale_is_said() {
    let Some(browser) = browser() else { return };
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page.html");
    let args = ["replay", "scenarios/paper-unstable.toml", "--out", page.to_str().unwrap()];
    assert_eq!(run(&args).0, 0);
    let dom = open(browser, &page, "t=24", &["--dump-dom"]);
    let status = text_of(&dom, "status");
    let expected = "; beyond the picture, left: drone 2; beyond the picture, right: drones 1, 3";
    assert!(status.ends_with(expected), "{status}");
    let cut = "Cut at the edge of the picture: the gaps 0–1, 1–2, 2–3, 3–4.";
    assert_eq!(text_of(&dom, "cut"), cut);
    for name in ["0–1", "1–2", "2–3", "3–4"] {
        assert!(dom.contains(&format!("</canvas> {name}</li>")), "{name}");
    }
    let (_folder, page) = unstable_page();
    let dom = open(browser, &page, "t=1", &["--dump-dom"]);
    assert!(!text_of(&dom, "status").contains("beyond"));
}

#[test]
fn the_page_is_drawn_in_both_themes() {
    let Some(browser) = browser() else { return };
    let (folder, page) = unstable_page();
    let mut sizes = Vec::new();
    for theme in ["light", "dark"] {
        let shot = folder.path().join(format!("{theme}.png"));
        let flag = format!("--screenshot={}", shot.display());
        open(browser, &page, &format!("t=12.65&theme={theme}"), &[&flag, "--window-size=1200,900"]);
        let png = fs::read(shot).unwrap();
        assert!(png.starts_with(b"\x89PNG"));
        sizes.push(png);
    }
    assert!(sizes.iter().all(|png| png.len() > 20_000), "something is drawn");
    assert_ne!(sizes[0], sizes[1]);
}
