//! Access: the token, and the headers that say from where a request comes.

use super::running::{LIMITS, Running};

#[test]
fn only_the_whole_token_opens_and_what_follows_is_handed_on() {
    let server = Running::new(LIMITS);
    let token = server.path.trim_matches('/');
    let status = |token: &str, rest: &str| server.get(&format!("/{token}/{rest}"));
    assert_eq!(status(token, "main.js"), 200);
    assert_eq!(status(token, ""), 200);
    assert_eq!(status(token, "main.jsx"), 404);
    for wrong in ["", "0", &token[1..], &token.to_uppercase().replace(char::is_numeric, "g")] {
        assert_eq!(status(wrong, "main.js"), 404, "{wrong}");
    }
    assert_ne!(server.path, Running::new(LIMITS).path);
}

#[test]
fn foreign_hosts_and_pages_are_refused() {
    let server = Running::new(LIMITS);
    let (own, other) = (server.address.port(), server.address.port() - 1);
    for (headers, status) in [
        (&["Host: 127.0.0.1:OWN"][..], 200),
        (&["Host: localhost:OWN", "Origin: http://localhost:OWN"], 200),
        (&["Host: localhost:OWN", "Sec-Fetch-Site: same-origin"], 200),
        (&[], 403),
        (&["Host: 127.0.0.1"], 403),
        (&["Host: 127.0.0.1:OTHER"], 403),
        (&["Host: example.org:OWN"], 403),
        (&["Host: 127.0.0.1:OWN.example.org"], 403),
        (&["Host: 127.0.0.1:OWN", "Origin: http://example.org"], 403),
        (&["Host: 127.0.0.1:OWN", "Origin: https://127.0.0.1:OWN"], 403),
        (&["Host: 127.0.0.1:OWN", "Origin: null"], 403),
        (&["Host: 127.0.0.1:OWN", "Sec-Fetch-Site: cross-site"], 403),
        (&["Host: 127.0.0.1:OWN", "Host: 127.0.0.1:OWN"], 403),
        (&["Host: 127.0.0.1:OWN", "Host: example.org:OWN"], 403),
        (&["Host: localhost:OWN", "Origin: http://localhost:OWN", "Origin: null"], 403),
    ] {
        let ports = |header: &&str| {
            header.replace("OWN", &own.to_string()).replace("OTHER", &other.to_string()) + "\r\n"
        };
        let headers: String = headers.iter().map(ports).collect();
        let request = format!("GET {} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n", server.path);
        assert_eq!(server.ask(request.as_bytes()).0, status, "{headers}");
    }
    // A target may name the server as well, and then has to name this one.
    for (target, status) in [
        (format!("http://127.0.0.1:{own}"), 200),
        (format!("http://localhost:{own}"), 200),
        ("http://example.org".to_owned(), 403),
        (format!("http://example.org:{own}"), 403),
        (format!("http://127.0.0.1:{other}"), 403),
        (format!("https://127.0.0.1:{own}"), 403),
        (format!("http://user@127.0.0.1:{own}"), 403),
    ] {
        let rest = format!("HTTP/1.1\r\nHost: 127.0.0.1:{own}\r\nConnection: close\r\n\r\n");
        let request = format!("GET {target}{} {rest}", server.path);
        assert_eq!(server.ask(request.as_bytes()).0, status, "{target}");
    }
}
