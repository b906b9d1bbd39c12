package sunbeam.app.scene.mesh.format;

import static de.javagl.jgltf.model.GltfConstants.GL_BYTE;
import static de.javagl.jgltf.model.GltfConstants.GL_FLOAT;
import static de.javagl.jgltf.model.GltfConstants.GL_SHORT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_BYTE;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_INT;
import static de.javagl.jgltf.model.GltfConstants.GL_UNSIGNED_SHORT;

import de.javagl.jgltf.impl.v2.Accessor;
import de.javagl.jgltf.impl.v2.AccessorSparse;
import de.javagl.jgltf.impl.v2.BufferView;
import de.javagl.jgltf.impl.v2.GlTF;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Map;
import sunbeam.app.files.input.InputException;

/** Reads accessors of glTF 2.0 (its section 3.6.2): dense and sparse ones, of all types of numbers. */
final class GltfAccessors {
    private static final int MOST = 3 * MeshLimits.MOST;
    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4);

    private final Path file;
    private final GlTF gltf;
    private final GltfBuffers buffers;

    GltfAccessors(Path file, GlTF gltf, GltfBuffers buffers) {
        this.file = file;
        this.gltf = gltf;
        this.buffers = buffers;
    }

    /** Number of elements, at most three times {@link MeshLimits#MOST}. */
    int count(Integer index) {
        Integer count = accessor(index).getCount();
        if (count == null || count < 1 || count > MOST) {
            throw wrong(index, "has " + count + " elements; 1 to " + MOST + " can be used, so simplify the mesh");
        }
        return count;
    }

    /**
     * All numbers of an accessor, those of an element beside each other.
     *
     * @param components of an element
     */
    double[] read(Integer index, int components) throws IOException {
        Accessor accessor = accessor(index);
        if (!Integer.valueOf(components).equals(COMPONENTS.get(String.valueOf(accessor.getType())))) {
            throw wrong(index, "has not " + components + " numbers each; export it again");
        }
        double[] values = new double[components * count(index)];
        if (accessor.getBufferView() != null) {
            BufferView view = buffers.entry(gltf.getBufferViews(), accessor.getBufferView(), "buffer view");
            int offset = accessor.getByteOffset() == null ? 0 : accessor.getByteOffset();
            Numbers numbers = numbers(index, accessor.getComponentType(), view, offset, components, count(index));
            for (int i = 0; i < values.length; i++) {
                values[i] = numbers.get(i / components, i % components);
            }
        }
        if (accessor.getSparse() != null) {
            substitute(index, accessor, values, components);
        }
        normalize(accessor, values);
        return values;
    }

    private void substitute(Integer index, Accessor accessor, double[] values, int components) throws IOException {
        AccessorSparse sparse = accessor.getSparse();
        Integer count = sparse.getCount();
        int elements = values.length / components;
        if (count == null
                || count < 1
                || count > elements
                || sparse.getIndices() == null
                || sparse.getValues() == null) {
            throw wrong(index, "has sparse values that cannot be understood; export it again");
        }
        BufferView places =
                buffers.entry(gltf.getBufferViews(), sparse.getIndices().getBufferView(), "buffer view");
        BufferView content =
                buffers.entry(gltf.getBufferViews(), sparse.getValues().getBufferView(), "buffer view");
        Numbers at = numbers(
                index,
                sparse.getIndices().getComponentType(),
                places,
                offset(sparse.getIndices().getByteOffset()),
                1,
                count);
        Numbers numbers = numbers(
                index,
                accessor.getComponentType(),
                content,
                offset(sparse.getValues().getByteOffset()),
                components,
                count);
        for (int i = 0; i < count; i++) {
            double place = at.get(i, 0);
            if (!(place >= 0 && place < elements)) {
                throw wrong(index, "has a sparse value for element " + (long) place + "; export it again");
            }
            for (int component = 0; component < components; component++) {
                values[components * (int) place + component] = numbers.get(i, component);
            }
        }
    }

    private static int offset(Integer given) {
        return given == null ? 0 : given;
    }

    /** Whole numbers that stand for shares of 1. */
    private static void normalize(Accessor accessor, double[] values) {
        if (!Boolean.TRUE.equals(accessor.isNormalized()) || accessor.getComponentType() == GL_FLOAT) {
            return;
        }
        double one = switch (accessor.getComponentType()) {
            case GL_BYTE -> Byte.MAX_VALUE;
            case GL_UNSIGNED_BYTE -> 255;
            case GL_SHORT -> Short.MAX_VALUE;
            case GL_UNSIGNED_SHORT -> 65535;
            default -> 1;
        };
        for (int i = 0; i < values.length; i++) {
            values[i] = Math.max(-1, values[i] / one);
        }
    }

    /** Numbers within a buffer view. */
    private record Numbers(ByteBuffer bytes, int type, int offset, int stride) {
        double get(int element, int component) {
            int at = offset + element * stride + component * size(type);
            return switch (type) {
                case GL_BYTE -> bytes.get(at);
                case GL_UNSIGNED_BYTE -> Byte.toUnsignedInt(bytes.get(at));
                case GL_SHORT -> bytes.getShort(at);
                case GL_UNSIGNED_SHORT -> Short.toUnsignedInt(bytes.getShort(at));
                case GL_UNSIGNED_INT -> Integer.toUnsignedLong(bytes.getInt(at));
                default -> bytes.getFloat(at);
            };
        }
    }

    /** Bytes of a number; 0 for no type. */
    private static int size(Integer type) {
        return switch (type == null ? 0 : type) {
            case GL_BYTE, GL_UNSIGNED_BYTE -> 1;
            case GL_SHORT, GL_UNSIGNED_SHORT -> 2;
            case GL_UNSIGNED_INT, GL_FLOAT -> 4;
            default -> 0;
        };
    }

    private Numbers numbers(Integer index, Integer type, BufferView view, int offset, int components, int count)
            throws IOException {
        int bytes = size(type) * components;
        ByteBuffer all = buffers.view(view);
        int stride = view.getByteStride() == null ? bytes : view.getByteStride();
        long end = offset + (long) stride * (count - 1) + bytes;
        if (bytes == 0 || offset < 0 || stride < bytes || end > all.limit()) {
            throw wrong(
                    index,
                    "needs " + end + " bytes of a buffer view that has " + all.limit()
                            + "; copy it again with its files");
        }
        return new Numbers(all, type, offset, stride);
    }

    private Accessor accessor(Integer index) {
        return buffers.entry(gltf.getAccessors(), index, "accessor");
    }

    private InputException wrong(Integer index, String what) {
        return new InputException(file + ": accessor " + index + " " + what);
    }
}
