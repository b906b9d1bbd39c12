package sunbeam.precompute.method;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.method.LevelBakers.Lazy;

class LazyTest {
    private final AtomicInteger made = new AtomicInteger();

    @Test
    void threadsThatNeedAValueAtOnceShareIt() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch goOn = new CountDownLatch(1);
        Lazy<Integer> lazy = new Lazy<>(() -> {
            begun.countDown();
            try {
                goOn.await();
            } catch (InterruptedException interrupted) {
                throw new IllegalStateException(interrupted);
            }
            return made.incrementAndGet();
        });
        ExecutorService threads = Executors.newFixedThreadPool(2);
        try {
            Future<Integer> first = threads.submit(lazy::get);
            begun.await();
            Future<Integer> second = threads.submit(lazy::get);
            goOn.countDown();
            assertThat(first.get()).isOne();
            assertThat(second.get()).isOne();
        } finally {
            threads.shutdownNow();
        }
    }

    @Test
    void afterAFailureTheNextTriesAgain() {
        Lazy<Integer> lazy = new Lazy<>(() -> {
            if (made.incrementAndGet() == 1) {
                throw new OutOfMemoryError("no room");
            }
            return made.get();
        });
        assertThatThrownBy(lazy::get).isInstanceOf(OutOfMemoryError.class);
        assertThat(lazy.get()).isEqualTo(2);
        assertThat(lazy.get()).isEqualTo(2);
    }
}
