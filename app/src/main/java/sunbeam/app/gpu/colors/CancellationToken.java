package sunbeam.app.gpu.colors;

import java.util.concurrent.CancellationException;

/** Says whether a job is still wanted. Thread-safe. */
public final class CancellationToken {
    private volatile boolean isCancelled;

    public void cancel() {
        isCancelled = true;
    }

    public boolean isCancelled() {
        return isCancelled;
    }

    /** @throws CancellationException once nobody wants the job any more */
    void check() {
        if (isCancelled) {
            throw new CancellationException("these tiles are not wanted now");
        }
    }
}
