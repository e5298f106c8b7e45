"""Who may ask the server: the browser of this computer's user, and no page from elsewhere."""

import base64
import hashlib
import hmac
from collections.abc import Awaitable

from tornado.web import HTTPError, RequestHandler

from workbook.reports.html import STYLE

COOKIE = "motionbook"
STYLED = base64.b64encode(hashlib.sha256(STYLE.encode()).digest()).decode()
POLICY = (
    f"default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'sha256-{STYLED}'; img-src 'self'; "
    "form-action 'self'; frame-ancestors 'none'; base-uri 'none'"
)


class Guarded(RequestHandler):
    """A handler that answers only to its own address and to who has the token of the first address.

    The Host is compared against DNS rebinding, the Origin of what is posted against pages from elsewhere.
    """

    def set_default_headers(self) -> None:
        """Let a browser load nothing from elsewhere, run no script but the server's own and keep no copy."""
        self.set_header("Content-Security-Policy", POLICY)
        self.set_header("X-Content-Type-Options", "nosniff")
        self.set_header("Referrer-Policy", "same-origin")  # without one, a form's post has no Origin
        self.set_header("Cache-Control", "no-store")

    def prepare(self) -> Awaitable[None] | None:
        """Refuse who has neither token nor cookie; exchange the token for a cookie."""
        hosts = self.settings["hosts"]
        if self.request.host not in hosts:
            raise HTTPError(403, reason="this server answers to its own address only")
        origin = self.request.headers.get("Origin")
        if self.request.method == "POST" and origin not in {f"http://{host}" for host in hosts}:
            raise HTTPError(403, reason="only this server's own pages may post to it")
        token = self.settings["token"]
        if hmac.compare_digest(self.get_cookie(COOKIE, "").encode(), token.encode()):
            return None
        given = self.get_query_argument("token", "")
        if self.request.method != "GET" or not hmac.compare_digest(given.encode(), token.encode()):
            raise HTTPError(403, reason="open the address that motionbook serve printed")
        self.set_cookie(COOKIE, token, httponly=True, samesite="Strict")
        self.redirect("/")
        return None

    def write_error(self, status_code: int, **kwargs: object) -> None:
        """Answer with the reason in one line of plain text."""
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(f"{status_code}: {self._reason}\n")
