package sunbeam.precompute.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.CoherenceWindow;

/**
 * Tables of a method's shader: constants, uniforms and arrays. Callers must not change the uniforms' components.
 *
 * @param shader file in shaders/method, without its ending
 * @param reals uniforms of type {@code float} or {@code vec2} to {@code vec4}, by the number of components
 * @param windowSigma standard deviation of the coherence window, meters
 * @param specularReach |(u, v)| up to which a direction sees the specular peak, which outshines diffracted light
 * @param trial result of the tables' validation; empty if they were not validated
 */
public record ShaderTables(
        String shader,
        Map<String, String> defines,
        Map<String, float[]> reals,
        Map<String, int[]> integers,
        List<TableArray> arrays,
        double windowSigma,
        double specularReach,
        String trial) {
    public long bytes() {
        return arrays.stream().mapToLong(array -> array.layout().bytes()).sum();
    }

    /** Returns the same tables, which report the finished share of all layers, 0..1, before each layer is computed or read. */
    public ShaderTables preceded(DoubleConsumer before) {
        double all = arrays.stream().mapToInt(array -> array.layout().layers()).sum();
        AtomicInteger done = new AtomicInteger();
        List<TableArray> preceded = arrays.stream()
                .map(array -> new TableArray(array.layout(), layer -> {
                    before.accept(Math.min(1, done.getAndIncrement() / all));
                    return array.layer(layer);
                }))
                .toList();
        return with(preceded);
    }

    ShaderTables with(List<TableArray> others) {
        return new ShaderTables(shader, defines, reals, integers, others, windowSigma, specularReach, trial);
    }

    public ShaderTables with(UnaryOperator<Builder> additions) {
        return additions.apply(new Builder(shader).all(this).trial(trial)).build(windowSigma, specularReach);
    }

    public static final class Builder {
        private final String shader;
        private final Map<String, String> defines = new TreeMap<>();
        private final Map<String, float[]> reals = new TreeMap<>();
        private final Map<String, int[]> integers = new TreeMap<>();
        private final List<TableArray> arrays = new ArrayList<>();
        private String trial = "";

        public Builder(String shader) {
            this.shader = shader;
        }

        public Builder define(String name, Object value) {
            defines.put(name, value.toString());
            return this;
        }

        public Builder reals(String name, double... components) {
            reals.put(name, Floats.of(components.length, i -> components[i]));
            return this;
        }

        public Builder integers(String name, int... components) {
            integers.put(name, components);
            return this;
        }

        public Builder array(TableArray array) {
            arrays.add(array);
            return this;
        }

        public Builder trial(String found) {
            trial = found;
            return this;
        }

        public Builder all(ShaderTables others) {
            defines.putAll(others.defines());
            reals.putAll(others.reals());
            integers.putAll(others.integers());
            arrays.addAll(others.arrays());
            return this;
        }

        public ShaderTables build(CoherenceWindow window) {
            return build(window.sigmaMeters(), window.specularReach(CieTable.MAXIMUM_WAVELENGTH));
        }

        public ShaderTables build(double windowSigma, double specularReach) {
            // See shaders/include/loops.glsl.
            integers("loopProbe", 2);
            return new ShaderTables(shader, defines, reals, integers, arrays, windowSigma, specularReach, trial);
        }
    }
}
