package sunbeam.app.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class BackgroundTaskTest {
    @Test
    void workRunsWhileTheCallerGoesOn() {
        CompletableFuture<Integer> fromCaller = new CompletableFuture<>();
        BackgroundTask<Integer> meanwhile = BackgroundTask.start(fromCaller::join);
        fromCaller.complete(7);
        assertEquals(7, meanwhile.get());
    }

    @Test
    void getThrowsTheExceptionOrErrorOfTheWork() {
        IllegalStateException problem = new IllegalStateException("a patch that cannot be drawn");
        BackgroundTask<Integer> failing = BackgroundTask.start(() -> {
            throw problem;
        });
        failing.settle();
        assertSame(problem, assertThrows(IllegalStateException.class, failing::get));
        BackgroundTask<Integer> full = BackgroundTask.start(() -> {
            throw new OutOfMemoryError("heights");
        });
        assertThrows(OutOfMemoryError.class, full::get);
    }
}
