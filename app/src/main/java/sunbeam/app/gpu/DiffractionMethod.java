package sunbeam.app.gpu;

import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.ShaderProgram;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;

/** A diffraction method on the GPU: what its shader file needs. It owns its textures. */
public interface DiffractionMethod extends AutoCloseable {

    /** Constants that the shaders are compiled with. */
    Map<String, String> defines();

    /** Sets the method's uniforms of a program that was compiled with {@link #defines()}. */
    void setUniforms(ShaderProgram program);

    /** The method's textures, by sampler name. */
    List<Binding> bindings();

    /** Standard deviation of the coherence window, metres. */
    double windowSigma();

    /** DFT bins per cycle per metre along x, the patch's width in metres; 0 for a method without bins. */
    default double binsPerFrequencyX() {
        return 0;
    }

    /** DFT bins per cycle per metre along y, the patch's height in metres; 0 for a method without bins. */
    default double binsPerFrequencyY() {
        return 0;
    }

    /** |(u, v)| up to which a direction sees the specular peak, which outshines what is diffracted. */
    default double specularReach() {
        // The peak is as wide as the window's spectrum; five deviations of the longest wavelength hold all of it.
        return 5 * new CoherenceWindow(windowSigma()).sigmaFrequency() * CieTable.MAXIMUM_WAVELENGTH;
    }

    @Override
    void close();
}
