package jrtr;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import jrtr.gl.FloatTarget;
import jrtr.gl.NeedsDisplay;
import jrtr.gl.RenderContext;
import jrtr.gl.ShaderProgram;
import jrtr.glsl.ShaderTexts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The process ends (by Ctrl-C, for instance) during a draw: the draw is finished, and no other begins. */
@NeedsDisplay
class EndWhileDrawingTest {
    @TempDir
    private Path folder;

    /** One thread draws and reads for about a second, then reads on; the other ends the process with status 7 during the first draw. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) throws InterruptedException {
            CountDownLatch drawing = new CountDownLatch(1);
            Thread artist = new Thread(() -> draw(drawing));
            artist.setDaemon(true);
            artist.start();
            drawing.await();
            // Until the thread is in the middle of reading, which waits for the picture: a second of a software
            // renderer.
            Thread.sleep(200);
            System.out.println("ending");
            System.exit(7);
        }

        private static void draw(CountDownLatch drawing) {
            String code = """
                    #version 330 core
                    out vec4 color;
                    void main() {
                        float sum = 0.0;
                        for (int step = 0; step < 60000; step++) { sum += sin(gl_FragCoord.x + sum); }
                        color = vec4(sum);
                    }
                    """;
            try (RenderContext context = RenderContext.offscreen();
                    FloatTarget target = context.createFloatTarget("pixels", FloatTarget.Spec.color(64, 64))) {
                ShaderProgram program = context.createFullScreenProgram(
                        ShaderTexts.of(Map.of("sum.frag", code)).load("sum.frag"));
                context.drawFullScreen(program, Map.of(), target, Tile.whole(64, 64));
                drawing.countDown();
                while (true) {
                    target.read(0);
                    System.out.println("read");
                }
            }
        }
    }

    @Test
    void theOperationUnderWayIsFinishedAndNoOtherBegins() throws Exception {
        OwnJvm ended = OwnJvm.run(Program.class, folder, Map.of(), "-Djava.awt.headless=true");

        assertThat(ended.exitCode()).isEqualTo(7);
        assertThat(ended.errors()).isEmpty();
        assertThat(ended.output().lines()).containsExactly("ending", "read");
    }
}
