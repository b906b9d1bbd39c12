package sunbeam.app.gpu.colors;

import java.util.concurrent.CancellationException;
import sunbeam.precompute.colortable.ColorBaker;

/** Cancels a job cooperatively. Thread-safe. */
public final class CancellationToken implements ColorBaker.Token {
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
