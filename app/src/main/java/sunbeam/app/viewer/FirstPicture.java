package sunbeam.app.viewer;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import jrtr.GraphicsException;

/** Whether there has been a picture, and if there can be none, why. Thread-safe. */
final class FirstPicture {
    private final CountDownLatch known = new CountDownLatch(1);
    private final AtomicReference<String> obstacle = new AtomicReference<>();

    void came() {
        known.countDown();
    }

    /** Says why there is none; without effect once one has come. */
    void cannotCome(String why) {
        if (known.getCount() > 0) {
            obstacle.set(why);
            known.countDown();
        }
    }

    /**
     * Waits for it.
     *
     * @throws GraphicsException if it cannot come
     */
    void await() throws InterruptedException {
        known.await();
        if (obstacle.get() != null) {
            throw new GraphicsException(obstacle.get());
        }
    }
}
