package sunbeam.app.gpu;

import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.ShaderProgram;
import sunbeam.precompute.plan.Average;

/** Method {@code gem}, for comparison only: a grating of which only the spacing is known (shaders/method/gem.glsl). */
public final class GemMethod implements DiffractionMethod {
    private final double spacing;
    private final double windowSigma;

    /**
     * @param spacing distance of the grating's lines in metres; they run along y
     * @param windowSigma standard deviation of the coherence window that the method takes no notice of, metres
     */
    public GemMethod(double spacing, double windowSigma) {
        this.spacing = spacing;
        this.windowSigma = windowSigma;
    }

    @Override
    public Map<String, String> defines() {
        return MethodDefines.of("gem", Average.COHERENT);
    }

    @Override
    public void setUniforms(ShaderProgram program) {
        program.set("gemSpacing", (float) spacing);
    }

    @Override
    public List<Binding> bindings() {
        return List.of();
    }

    @Override
    public double windowSigma() {
        return windowSigma;
    }

    @Override
    public void close() {
        // It holds no textures.
    }
}
