package sunbeam.app.gpu;

import java.util.List;
import java.util.Map;
import jrtr.Binding;
import jrtr.ShaderProgram;

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

    @Override
    void close();
}
