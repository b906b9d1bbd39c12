package sunbeam.precompute.shader;

import java.util.Arrays;
import java.util.List;

/** Value of a uniform. */
public sealed interface UniformValue {

    /** {@code float}, {@code vec2}, {@code vec3} or {@code vec4}, by the number of components. */
    record Reals(List<Float> components) implements UniformValue {}

    /** {@code int}, {@code ivec2}, {@code ivec3} or {@code ivec4}, by the number of components. */
    record Integers(List<Integer> components) implements UniformValue {}

    static UniformValue reals(double... components) {
        return new Reals(
                Arrays.stream(components).mapToObj(value -> (float) value).toList());
    }

    static UniformValue integers(int... components) {
        return new Integers(Arrays.stream(components).boxed().toList());
    }
}
