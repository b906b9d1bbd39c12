package sunbeam.app.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class MeanwhileTest {
    @Test
    void isWorkedOutBesideItsCaller() {
        CountDownLatch caller = new CountDownLatch(1);
        Meanwhile<Integer> meanwhile = Meanwhile.start(() -> {
            await(caller);
            return 7;
        });
        caller.countDown();
        assertEquals(7, meanwhile.get());
    }

    @Test
    void throwsWhatTheWorkThrew() {
        IllegalStateException problem = new IllegalStateException("a patch that cannot be drawn");
        Meanwhile<Integer> meanwhile = Meanwhile.start(() -> {
            throw problem;
        });
        meanwhile.settle();
        assertSame(problem, assertThrows(IllegalStateException.class, meanwhile::get));
    }

    @Test
    void aShortageOfMemoryStaysOne() {
        Meanwhile<Integer> meanwhile = Meanwhile.start(() -> {
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
