"""A pool of Dask workers, of this machine or a cluster's; Dask is imported only for several tasks."""

import gc
import logging
import operator
import signal
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import Any, Self, TypeVar

import workbook
from workbook.errors import MotionbookError
from workbook.pool import THIS_PROCESS, Pool, WorkerDied, cores

T = TypeVar("T")
R = TypeVar("R")
MOST_JOBS = 61  # Windows waits for no more processes at once
# tasks between two collections of garbage: a command runs with the collector off
COLLECT_EVERY = 32
WAIT = "10s"  # for a scheduler
LOCAL = {
    "distributed.scheduler.allowed-failures": 0,  # a task whose worker died comes back, and is tried alone
    "distributed.worker.memory.terminate": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.target": False,
    "distributed.comm.timeouts.connect": WAIT,
}
LOGGERS = ("distributed", "distributed.client", "tornado", "tornado.application", "asyncio")
REMOTE = {"distributed.comm.retry.count": 0, "distributed.comm.timeouts.connect": WAIT}


class ClusterError(MotionbookError):
    """A cluster that cannot be reached, has no workers, or is gone."""


@contextmanager
def pool(jobs: int | None, scheduler: str | None) -> Iterator[Pool]:
    """Give a pool: this process for a job, processes for more, a cluster by its scheduler; raise ClusterError."""
    wanted = min(jobs or cores(), MOST_JOBS)
    if scheduler is None and wanted <= 1:
        yield THIS_PROCESS
        return
    import distributed  # noqa: F401 - it sets levels of its own when it is imported

    for name in LOGGERS:  # what matters of what Dask logs is reported in a line
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    with local(wanted) if scheduler is None else remote(scheduler) as client:
        yield Workers(client, scheduler or "")


@contextmanager
def local(jobs: int) -> Iterator[Any]:
    """Give a client of processes of this machine; they end with the block."""
    import dask
    from distributed import Client, LocalCluster, Security

    with (
        dask.config.set(LOCAL),
        LocalCluster(
            n_workers=jobs,
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",
            memory_limit=0,
            silence_logs=logging.CRITICAL,
            preload="workbook.cluster",
            security=Security.temporary(),  # keys in memory: who else is on this machine cannot hand in tasks
        ) as cluster,
        Client(cluster) as client,
    ):
        yield client


@contextmanager
def remote(scheduler: str) -> Iterator[Any]:
    """Give a client of a scheduler; raise ClusterError unless there are workers, all with this version of ours."""
    import asyncio

    import dask
    from distributed import Client

    with dask.config.set(REMOTE):
        try:
            asyncio.run(require_answer(scheduler))
            client = Client(scheduler, timeout=WAIT, set_as_default=False)
        except Exception as error:  # an address, a port, or what speaks there may be anything
            message = "no scheduler answers there; expected the address of one, such as tcp://10.0.0.1:8786"
            raise ClusterError(f"--scheduler {scheduler}: {message}") from error
        try:
            if not client.scheduler_info()["workers"]:
                raise ClusterError(f"--scheduler {scheduler}: it has no workers; expected one or more")
            message = client.run(operator.attrgetter("__version__"), workbook, on_error="return")
            for address, version in sorted(message.items()):
                if version != workbook.__version__:
                    there = f"motionbook {version}" if isinstance(version, str) else "no motionbook"
                    expected = f"expected {workbook.__version__}, as here"
                    raise ClusterError(f"--scheduler {scheduler}: the worker {address} has {there}; {expected}")
            yield client
        finally:
            with suppress(Exception):  # of a cluster that is gone
                client.close(timeout=1)


async def require_answer(scheduler: str) -> None:
    """Raise unless a scheduler answers in time: on a silent port Dask's client waits for minutes."""
    from asyncio import wait_for

    from dask.utils import parse_timedelta
    from distributed.core import rpc

    other = rpc(scheduler)
    try:
        await wait_for(other.identity(), parse_timedelta(WAIT))
    finally:
        await other.close_rpc()


class Workers(Pool):
    """The workers of a client; ``scheduler`` is the address of a cluster's."""

    def __init__(self, client: Any, scheduler: str) -> None:
        self.client, self.scheduler, self.distant = client, scheduler, bool(scheduler)

    @contextmanager
    def alone(self) -> Iterator[Self]:
        """Give a fresh process; of a cluster, which others use too, these workers."""
        if self.scheduler:
            yield self
            return
        with local(1) as client:
            yield type(self)(client, "")

    def each(self, function: Callable[..., R], tasks: Iterable[T], *shared: Any) -> Iterator[tuple[T, R | WorkerDied]]:
        """Yield each task with its result; at most a task more than there are workers is handed out."""
        from distributed import as_completed

        info = self.client.scheduler_info(n_workers=-1)["workers"]
        most = 1 + max(1, sum(int(worker["nthreads"]) for worker in info.values()))
        waiting, running, count = iter(tasks), dict[str, T](), 0
        finished = as_completed([], loop=self.client.loop, raise_errors=False)

        def hand_out() -> None:
            while len(running) < most and (task := next(waiting, None)) is not None:
                future = self.client.submit(without_recursion_error, function, task, *shared, pure=False)
                running[future.key] = task
                finished.add(future)

        try:
            hand_out()
            while running:
                future = next(finished)
                task, came = running.pop(future.key), self._came(future)
                future.release()
                del future
                hand_out()
                count += 1
                if not count % COLLECT_EVERY:
                    gc.collect()
                yield task, came
        finally:
            finished.clear()

    def _came(self, future: Any) -> Any:
        """Return the result of a task; raise ClusterError where the scheduler is gone."""
        from concurrent.futures import CancelledError

        from distributed import KilledWorker

        try:
            return future.result()
        except KilledWorker:
            return WorkerDied()
        except (CancelledError, TimeoutError, OSError) as error:
            if future.status == "error":
                raise
            where = f" {self.scheduler}" if self.scheduler else ""
            raise ClusterError(f"the scheduler{where} is gone, or it was told to stop") from error


def without_recursion_error(function: Callable[..., R], *arguments: Any) -> R:
    """Call a function; raise RuntimeError for too deep a recursion, as Dask hangs on a RecursionError."""
    try:
        return function(*arguments)
    except RecursionError as error:
        message = str(error)
    raise RuntimeError(message)


def dask_setup(_: Any) -> None:
    """Let a worker ignore Ctrl-C, which reaches every process of a terminal: the first of them handles it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
