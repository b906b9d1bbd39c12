package sunbeam.app.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class BackgroundTaskTest {
    @Test
    void workRunsOnAnotherThread() {
        CountDownLatch caller = new CountDownLatch(1);
        BackgroundTask<Integer> meanwhile = BackgroundTask.start(() -> {
            await(caller);
            return 7;
        });
        caller.countDown();
        assertEquals(7, meanwhile.get());
    }

    @Test
    void getThrowsTheExceptionOfTheWork() {
        IllegalStateException problem = new IllegalStateException("a patch that cannot be drawn");
        BackgroundTask<Integer> meanwhile = BackgroundTask.start(() -> {
            throw problem;
        });
        meanwhile.settle();
        assertSame(problem, assertThrows(IllegalStateException.class, meanwhile::get));
    }

    @Test
    void aShortageOfMemoryStaysOne() {
        BackgroundTask<Integer> meanwhile = BackgroundTask.start(() -> {
            throw new OutOfMemoryError("heights");
        });
        assertThrows(OutOfMemoryError.class, meanwhile::get);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
