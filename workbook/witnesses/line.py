"""Messages between two processes, over pipes."""

import pickle
import threading
from contextlib import suppress
from queue import SimpleQueue
from typing import Any


class Line:
    """Messages to another process and from it; a thread listens, so that neither waits while the other speaks."""

    def __init__(self, heard: Any, said: Any) -> None:
        self._heard, self._said = heard, said
        self._messages: SimpleQueue[bytes | None] = SimpleQueue()
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        with suppress(OSError, ValueError):
            while len(head := self._heard.read(8)) == 8:
                size = int.from_bytes(head, "big")
                message = self._heard.read(size)
                if len(message) < size:
                    break
                self._messages.put(message)
        self._messages.put(None)

    def say(self, message: Any) -> None:
        """Send a message; raise OSError where nobody listens any more."""
        data = pickle.dumps(message, pickle.HIGHEST_PROTOCOL)
        self._said.write(len(data).to_bytes(8, "big") + data)
        self._said.flush()

    @property
    def waits(self) -> bool:
        """Whether a message has come that was not heard yet, or none will come any more."""
        return not self._messages.empty()

    def hear(self) -> Any:
        """Return the next message; raise EOFError where none will come any more."""
        data = self._messages.get()
        if data is None:
            self._messages.put(None)
            raise EOFError
        return pickle.loads(data)  # from a process that this one has started, or was started by
