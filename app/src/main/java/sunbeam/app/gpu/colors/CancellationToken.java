package sunbeam.app.gpu.colors;

import java.util.concurrent.CancellationException;

/** Cancels a job cooperatively. Thread-safe. */
public final class CancellationToken {
    private volatile boolean isCancelled;

    public void cancel() {
        isCancelled = true;
    }

    public boolean isCancelled() {
        return isCancelled;
    }

    /** @throws CancellationException once the job is canceled */
    void check() {
        if (isCancelled) {
            throw new CancellationException("these tiles are not wanted now");
        }
    }
}
