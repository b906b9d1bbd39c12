package sunbeam.app.work;

import java.util.concurrent.CancellationException;
import sunbeam.precompute.work.Progress;

/** Cancels a job cooperatively. Thread-safe. */
public final class CancellationToken implements Progress {
    private volatile boolean isCancelled;

    public void cancel() {
        isCancelled = true;
    }

    public boolean isCancelled() {
        return isCancelled;
    }

    @Override
    public void step(long samples) {
        if (isCancelled) {
            throw new CancellationException("these tiles are not wanted now");
        }
    }
}
