//! Access control, and the security headers of every answer.
//!
//! The server listens on the loopback interface alone, but every page in a browser can send
//! requests there. So the address has a random token in its path, which no other page can know; the
//! Host must be the server's own, since a foreign name could be made to resolve to this machine
//! (DNS rebinding); and a request from a page must come from the server's own.

use hyper::Uri;
use hyper::header::{self, HeaderMap, HeaderName, HeaderValue};

/// Random letters in the path of the address.
#[derive(Clone, Debug)]
pub(crate) struct Token(String);

/// The bytes of a token: too many to try.
const BYTES: usize = 16;

impl Token {
    /// A new random token.
    pub(crate) fn random() -> std::io::Result<Self> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes).map_err(std::io::Error::other)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    pub(crate) fn text(&self) -> &str {
        &self.0
    }

    /// The part of a path after the token; none if the token is wrong or missing.
    pub(crate) fn rest<'p>(&self, path: &'p str) -> Option<&'p str> {
        let (token, rest) = path.strip_prefix('/')?.split_once('/')?;
        // In constant time, which does not reveal how much of the token was right.
        let same = token.len() == self.0.len()
            && token.bytes().zip(self.0.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b)) == 0;
        same.then_some(rest)
    }
}

/// Whether a request may be answered: it is for this server, also by a target that names one, and comes
/// from its own page if it comes from one.
pub(crate) fn is_own(target: &Uri, headers: &HeaderMap, port: u16) -> bool {
    let own = ["127.0.0.1", "localhost", "[::1]"].map(|name| format!("{name}:{port}"));
    // If a header occurs twice, an intermediary may have read the other one.
    let single = |name: &str| headers.get_all(name).iter().count() <= 1;
    let text = |name: HeaderName| headers.get(name).map(|value| value.to_str().unwrap_or_default());
    let host = text(header::HOST).is_some_and(|host| own.iter().any(|own| own == host));
    let origin = text(header::ORIGIN)
        .is_none_or(|origin| own.iter().any(|own| origin.strip_prefix("http://") == Some(own)));
    let site = headers.get("sec-fetch-site").is_none_or(|site| site == "same-origin" || site == "none");
    let scheme = target.scheme_str().is_none_or(|scheme| scheme == "http");
    let authority =
        target.authority().is_none_or(|authority| own.iter().any(|own| own == authority.as_str()));
    scheme
        && authority
        && host
        && origin
        && site
        && ["host", "origin", "sec-fetch-site"].into_iter().all(single)
}

/// Adds the headers of every answer: nothing is loaded from elsewhere, nothing is stored, and no
/// page may show it in a frame.
pub(crate) fn headers(headers: &mut HeaderMap) {
    let all: [(HeaderName, &'static str); 6] = [
        (
            header::CONTENT_SECURITY_POLICY,
            "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; font-src 'self'; \
             form-action 'none'; base-uri 'none'; frame-ancestors 'none'",
        ),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::CACHE_CONTROL, "no-store"),
        (header::X_FRAME_OPTIONS, "DENY"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    ];
    for (name, value) in all {
        headers.insert(name, HeaderValue::from_static(value));
    }
}
