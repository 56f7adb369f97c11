//! The server from outside: who is answered, what is sent, and how attacks fail.

mod beside;
mod endless;
mod files;
mod guard;
mod mutations;
mod places;
mod running;

use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use self::running::{LIMITS, Running, events};
use grazing_explore::Limits;
use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_results::Dimensioned;
use grazing_unfold::Diagram;
use grazing_unfold::described::Prepared;
use grazing_unfold::plane;
use grazing_unfold::progress::Silent;
use serde_json::{Value, json};

fn whole_view() -> Value {
    json!({"primary": [0.0, 1.3], "secondary": [0.35, 1.02]})
}

/// The Duffing oscillator in ranges with one resonance.
fn narrow() -> (String, Value) {
    let text = include_str!("../../../../../examples/duffing.toml").to_owned();
    (text, json!({"primary": [0.2, 0.4], "secondary": [0.95, 1.0]}))
}

#[test]
fn only_the_page_itself_is_answered() {
    let server = Running::new(LIMITS);
    let path = server.path.clone();
    assert_eq!(server.get(&path), 200);
    assert_eq!(server.get(&format!("{path}examples")), 200);
    for other in [
        "/",
        "/examples",
        &path.to_uppercase(),
        &path[..path.len() - 2],
        &format!("{path}../../etc/passwd"),
        &format!("{path}..%2f..%2fetc%2fpasswd"),
        &format!("{path}./Cargo.toml"),
        &format!("{path}diagram"),
    ] {
        assert_eq!(server.get(other), 404, "{other}");
    }
    let with = |host: &str, more: &str| {
        let request = format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{more}\r\n");
        server.ask(request.as_bytes()).0
    };
    let own = server.address.to_string();
    assert_eq!(with(&own, ""), 200);
    assert_eq!(with("example.org", ""), 403);
    assert_eq!(with(&own, "Origin: http://example.org\r\n"), 403);
    assert_eq!(with(&own, "Sec-Fetch-Site: cross-site\r\n"), 403);
    assert_eq!(with(&own, &format!("Host: {own}\r\n")), 403);
    assert_eq!(with(&own, "Host: example.org\r\n"), 403);
    let (_, head, _) = server.ask(server.head("GET", &path, "").as_bytes());
    for wanted in ["content-security-policy: default-src 'none';", "x-content-type-options: nosniff"] {
        assert!(head.contains(wanted), "{head}");
    }
}

#[test]
fn requests_that_are_wrong_or_too_large_are_refused_with_a_reason() {
    let server = Running::new(LIMITS);
    let refused = |name: &str, body: &str, status: u16| {
        let (found, told) = server.post(name, body);
        assert_eq!(found, status, "{name}: {told}");
        let told: Value = told.parse().unwrap();
        assert!(told["message"].as_str().is_some_and(|message| !message.is_empty()));
    };
    refused("check", "", 400);
    refused("check", "{\"text\": 1}", 400);
    refused("place", "{\"model\": {\"text\": null}, \"at\": [0.1]}", 400);
    refused("place", "{\"model\": {\"text\": \"name = 1\"}, \"at\": [0.1, 0.2]}", 422);
    refused("place", "{\"model\": {\"text\": null}, \"at\": [null, 0.2]}", 400);
    refused("check", &format!("{{\"text\": \"{}\"}}", "a".repeat(LIMITS.body)), 413);
    refused("nothing", "{}", 404);
    refused(
        "export",
        &json!({"model": {"text": null}, "view": whole_view(), "what": "exe"}).to_string(),
        422,
    );
    let tiles =
        json!({"model": {"text": null}, "view": whole_view(), "columns": 100_000, "rows": 9, "periods": 9});
    let (status, told) = server.post("tiles", &tiles.to_string());
    assert!(status == 200 && events(&told, "error").len() == 1, "{told}");
    // The server does not wait for a hundred megabytes.
    let head = server.head(
        "POST",
        &format!("{}check", server.path),
        "Content-Type: application/json\r\nContent-Length: 100000000\r\n",
    );
    assert!([0, 413].contains(&server.ask(&[head.as_bytes(), &vec![b' '; 10_000_000]].concat()).0));
    // A form of a foreign page can send text, but not this type.
    let form = server.head(
        "POST",
        &format!("{}check", server.path),
        "Content-Type: text/plain\r\nContent-Length: 2\r\n",
    );
    assert_eq!(server.ask(format!("{form}{{}}").as_bytes()).0, 415);
    // Some of this is the beginning of a request, for which the server does not wait for ever.
    let server = Running::new(Limits { patience: Duration::from_millis(500), ..LIMITS });
    for garbage in ["\r\n\r\n", "GET\r\n\r\n", "\u{0}\u{1}\u{2}\r\n\r\n", "GET / HTTP/9.9\r\n\r\n"] {
        assert!([0, 400, 505].contains(&server.ask(garbage.as_bytes()).0), "{garbage:?}");
    }
    // On a busy machine a correct request may be too slow to be read, but not every time.
    assert!((0..100).any(|_| server.get(&server.path) == 200));
}

#[test]
fn many_requests_and_connections_that_say_nothing_bring_nothing_down() {
    let server = Running::new(Limits { patience: Duration::from_secs(2), ..LIMITS });
    let silent: Vec<TcpStream> = (0..40).map(|_| server.connect()).collect();
    let body = json!({"model": {"text": null}, "at": [0.3, 0.8], "states": 4}).to_string();
    let (served, refused) = (AtomicUsize::new(0), AtomicUsize::new(0));
    thread::scope(|scope| {
        for _ in 0..200 {
            scope.spawn(|| match server.post("place", &body) {
                (200, answer) => {
                    assert!(answer.contains("\"attractors\""));
                    served.fetch_add(1, Ordering::Relaxed);
                }
                (0 | 503, _) => drop(refused.fetch_add(1, Ordering::Relaxed)),
                (status, answer) => panic!("{status}: {answer}"),
            });
        }
    });
    let (served, refused) = (served.into_inner(), refused.into_inner());
    assert!(served + refused == 200 && served > 0, "{served} {refused}");
    // Connections that send nothing are closed after a while.
    for mut stream in silent {
        assert_eq!(stream.read(&mut [0; 1]).unwrap_or(0), 0);
    }
    // On a busy machine a correct request may be too slow to be read, but not every time.
    assert!((0..100).any(|_| server.post("place", &body).0 == 200));
}

#[test]
fn what_nobody_waits_for_makes_room_and_lets_the_server_end() {
    let server = Running::new(Limits { computations: 1, ..LIMITS });
    let (text, _) = narrow();
    let long = json!({"model": {"text": text}, "view": {"primary": [0.0, 1.5], "secondary": [0.4, 1.1]},
                      "columns": 1000, "rows": 1000, "periods": 5000})
    .to_string();
    // The computation would take hours.
    let begun = || {
        let mut stream = server.begin("tiles", &long);
        let mut first = [0; 64];
        assert!(stream.read(&mut first).unwrap() > 0);
        stream
    };
    drop(begun());
    let body = json!({"model": {"text": null}, "at": [0.1, 0.8], "states": 2}).to_string();
    assert_eq!(server.post("place", &body).0, 200);
    let _waited_for = begun();
    drop(server);
}

#[test]
fn a_process_that_grows_too_large_ends_what_it_computes_and_goes_on() {
    // It grows by more than a computation may each time that it is looked at.
    let looks = AtomicUsize::new(0);
    let held = move || Some(2.0 * LIMITS.memory * looks.fetch_add(1, Ordering::Relaxed) as f64);
    let server = Running::with_memory(LIMITS, held);
    let (text, _) = narrow();
    let view = json!({"primary": [0.0, 1.5], "secondary": [0.4, 1.1]});
    let asked =
        json!({"model": {"text": text}, "view": view, "columns": 1000, "rows": 1000, "periods": 5000});
    let (status, stream) = server.post("tiles", &asked.to_string());
    assert_eq!((status, events(&stream, "error").len(), events(&stream, "done").len()), (200, 1, 0));
    assert!(events(&stream, "error")[0]["message"].as_str().unwrap().contains("memory"), "{stream}");
    assert_eq!(server.get(&server.path), 200);
    // Memory that was freed may stay with the process, and then ends nothing.
    let server = Running::with_memory(LIMITS, || Some(2.0 * LIMITS.memory));
    let body = json!({"model": {"text": null}, "at": [0.3, 0.8], "states": 4}).to_string();
    assert_eq!(server.post("place", &body).0, 200);
}

#[test]
fn thousands_of_keys_are_refused_by_their_number_and_one_unknown_key_by_its_name() {
    let server = Running::new(Limits { body: 200_000, ..LIMITS });
    let checked = |count: usize| {
        let set: BTreeMap<String, f64> = (0..count).map(|key| (format!("k{key}"), 1.0)).collect();
        let (status, told) = server.post("check", &json!({"text": null, "set": set}).to_string());
        assert_eq!(status, 200, "{told}");
        told
    };
    assert!(checked(12_000).contains("12000 values are set: at most 1000"));
    assert!(checked(1).contains("parameters.k0"));
    // A name of a hundred thousand letters is compared with none.
    let body = json!({"text": format!("{} = 1", "k".repeat(150_000))}).to_string();
    let (status, told) = server.post("check", &body);
    assert!(status == 200 && told.len() < 10_000, "{status} {}", told.len());
}

#[test]
fn whoever_opens_connections_without_the_token_does_not_keep_the_page_away() {
    let server = Running::new(LIMITS);
    let mut known = server.connect();
    let begin = server.head("GET", &server.path, "").replace("Connection: close\r\n", "");
    known.write_all(begin.as_bytes()).unwrap();
    assert!(known.read(&mut [0; 1]).unwrap() > 0);
    let _silent: Vec<TcpStream> = (0..2 * LIMITS.connections).map(|_| server.connect()).collect();
    assert_eq!(server.get(&server.path), 200);
    // A connection that has shown the token is not closed for others.
    known.write_all(server.head("GET", &server.path, "").as_bytes()).unwrap();
    let mut rest = String::new();
    known.read_to_string(&mut rest).unwrap();
    assert_eq!(rest.matches("TTP/1.1 200 OK").count(), 2, "{rest}");
}

#[test]
fn a_body_in_broken_pieces_is_a_bad_request() {
    let server = Running::new(LIMITS);
    let path = format!("{}check", server.path);
    let head = server.head("POST", &path, "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n");
    for pieces in ["xyz\r\n{}\r\n0\r\n\r\n", "2\r\n{}xx\r\n0\r\n\r\n"] {
        assert_eq!(server.ask(format!("{head}{pieces}").as_bytes()).0, 400, "{pieces:?}");
    }
    let large = format!("{:x}\r\n{}\r\n0\r\n\r\n", 2 * LIMITS.body, " ".repeat(2 * LIMITS.body));
    assert_eq!(server.ask(format!("{head}{large}").as_bytes()).0, 413);
}

#[test]
fn the_diagram_has_the_numbers_that_unfold_writes() {
    let server = Running::new(LIMITS);
    let (text, view) = narrow();
    let asked = json!({"model": {"text": text, "set": {"kappa": 0.11}, "loops": [3]}, "view": view});
    let (status, stream) = server.post("diagram", &asked.to_string());
    assert_eq!((status, events(&stream, "done").len()), (200, 1), "{stream}");

    let settings = ["parameters.kappa=0.11", "primary.range=[0.2, 0.4]", "secondary.range=[0.95, 1.0]"];
    let settings: Vec<_> = settings.iter().map(|setting| setting.parse().unwrap()).collect();
    let text = text.split("[[diagrams]]").next().unwrap();
    let text = grazing_input::Text::new(text, &settings);
    let description =
        Description::parse_with(&text, "test", &Stop::default()).unwrap().with_loops(&[3]).unwrap();
    let Prepared { oscillator, scope, axes, .. } = Prepared::of(&description, &Stop::default());
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    let rows = plane::curves(&diagram).with_dimensions(&axes.units);
    let wanted: Vec<[f64; 2]> = rows.iter().map(|row| [row.at.primary, row.at.secondary]).collect();
    // First the curves as they are found, then all of them, then approximations to them.
    let sent = events(&stream, "curves");
    let all = &sent[sent.len() - 2];
    let curves = all.as_array().unwrap().iter().flat_map(|curve| curve["points"].as_array().unwrap());
    let found: Vec<[f64; 2]> =
        curves.map(|point| [0, 1].map(|index| point[index].as_f64().unwrap())).collect();
    assert!(found == wanted, "the points differ");
    let vertices = plane::regions(&diagram.regions).len();
    let regions = &events(&stream, "regions")[0];
    let rings = regions.as_array().unwrap().iter().flat_map(|region| region["rings"].as_array().unwrap());
    assert_eq!(rings.map(|ring| ring.as_array().unwrap().len()).sum::<usize>(), vertices);
    // The early curves are among the final ones, under the same keys.
    let keys = |value: &Value| -> Vec<String> {
        value.as_array().unwrap().iter().map(|curve| curve["key"].as_str().unwrap().to_owned()).collect()
    };
    let last = keys(all);
    for early in &sent[..sent.len() - 2] {
        assert!(keys(early).iter().all(|key| last.contains(key)), "{early}");
    }
    // A diagram that is known is sent again, whole and at once.
    let (_, again) = server.post("diagram", &asked.to_string());
    assert!(events(&again, "progress").is_empty(), "{again}");
    assert!(events(&again, "curves") == sent[sent.len() - 2..], "{again}");
    for name in ["resonances", "points", "regions", "keys", "notes", "nothing"] {
        assert!(events(&again, name) == events(&stream, name), "{name}: {again}");
    }
}

#[test]
fn a_cut_tells_its_branches_first_and_then_what_simulation_comes_to() {
    let server = Running::new(LIMITS);
    let cut = json!({"model": {"text": null}, "fixed": "secondary", "at": 0.8, "range": [0.1, 0.9]});
    let (status, answer) = server.post("cut", &cut.to_string());
    assert_eq!((status, events(&answer, "done").len()), (200, 1), "{answer}");
    assert!(answer.find("event: branches") < answer.find("event: dots"));
    let branches = &events(&answer, "branches")[0];
    assert!(branches["strands"].as_array().is_some_and(|strands| strands.len() >= 2));
    let grazing = branches["bifurcations"].as_array().unwrap().iter().filter(|found| found["kind"] == "graz");
    assert_eq!(grazing.count(), 1);
    let dots = &events(&answer, "dots")[0]["dots"];
    assert!(dots.as_array().is_some_and(|dots| dots.len() > 160), "{dots}");
    // A line at zero is like any other, and one-parameter diagrams in the file do not matter,
    // wherever they are in it.
    let (text, _) = narrow();
    let (before, diagrams) = text.split_once("[[diagrams]]").unwrap();
    let (head, analysis) = before.split_once("[analysis]").unwrap();
    let moved = format!("{head}[[diagrams]]{diagrams}\n[analysis]{analysis}");
    let cut =
        json!({"model": {"text": moved, "loops": [1]}, "fixed": "primary", "at": 0.0, "range": [0.9, 1.0]});
    let (status, answer) = server.post("cut", &cut.to_string());
    assert_eq!((status, events(&answer, "done").len()), (200, 1), "{answer}");
}

#[test]
fn a_place_and_a_cut_call_neutral_what_is_neither_stable_nor_unstable() {
    // Few steps are enough for branches; simulation, which takes long without damping, is cut off.
    let server = Running::new(Limits { steps: 300_000, ..LIMITS });
    let text = "name = \"elastic\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 0.5]\n[secondary]\nname = \"w\"\nrange = [0.7, 0.9]\n\
                [motion]\nforce = \"-(x + 1) + A*cos(w*t)\"\nfrequency = \"w\"\n[impact]\nrestitution = \"1\"\nduration = \"0\"\n\
                [analysis]\nloops = [1]\n";
    let nearby = json!({"solutions": [], "attractors": []});
    let place = json!({"model": {"text": text}, "at": [0.2, 0.8], "nearby": nearby});
    let (status, answer) = server.post("place", &place.to_string());
    assert_eq!(status, 200, "{answer}");
    let answer: Value = answer.parse().unwrap();
    let words = |p: u32| -> Vec<&str> {
        let own = answer["solutions"].as_array().unwrap().iter().filter(|one| one["p"] == p);
        own.filter_map(|one| one["stable"].as_str()).collect()
    };
    assert_eq!(words(0), ["neutral"]);
    let cut = json!({"model": {"text": text}, "fixed": "secondary", "at": 0.8, "range": [0.1, 0.3]});
    let (status, answer) = server.post("cut", &cut.to_string());
    assert_eq!(status, 200, "{answer}");
    let strands = &events(&answer, "branches")[0]["strands"];
    let free = strands.as_array().unwrap().iter().find(|strand| strand["p"] == 0).unwrap();
    assert!(free["points"].as_array().unwrap().iter().all(|point| point[2] == "neutral"), "{free}");
}

#[test]
fn of_a_view_that_reaches_beyond_what_is_allowed_the_rest_is_computed() {
    let server = Running::new(LIMITS);
    let model = json!({"text": null, "loops": [1]});
    let view = json!({"primary": [0.0, 1.2], "secondary": [-0.5, 1.1]});
    let (status, stream) = server.post("diagram", &json!({"model": model, "view": view}).to_string());
    assert_eq!((status, events(&stream, "done").len()), (200, 1), "{stream}");
    let part = &events(&stream, "part")[0];
    let low = part["view"]["secondary"][0].as_f64().unwrap();
    assert!((0.06..0.1).contains(&low) && part["view"]["primary"] == view["primary"], "{part}");
    assert!(
        part["reason"].as_str().unwrap().starts_with("motion.frequency: the frequency is -0.5"),
        "{part}"
    );
    assert!(events(&stream, "regions")[0].as_array().is_some_and(|regions| regions.len() > 4));
    // Places keep their numbers, and those beyond have no motion.
    let tiles = json!({"model": model, "view": view, "columns": 2, "rows": 16, "periods": 12});
    let (_, stream) = server.post("tiles", &tiles.to_string());
    let cells = events(&stream, "tiles");
    let cells = cells.iter().flat_map(|lot| lot["cells"].as_array().unwrap());
    for cell in cells.clone() {
        let above = -0.5 + 1.6 * (cell[1].as_f64().unwrap() + 0.5) / 16.0 > low;
        assert_eq!(cell.as_array().unwrap().len(), if above { 6 } else { 2 }, "{cell}");
    }
    assert_eq!(cells.count(), 32);
    let cut = json!({"model": model, "fixed": "primary", "at": 0.9, "range": [-0.5, 1.1]});
    let (_, answer) = server.post("cut", &cut.to_string());
    let strands = events(&answer, "branches")[0]["strands"].clone();
    let least = strands.as_array().unwrap().iter().flat_map(|strand| strand["points"].as_array().unwrap());
    let least = least.map(|point| point[0].as_f64().unwrap()).fold(f64::INFINITY, f64::min);
    assert!(least >= low - 1e-9 && least < 0.3, "{least}");
    // Where nothing is valid that is said.
    let below = json!({"model": model, "view": {"primary": [0.0, 1.2], "secondary": [-0.5, -0.1]}});
    let (status, told) = server.post("diagram", &below.to_string());
    assert!(
        status == 200 && events(&told, "error")[0]["message"].as_str().unwrap().contains("motion.frequency"),
        "{told}"
    );
}

#[test]
fn where_motion_is_forgotten_within_a_period_a_note_says_so() {
    let server = Running::new(LIMITS);
    // Forced ten times more slowly than it swings, and damped.
    let (text, _) = narrow();
    let damped = text.replace(
        "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)",
        "100*(-0.14*v - x - zeta*kappa*x^3 - 1 + A*cos(omega*t))",
    );
    assert!(damped != text);
    let view = json!({"primary": [0.0, 2.0], "secondary": [0.95, 1.0]});
    let asked = json!({"model": {"text": damped, "loops": [1]}, "view": view, "coarse": true});
    let (status, stream) = server.post("diagram", &asked.to_string());
    assert_eq!((status, events(&stream, "done").len()), (200, 1), "{stream}");
    let notes = &events(&stream, "notes")[0];
    let words = "grazing curve: neighbouring motion is forgotten within a period throughout: nothing is resonant there";
    assert_eq!(*notes, json!([words]));
}

#[test]
fn a_strand_of_a_cut_is_broken_where_a_visit_is_not_known() {
    let server = Running::new(LIMITS);
    // Loops of the paper's oscillator that gain and lose a maximum as its frequency changes.
    let cut = json!({"model": {"text": null}, "fixed": "primary", "at": 0.6, "range": [0.3, 1.1]});
    let (status, answer) = server.post("cut", &cut.to_string());
    assert_eq!((status, events(&answer, "done").len()), (200, 1), "{answer}");
    let branches = &events(&answer, "branches")[0];
    let strands = branches["strands"].as_array().unwrap();
    let numbers = strands.iter().flat_map(|strand| strand["points"].as_array().unwrap());
    assert!(strands.len() > 5 && numbers.clone().count() > 500);
    assert!(numbers.clone().all(|point| point[1].is_f64()), "a place without a number is drawn at zero");
}
