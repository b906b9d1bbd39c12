package sunbeam.app.measure.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import jrtr.RenderContext;
import jrtr.gl.RenderContexts;
import org.junit.jupiter.api.Test;
import sunbeam.app.gpu.NeedsDisplay;

@NeedsDisplay
class ExtremesTest {
    /**
     * A bare mirror's spot beside grains of dust: the basis of the ensemble's powers left it out, as one bin of hundreds, and
     * was wrong by a third near the specular direction.
     */
    @Test
    void aMirrorWithAGrainOfDustKeepsItsTolerance() {
        List<Extreme> dust = Extreme.all().stream()
                .filter(extreme -> extreme.name().contains("dust"))
                .toList();
        StringWriter text = new StringWriter();

        int missed;
        try (RenderContext context = RenderContexts.offscreen()) {
            missed = new Extremes(context, new PrintWriter(text, true)).run(dust);
        }

        assertThat(missed).as("%s", text).isZero();
        assertThat(text.toString().lines().filter(line -> line.startsWith("| one grain")))
                .hasSize(4);
        // Two averages, power and colours, three tolerances.
        assertThat(text.toString()).contains("12 results, 0 missed");
    }
}
