//! Who may ask: a program on this machine, or the page that this server gave to a browser.
//!
//! A browser sends requests of any page that it shows. What such a page cannot forge are the headers below. `Host` tells a
//! foreign name that was pointed at this machine from our own; `Origin` and `Sec-Fetch-Site` tell who wrote the page.

use super::wire::Request;

/// Refuses a request that a foreign page may have made: why, in one sentence.
pub fn check(request: &Request, port: u16) -> Result<(), String> {
    let own = ["127.0.0.1", "localhost", "[::1]"].map(|host| format!("{host}:{port}"));
    let host = request.only("Host").unwrap_or_default();
    if !own.iter().any(|known| known.eq_ignore_ascii_case(host)) {
        return Err(format!(
            "the Host of a request must be {}",
            own.join(" or ")
        ));
    }
    let same = format!("http://{host}");
    if !request
        .all("Origin")
        .all(|origin| origin.eq_ignore_ascii_case(&same))
    {
        return Err("the request comes from a page of another origin".to_owned());
    }
    let changes = !matches!(request.method.as_str(), "GET" | "HEAD");
    let foreign = |site: &str| !matches!(site, "same-origin" | "none");
    if changes && request.all("Sec-Fetch-Site").any(foreign) {
        return Err("the request comes from a page of another site".to_owned());
    }
    Ok(())
}
