//! `grazing explore` as it is started and ended.
#![cfg(unix)]

mod program;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};

use program::{empty_folder, grazing};

/// Asks for a path of the server and reads the answer.
fn ask(host: &str, request: &str) -> String {
    let mut stream = TcpStream::connect(host).expect("it listens");
    stream.write_all(request.as_bytes()).expect("it reads");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("it answers");
    answer
}

#[test]
fn the_address_is_printed_the_page_is_there_and_ctrl_c_ends_it() {
    let folder = empty_folder();
    let mut server = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["explore", "--no-browser"])
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut lines = BufReader::new(server.stdout.take().expect("it is ours")).lines();
    let address = lines.next().expect("a line").expect("it is text");
    let (host, path) =
        address.strip_prefix("http://").and_then(|rest| rest.split_once('/')).expect("an address");
    let head = format!("Host: {host}\r\nConnection: close\r\n");
    let page = ask(host, &format!("GET /{path} HTTP/1.1\r\n{head}\r\n"));
    assert!(
        page.starts_with("HTTP/1.1 200 ") && page.contains("<script type=\"module\" src=\"main.js\">"),
        "{page}"
    );
    // The numbers that are taken home are those that `reproduce` makes.
    let view = "{\"primary\": [0.0, 1.3], \"secondary\": [0.35, 1.02]}";
    let body = format!("{{\"model\": {{\"text\": null}}, \"view\": {view}, \"what\": \"csv:fig07_points\"}}");
    let more = format!("Content-Type: application/json\r\nContent-Length: {}\r\n", body.len());
    let taken = ask(host, &format!("POST /{path}export HTTP/1.1\r\n{head}{more}\r\n{body}"));
    let committed = include_str!("../../../figures/data/fig07_points.csv");
    assert!(taken.ends_with(committed), "{taken}");

    let interrupted = Command::new("kill").args(["-INT", &server.id().to_string()]).status();
    assert!(interrupted.is_ok_and(|status| status.success()));
    assert_eq!(server.wait().expect("it is ours").code(), Some(0));
}

#[test]
fn what_cannot_be_served_is_told_before_anything_is() {
    let folder = empty_folder();
    let refused = |arguments: &[&str]| {
        let outcome = grazing(folder.path(), arguments);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{}", outcome.messages);
        outcome.messages
    };
    assert!(refused(&["explore", "--no-browser", "missing.toml"]).contains("missing.toml: cannot be read"));
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let port = taken.local_addr().expect("it has an address").port().to_string();
    let told = refused(&["explore", "--no-browser", "--port", &port]);
    assert!(
        told.contains(&format!("port {port} of this machine cannot be had")) && told.contains("--port"),
        "{told}"
    );
}
